#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace wedgesim::reports {

/// A number or a word; nothing where it was not measured.
using Value = std::variant<std::monostate, std::int64_t, double, std::string>;
using Values = std::map<std::string, Value, std::less<>>;

/// A frame of a study: a rendered view of a scene, or a trace file.
struct FrameRow {
  std::string key;  // 32 hexadecimal digits: the hash of all that it is made from
  std::string
      label;  // unique in its study, "bunny" or "bunny-f12-320x240"; the trace is LABEL.wtrace
  std::string scene;           // without the view: what results over views are grouped by
  Values parameters;           // frame, width, height, light_scale, kind, light, depth
  std::uint64_t checksum = 0;  // of the trace
  std::int64_t wedges = 0;
  std::string failure;   // why there is no trace; its points then fail with the same message
  std::string pictures;  // scales of LABEL_z_reads, LABEL_li_writes, ...; empty without pictures
  double seconds = 0.0;  // to render it: timing
};

enum class PointState { done, failed, crashed, overtime };

/// One measurement: a configuration on a frame.
struct PointRow {
  std::string key;      // 32 hexadecimal digits: the hash of measure, configuration and trace
  std::string frame;    // label of its FrameRow
  std::string measure;  // "count" or "cycles"
  /// The whole effective configuration by dotted keys, "block.tile", "penumbra.lanes".
  Values configuration;
  PointState state = PointState::done;
  std::string message;   // of a point that is not done
  Values metrics;        // by metric names; the same in every run
  double seconds = 0.0;  // to measure it: timing, differs from run to run
};

/// One picture of a study that its page draws and its tables follow.
struct Plot {
  std::string kind;  // "line", "bar", "scatter"
  std::string title;
  std::string x, y;    // a metric, or a key of configuration or frame
  std::string series;  // what tells lines apart; may be empty
  bool operator==(const Plot&) const = default;
};

/// What a study file says; study_file.h reads it.
struct StudyHead {
  std::string name, title, question;
  std::string measure;               // "count", "cycles", or "both"
  std::vector<std::string> axes;     // dotted keys that differ between points, in the file's order
  std::vector<std::string> by;       // frame parameters, or "scene", that tables tell apart;
                                     // over all other frames they show median and percentiles
  std::vector<std::string> metrics;  // that its tables show
  std::vector<Plot> plots;
  bool modes_tables = false;  // Paper II's tables of both modes, scene by scene, in the summary
  bool claims = false;        // the papers' claims are held against it
  bool check_pixels = true;   // a pixel beyond its tolerance is a failure; else a result
  bool operator==(const StudyHead&) const = default;
};

/// A study's results, frames and points in the study's order.
struct Results {
  StudyHead study;
  std::vector<FrameRow> frames;
  std::vector<PointRow> points;
  std::int64_t points_planned = 0;  // more than there are if the study is unfinished, or a shard
};

/// What is known of a metric.
struct MetricInfo {
  std::string name, unit, description;
};

}  // namespace wedgesim::reports

#include "reports/runner/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <thread>
#include <tuple>

#include "reports/runner/store.h"
#include "reports/runner/value.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

// Guesses, measured once on one core: nanoseconds a pixel of the frame.
constexpr double kRenderNanoseconds = 900.0;
constexpr double kCountNanoseconds = 15.0;        // of many points in one walk
constexpr double kCountAloneNanoseconds = 200.0;  // of a point with formats of its own
constexpr double kCyclesNanoseconds = 60.0;
const std::string kRender = "render";

/// Seconds that something took, over all the pixels that it took them for.
struct Pace {
  double seconds = 0.0, pixels = 0.0;
  void add(double more_seconds, double more_pixels) {
    seconds += more_seconds;
    pixels += more_pixels;
  }
};

double pixels_of(const FrameRow& frame) {
  return number_of(find_value(frame.parameters, "width")).value_or(1.0) *
         number_of(find_value(frame.parameters, "height")).value_or(1.0);
}

/// What an earlier run left.
class Records {
 public:
  explicit Records(const RunOptions& options) {
    if (!std::filesystem::exists(results_path(options.folder))) return;
    const Stored stored = read_stored(options.folder);
    is_current_ = stored.sources == options.sources;
    std::map<std::string, double> pixels;
    for (const auto& [position, frame] : stored.frames) {
      pixels.emplace(frame.label, pixels_of(frame));
      keys_.emplace(frame.label, frame.key);
      if (!frame.failure.empty()) continue;
      on_frame_[{kRender, frame.label}].add(frame.seconds, pixels_of(frame));
      anywhere_[kRender].add(frame.seconds, pixels_of(frame));
    }
    for (const auto& [position, point] : stored.points) {
      done_.emplace(std::tuple(point.frame, point.measure, point.configuration), point.state);
      if (point.state != PointState::done) continue;
      on_frame_[{point.measure, point.frame}].add(point.seconds, pixels.at(point.frame));
      anywhere_[point.measure].add(point.seconds, pixels.at(point.frame));
    }
  }

  bool has_frame(const FrameRow& frame) const {
    const auto found = keys_.find(frame.label);
    return is_current_ && found != keys_.end() && found->second == frame.key;
  }
  bool is_done(const FrameRow& frame, const Configuration& configuration, bool retry) const {
    const auto found =
        done_.find(std::tuple(frame.label, configuration.measure_name(), configuration.values));
    return has_frame(frame) && found != done_.end() &&
           (found->second == PointState::done || !retry);
  }
  double render_seconds(const FrameRow& frame) const {
    return recorded(kRender, frame).value_or(1e-9 * kRenderNanoseconds * pixels_of(frame));
  }
  /// The seconds of a point, and whether they come from records.
  std::pair<double, bool> seconds(const FrameRow& frame, const Configuration& configuration) const {
    if (const auto seconds = recorded(configuration.measure_name(), frame)) return {*seconds, true};
    const double nanoseconds = configuration.measure == Measure::cycles ? kCyclesNanoseconds
                               : configuration.datapath == model::DatapathKind::exact
                                   ? kCountNanoseconds
                                   : kCountAloneNanoseconds;
    return {1e-9 * nanoseconds * pixels_of(frame), false};
  }

 private:
  // At the pace of this frame, else of all.
  std::optional<double> recorded(const std::string& what, const FrameRow& frame) const {
    const auto here = on_frame_.find({what, frame.label});
    const auto anywhere = anywhere_.find(what);
    if (anywhere == anywhere_.end()) return {};
    const Pace& pace = here != on_frame_.end() ? here->second : anywhere->second;
    return pace.seconds / pace.pixels * pixels_of(frame);
  }

  bool is_current_ = false;
  std::map<std::string, std::string> keys_;  // of frames
  std::map<std::tuple<std::string, std::string, Values>, PointState> done_;
  std::map<std::pair<std::string, std::string>, Pace>
      on_frame_;  // by measure or kRender, and label
  std::map<std::string, Pace> anywhere_;
};

}  // namespace

std::string dry_run(const Study& study, const RunOptions& options) {
  const Records records(options);
  std::string text;
  double seconds = 0.0;
  std::size_t points = 0, done = 0, recorded = 0, frames = 0;
  for (const auto& [frame, configurations] : points_by_frame(study, options.shard)) {
    const FrameRow& row = study.frames[frame].row;
    if (!records.has_frame(row)) {
      frames += 1;
      seconds += records.render_seconds(row);
    }
    for (const std::size_t i : configurations) {
      const Configuration& configuration = study.configurations[i];
      points += 1;
      text += point_name(row.label, configuration.measure_name(), configuration.values,
                         study.head.axes);
      if (records.is_done(row, configuration, options.retry)) {
        done += 1;
        text += ": there already\n";
        continue;
      }
      const auto [expected, is_recorded] = records.seconds(row, configuration);
      recorded += is_recorded ? 1 : 0;
      seconds += expected;
      text += fmt::format(": {:.2g} s\n", expected);
    }
  }
  const unsigned jobs =
      options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  text += fmt::format("{} points, {} there already; {} frames to render\n", grouped(points),
                      grouped(done), grouped(frames));
  const std::string source = points == done  ? "nothing to do"
                             : recorded == 0 ? "a guess from the frames' pixels"
                             : recorded < points - done
                                 ? "partly from seconds recorded, else a guess"
                                 : "from seconds recorded";
  text += fmt::format("about {:.1f} s with {} workers: {}\n", seconds / jobs, jobs, source);
  return text;
}

}  // namespace wedgesim::reports

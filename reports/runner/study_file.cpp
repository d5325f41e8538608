#include "reports/runner/study_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/toml_table.h"
#include "reports/runner/metrics.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

const std::vector<std::string> kBlockKeys{"measure", "count", "seed"};
const std::vector<std::string> kFrameKeys{"scene",      "frame",       "width", "height", "wedges",
                                          "field_side", "light_scale", "kind",  "light",  "depth"};
const std::vector<std::string> kPlotKinds{"line", "bar", "scatter"};

class StudyReader {
 public:
  StudyReader(const toml::table& root, const std::string& file)
      : root_(root), file_(file), table_(root, file) {}

  Study read(const std::string& name, const FrameOverrides& overrides) {
    read_head(name);
    read_shared();
    for (const char* kind : {"grid", "list", "random"}) read_blocks(kind);
    if (!any_block_) add_points({{}}, measure_);
    study_.head.axes = differing_keys(study_.configurations, order_);
    set_measure();
    read_by();
    read_metrics();
    read_plots();
    const toml::node* frames = root_.get("frames");
    if (!table_.has("frames")) table_.fail("frames", "is missing", "a table [frames]");
    table_.reject_unknown();
    study_.frames = read_frames(*frames, file_, overrides);
    return std::move(study_);
  }

 private:
  void read_head(const std::string& name) {
    StudyHead& head = study_.head;
    head.name = name;
    head.title = table_.text("title", name);
    head.question = table_.text("question", "");
    measure_ = parse_measure(table_.place("measure"), table_.text("measure", "count"));
    head.modes_tables = table_.boolean("modes_tables", false);
    head.claims = table_.boolean("claims", false);
    head.check_pixels = table_.boolean("check_pixels", true);
    study_.pictures = table_.boolean("pictures", false);
    study_.time_limit_seconds =
        table_.number("time_limit_seconds", study_.time_limit_seconds, {0.01, 1e6});
  }

  // Settings of all points: preset, datapath, [configuration].
  void read_shared() {
    for (const char* key : {"preset", "datapath"}) {
      if (table_.has(key)) {
        shared_.push_back({key, table_.text(key), line_of(*root_.get(key))});
      }
    }
    if (!table_.has("configuration")) return;
    (void)table_.table("configuration");
    for (const Axis& axis : read_axes(*root_["configuration"].as_table(), file_, {})) {
      if (axis.values.size() != 1) {
        throw InputError(fmt::format("{}:{}", file_, axis.line),
                         fmt::format("'{}' has several values", axis.key),
                         "one in [configuration], lists in [[grid]], [[list]] or [[random]]");
      }
      shared_.push_back({axis.key, axis.values.front(), axis.line});
    }
  }

  static int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

  void read_blocks(const std::string& kind) {
    if (table_.tables(kind).empty()) return;
    for (const toml::node& node : *root_.get(kind)->as_array()) {
      any_block_ = true;
      const toml::table& block = *node.as_table();
      const TomlTable table(block, file_);
      const Measure measure = parse_measure(table.place("measure"),
                                            table.text("measure", std::string(spelling(measure_))));
      const std::vector<Axis> axes = read_axes(
          block, file_, kind == "random" ? kBlockKeys : std::vector<std::string>{"measure"});
      for (const Axis& axis : axes) order_.push_back(axis.key);
      if (kind == "grid") {
        add_points(grid_points(axes, file_, line_of(node)), measure);
      } else if (kind == "list") {
        add_points(list_points(axes, file_), measure);
      } else {
        const int count = table.integer("count", {}, 1, static_cast<int>(kMostPoints));
        const int seed = table.integer("seed", {});
        add_points(random_points(axes, static_cast<std::size_t>(count),
                                 static_cast<std::uint64_t>(seed), file_, line_of(node)),
                   measure);
      }
    }
  }

  void add_points(const std::vector<Settings>& points, Measure measure) {
    for (const Settings& point : points) {
      Settings settings = shared_;
      settings.insert(settings.end(), point.begin(), point.end());
      Configuration configuration = make_configuration(file_, measure, settings, shared_.size());
      if (seen_.insert(point_key(configuration, 0)).second) {
        study_.configurations.push_back(std::move(configuration));
      }
    }
  }

  bool measures(Measure measure) const {
    return std::ranges::any_of(study_.configurations,
                               [measure](const Configuration& c) { return c.measure == measure; });
  }

  void set_measure() {
    study_.head.measure = measures(Measure::count) && measures(Measure::cycles) ? "both"
                          : measures(Measure::cycles)                           ? "cycles"
                                                                                : "count";
  }

  // Words of a list, each one of those known.
  std::vector<std::string> words(const std::string& key, const std::set<std::string>& known,
                                 const std::string& expected) {
    std::vector<std::string> words;
    if (!table_.has(key)) return words;
    for (const Value& value : read_axis(key, *root_.get(key), file_).values) {
      words.push_back(to_text(value));
      if (!known.contains(words.back())) {
        table_.fail(key, fmt::format("names '{}'", words.back()), expected);
      }
    }
    return words;
  }

  void read_by() {
    study_.head.by = words("by", {kFrameKeys.begin(), kFrameKeys.end()},
                           fmt::format("of {}", fmt::join(kFrameKeys, ", ")));
  }

  void read_metrics() {
    for (const MetricInfo& metric :
         metrics_of(measures(Measure::count), measures(Measure::cycles))) {
      metrics_.insert(metric.name);
    }
    study_.head.metrics =
        words("metrics", metrics_, "metrics that `wedgesim study --metrics` lists");
    if (study_.head.metrics.empty()) {
      study_.head.metrics = measures(Measure::cycles)
                                ? std::vector<std::string>{"cycles", "port_bytes"}
                                : std::vector<std::string>{"z_reads", "li_writes", "all_bytes"};
    }
  }

  void read_plots() {
    std::set<std::string> known = metrics_;
    known.insert(kFrameKeys.begin(), kFrameKeys.end());
    for (const Configuration& configuration : study_.configurations) {
      for (const auto& [key, value] : configuration.values) known.insert(key);
    }
    for (const TomlTable& table : table_.tables("plot")) {
      Plot plot{table.text("kind"), table.text("title"), table.text("x"), table.text("y"),
                table.text("series", "")};
      table.reject_unknown();
      if (std::ranges::find(kPlotKinds, plot.kind) == kPlotKinds.end()) {
        table.fail("kind", fmt::format("is '{}'", plot.kind), "line, bar or scatter");
      }
      for (const auto& [key, value] :
           {std::pair{"x", plot.x}, std::pair{"y", plot.y}, std::pair{"series", plot.series}}) {
        if (value.empty() || known.contains(value)) continue;
        table.fail(key, fmt::format("is '{}'", value),
                   "a metric, or a key of the configurations or frames");
      }
      study_.head.plots.push_back(std::move(plot));
    }
  }

  const toml::table& root_;
  const std::string& file_;
  TomlTable table_;
  Study study_;
  Measure measure_ = Measure::count;
  Settings shared_;
  std::vector<std::string> order_;  // keys of the blocks
  std::set<std::string> seen_;      // configurations
  std::set<std::string> metrics_;
  bool any_block_ = false;
};

}  // namespace

Study parse_study(std::string_view text, const std::string& name, const std::string& file,
                  const FrameOverrides& overrides) {
  const toml::table root = parse_toml(text, file);
  return StudyReader(root, file).read(name, overrides);
}

Study read_study(const std::string& name_or_file, const FrameOverrides& overrides) {
  for (const BuiltInStudy& study : built_in_studies()) {
    if (study.name == name_or_file) {
      return parse_study(study.text, name_or_file, name_or_file + ".toml", overrides);
    }
  }
  const std::filesystem::path path(name_or_file);
  if (path.extension() != ".toml") {
    std::vector<std::string_view> names;
    for (const BuiltInStudy& study : built_in_studies()) names.push_back(study.name);
    throw InputError(name_or_file, "no such study",
                     fmt::format("{}, or a .toml file", fmt::join(names, ", ")));
  }
  return parse_study(MappedFile(path).text(), path.stem().string(), name_or_file, overrides);
}

}  // namespace wedgesim::reports

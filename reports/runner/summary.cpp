#include "reports/runner/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/file.h"
#include "reports/runner/counted.h"
#include "reports/runner/metrics.h"
#include "reports/runner/modes_text.h"
#include "reports/runner/spread.h"
#include "reports/runner/store.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

constexpr std::size_t kMostFailures = 20;  // listed one by one

std::string shown(double number) {
  if (std::abs(number) >= 1000.0 && std::abs(number) < 1e15) {
    const std::string digits = grouped(static_cast<std::uint64_t>(std::llround(std::abs(number))));
    return number < 0.0 ? '-' + digits : digits;
  }
  return fmt::format("{:.4g}", number);
}

// The word that most points have, and how many of them.
std::string most_frequent(const PointGroup& group, const std::string& metric) {
  std::map<std::string, std::size_t> counts;
  for (const PointRow* point : group.points) {
    const Value& value = find_value(point->metrics, metric);
    if (const auto* word = std::get_if<std::string>(&value)) counts[*word] += 1;
  }
  if (counts.empty()) return "-";
  const auto most =
      std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  if (counts.size() == 1) return most->first;
  return fmt::format("{} ({} of {})", most->first, most->second, group.points.size());
}

bool is_word(const std::vector<PointGroup>& groups, const std::string& metric) {
  return std::ranges::any_of(groups, [&metric](const PointGroup& group) {
    return std::holds_alternative<std::string>(find_value(group.points.front()->metrics, metric));
  });
}

Table configurations_table(const Results& results) {
  const StudyHead& study = results.study;
  const std::vector<PointGroup> groups = groups_of(results);
  const bool single =
      std::ranges::all_of(groups, [](const PointGroup& group) { return group.points.size() == 1; });
  Table table;
  for (const std::string& key : study.by) table.add_column(key, Table::Align::left);
  for (const std::string& axis : study.axes) table.add_column(axis, Table::Align::left);
  for (const std::string& metric : study.metrics) {
    if (single || is_word(groups, metric)) {
      table.add_column(metric, Table::Align::right);
    } else {
      table.add_column("5 %", Table::Align::right, metric);
      table.add_column("median", Table::Align::right);
      table.add_column("95 %", Table::Align::right);
    }
  }
  for (const PointGroup& group : groups) {
    std::vector<std::string> cells;
    for (const Value& value : group.by) cells.push_back(to_text(value));
    for (const std::string& axis : study.axes) {
      cells.push_back(to_text(find_value(group.configuration, axis)));
    }
    for (const std::string& metric : study.metrics) {
      const auto spread = group.spread(metric);
      if (is_word(groups, metric)) {
        cells.push_back(most_frequent(group, metric));
      } else if (single) {
        cells.push_back(spread ? shown(spread->median) : "-");
      } else {
        for (const double value : {spread->low, spread->median, spread->high}) {
          cells.push_back(shown(value));
        }
      }
    }
    table.add_row(std::move(cells));
  }
  return table;
}

void add_checks(Document& document, const Results& results) {
  std::vector<const PointRow*> done;
  std::vector<std::string> failures;
  for (const PointRow& point : results.points) {
    if (point.state == PointState::done) {
      done.push_back(&point);
    } else {
      failures.push_back(fmt::format(
          "{}: {}: {}", spelling(point.state),
          point_name(point.frame, point.measure, point.configuration, results.study.axes),
          point.message));
    }
  }
  if (!results.study.modes_tables && results.study.check_pixels) {
    document.paragraph(pixels_text(done));
  }
  if (failures.empty()) return;
  document.heading(
      fmt::format("{} of {} points could not be measured", failures.size(), results.points.size()));
  const std::size_t listed = std::min(failures.size(), kMostFailures);
  std::string text = fmt::format(
      "{}",
      fmt::join(failures.begin(), failures.begin() + static_cast<std::ptrdiff_t>(listed), "\n"));
  if (listed < failures.size()) {
    text += fmt::format("\n... and {} more in results.csv", failures.size() - listed);
  }
  document.paragraph(text);
}

// As RFC 4180 has it: quoted where it must be, quotes doubled.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

void add_keys(std::set<std::string>& keys, const Values& values) {
  for (const auto& [key, value] : values) keys.insert(key);
}

Json frame_json(const FrameRow& frame) {
  Json json{{"label", frame.label},
            {"scene", frame.scene},
            {"parameters", to_json(frame.parameters)},
            {"trace",
             {{"name", frame.scene},
              {"checksum", fmt::format("{:016x}", frame.checksum)},
              {"width", to_json(find_value(frame.parameters, "width"))},
              {"height", to_json(find_value(frame.parameters, "height"))},
              {"wedges", frame.wedges}}}};
  if (!frame.failure.empty()) json["failure"] = frame.failure;
  json["timing"] = {{"seconds", frame.seconds}};
  return json;
}

Json point_json(const PointRow& point) {
  Json json{{"frame", point.frame},
            {"measure", point.measure},
            {"configuration", to_json(point.configuration)},
            {"state", spelling(point.state)}};
  if (!point.message.empty()) json["message"] = point.message;
  json["metrics"] = to_json(point.metrics);
  json["timing"] = {{"seconds", point.seconds}};
  return json;
}

}  // namespace

Document summary(const Results& results) {
  const StudyHead& study = results.study;
  Document document;
  document.heading(fmt::format("{}: {}", study.name, study.title));
  std::string text = study.question.empty() ? "" : study.question + '\n';
  text +=
      fmt::format("{} points on {} frames", grouped(results.points.size()), results.frames.size());
  if (static_cast<std::int64_t>(results.points.size()) < results.points_planned) {
    text +=
        fmt::format(" of {} planned", grouped(static_cast<std::uint64_t>(results.points_planned)));
  }
  document.paragraph(text);
  if (study.modes_tables) {
    document.append(modes_text(results));
  } else if (!groups_of(results).empty()) {
    document.table(configurations_table(results));
  }
  add_checks(document, results);
  return document;
}

std::string results_csv(const Results& results) {
  std::set<std::string> parameters, configuration, metrics;
  for (const FrameRow& frame : results.frames) add_keys(parameters, frame.parameters);
  for (const PointRow& point : results.points) {
    add_keys(configuration, point.configuration);
    add_keys(metrics, point.metrics);
  }
  std::string text = "label,scene,checksum";
  const auto add_names = [&text](const std::set<std::string>& keys) {
    for (const std::string& key : keys) text += ',' + csv_field(key);
  };
  add_names(parameters);
  text += ",measure";
  add_names(configuration);
  text += ",state,message";
  add_names(metrics);
  text += '\n';
  std::map<std::string, const FrameRow*> frames;
  for (const FrameRow& frame : results.frames) frames.emplace(frame.label, &frame);
  for (const PointRow& point : results.points) {
    const FrameRow& frame = *frames.at(point.frame);
    const auto add_values = [&text](const std::set<std::string>& keys, const Values& values) {
      for (const std::string& key : keys) text += ',' + csv_field(to_text(find_value(values, key)));
    };
    text += fmt::format("{},{},{:016x}", csv_field(frame.label), csv_field(frame.scene),
                        frame.checksum);
    add_values(parameters, frame.parameters);
    text += ',' + point.measure;
    add_values(configuration, point.configuration);
    text += fmt::format(",{},{}", spelling(point.state), csv_field(point.message));
    add_values(metrics, point.metrics);
    text += '\n';
  }
  return text;
}

Json results_json(const Results& results) {
  Json frames = Json::array();
  for (const FrameRow& frame : results.frames) frames.push_back(frame_json(frame));
  Json points = Json::array();
  for (const PointRow& point : results.points) points.push_back(point_json(point));
  const StudyHead& study = results.study;
  return {{"schema", "wedgesim.study/1"},
          {"study", study.name},
          {"title", study.title},
          {"question", study.question},
          {"configuration",
           {{"measure", study.measure},
            {"axes", study.axes},
            {"by", study.by},
            {"metrics", study.metrics}}},
          {"points_planned", results.points_planned},
          {"frames", std::move(frames)},
          {"points", std::move(points)}};
}

void write_results(const std::filesystem::path& folder, const Results& results) {
  const Document document = summary(results);
  write_file(folder / "summary.txt", document.text());
  write_file(folder / "summary.md", document.markdown());
  write_file(folder / "results.csv", results_csv(results));
  write_json(folder / "results.json", results_json(results));
}

bool held(const Results& results) {
  return std::ranges::all_of(results.points, [&results](const PointRow& point) {
    return point.state == PointState::done && (!results.study.check_pixels || held(point));
  });
}

}  // namespace wedgesim::reports

#include "reports/accuracy/published.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/accuracy/accuracy_charts.h"
#include "reports/accuracy/recommend.h"
#include "reports/page/html.h"
#include "reports/table.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kComparable = 2.0;  // factor of triangles and of pixels

// The larger of two numbers over the smaller; 1 where one is not known.
double ratio(double a, double b) {
  return a == 0.0 || b == 0.0 ? 1.0 : std::max(a, b) / std::min(a, b);
}

double triangle_ratio(const Published& published, const SceneResult& result) {
  return ratio(static_cast<double>(published.triangles), static_cast<double>(result.triangles));
}

double pixel_ratio(const Published& published, const SceneResult& result) {
  return ratio(static_cast<double>(published.width) * published.height,
               static_cast<double>(result.scene.width) * result.scene.height);
}

bool same_scene(const Published& published, const SceneResult& result) {
  return !published.ours.empty() && result.scene.name.starts_with(published.ours);
}

const Measured* first_choice(const SceneResult& result, std::string_view method) {
  const auto found = std::ranges::find_if(result.methods, [&](const Measured& measured) {
    return !measured.refused && measured.choice.method->name == method;
  });
  return found == result.methods.end() ? nullptr : &*found;
}

Beside beside(const Published& published, const std::vector<SceneResult>& results) {
  Beside best{&published, nullptr, nullptr, false};
  double least = std::numeric_limits<double>::infinity();
  for (const SceneResult& result : results) {
    const Measured* ours = first_choice(result, published.method);
    if (ours == nullptr || !result.scene.other_lights.empty()) continue;  // the papers' have one
    const bool same = same_scene(published, result);
    const double triangles = triangle_ratio(published, result);
    const double pixels = pixel_ratio(published, result);
    // Another scene is farther than any difference of sizes.
    const double away = std::log(triangles) + std::log(pixels) + (same ? 0.0 : 1e3);
    if (away >= least) continue;
    least = away;
    const bool sized = published.triangles != 0 && published.width != 0 &&
                       triangles <= kComparable && pixels <= kComparable;
    best = {&published, &result, ours, same || sized};
  }
  return best;
}

std::string size_text(int width, int height) {
  return width == 0 ? "-" : fmt::format("{}x{}", width, height);
}

std::string source_text(const Published& published) {
  return fmt::format("{}, {}", published.paper, published.place);
}

std::string hardware_text(const Published& published) {
  return published.year == 0 ? std::string(published.hardware)
                             : fmt::format("{}, {}", published.hardware, published.year);
}

struct Column {
  const char* name;
  bool number = false;
  const char* group = "";
};
constexpr std::array kColumns{Column{"method"},          Column{"paper", false, "published"},
                              Column{"scene"},           Column{"hardware, year"},
                              Column{"triangles", true}, Column{"pixels", true},
                              Column{"ms", true},        Column{"scene", false, "ours"},
                              Column{"choice"},          Column{"triangles", true},
                              Column{"pixels", true},    Column{"ms", true}};

std::vector<std::string> cells_of(const Beside& row) {
  const Published& published = *row.published;
  std::vector<std::string> cells{std::string(published.method),
                                 source_text(published),
                                 std::string(published.scene),
                                 hardware_text(published),
                                 published.triangles == 0 ? "-" : grouped(published.triangles),
                                 size_text(published.width, published.height),
                                 fmt::format("{:.1f}", published.milliseconds())};
  if (row.ours == nullptr) {
    cells.resize(kColumns.size(), "-");
    return cells;
  }
  cells.insert(cells.end(),
               {row.scene->scene.name, row.ours->choice.text, grouped(row.scene->triangles),
                size_text(row.scene->scene.width, row.scene->scene.height),
                fmt::format("{:.1f}", 1e3 * seconds_of(*row.ours))});
  return cells;
}

}  // namespace

std::vector<Beside> beside_published(const std::vector<SceneResult>& results) {
  const std::vector<std::string> methods = method_names(results);
  std::vector<Beside> all;
  for (const Published& one : published()) {
    if (std::ranges::find(methods, one.method) == methods.end()) continue;
    all.push_back(beside(one, results));
  }
  return all;
}

std::string published_text(const std::vector<SceneResult>& results) {
  using Align = Table::Align;
  Table table;
  for (const Column& column : kColumns) {
    table.add_column(column.name, column.number ? Align::right : Align::left, column.group);
  }
  bool any = false;
  for (const Beside& row : beside_published(results)) {
    if (!row.comparable) continue;
    table.add_row(cells_of(row));
    any = true;
  }
  if (!any) return "";
  return "Published times, beside ours of the nearest size on this computer\n" + table.text(2);
}

std::string published_html(const std::vector<SceneResult>& results) {
  const std::vector<Beside> rows = beside_published(results);
  if (rows.empty()) return "";
  std::string html =
      "<section id=\"published\" aria-labelledby=\"published-heading\">\n"
      "<h2 id=\"published-heading\">Published times</h2>\n"
      "<p>Times as the papers print them, on the hardware of their year, beside ours of the same "
      "method: on the scene made after theirs, else on that with the nearest numbers of triangles "
      "and pixels. Faint: neither the scene is the same nor are both numbers within a factor of "
      "two.</p>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Published "
      "times\"><table>\n<thead><tr><td></td><th scope=\"colgroup\" colspan=\"6\">published</th><th "
      "scope=\"colgroup\" colspan=\"5\">ours, here</th></tr>\n<tr>";
  for (const Column& column : kColumns) {
    html += column.number ? page::number_heading(column.name)
                          : "<th scope=\"col\">" + page::escape(column.name) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const Beside& row : rows) {
    html += row.comparable ? "<tr>" : "<tr class=\"faint\">";
    const std::vector<std::string> cells = cells_of(row);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      html += kColumns[i].number ? "<td class=\"number\">" + page::escape(cells[i]) + "</td>"
                                 : page::element("td", cells[i]);
    }
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table></div>\n</section>\n";
}

Json published_json(const std::vector<SceneResult>& results) {
  const auto known = [](auto value) { return value == 0 ? Json(nullptr) : Json(value); };
  Json all = Json::array();
  for (const Beside& row : beside_published(results)) {
    const Published& one = *row.published;
    Json json{{"method", one.method},
              {"paper", one.paper},
              {"place", one.place},
              {"year", known(one.year)},
              {"hardware", one.hardware},
              {"scene", one.scene},
              {"triangles", known(one.triangles)},
              {"width", known(one.width)},
              {"height", known(one.height)},
              {"frames_per_second", one.frames_per_second},
              {"ms", one.milliseconds()},
              {"stages_ms", Json::object()},
              {"ours", nullptr}};
    for (const PublishedStage& stage : one.stages) {
      json["stages_ms"][std::string(stage.name)] = stage.milliseconds;
    }
    if (row.ours != nullptr) {
      json["ours"] = {{"scene", row.scene->scene.name},
                      {"choice", row.ours->choice.text},
                      {"triangles", row.scene->triangles},
                      {"width", row.scene->scene.width},
                      {"height", row.scene->scene.height},
                      {"comparable", row.comparable},
                      {"timing", {{"all_threads_ms", 1e3 * seconds_of(*row.ours)}}}};
    }
    all.push_back(std::move(json));
  }
  return all;
}

}  // namespace wedgesim::reports::accuracy

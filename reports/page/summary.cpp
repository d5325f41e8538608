#include "reports/page/summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "reports/page/caption.h"
#include "reports/page/findings.h"
#include "reports/page/html.h"
#include "reports/page/names.h"

namespace wedgesim::reports::page {
namespace {

std::string fact(const std::string& number, const std::string& what) {
  return fmt::format("<li><strong>{}</strong> {}</li>\n", escape(number), escape(what));
}

std::string studied_html(const Columns& columns) {
  const Results& results = columns.results();
  std::set<std::string> scenes;
  for (const FrameRow& frame : results.frames) scenes.insert(frame.scene);
  std::size_t failed = 0;
  for (std::size_t i = 0; i < columns.points(); ++i) failed += columns.done(i) ? 0 : 1;
  const auto number = [](std::size_t n) { return number_text(static_cast<double>(n)); };
  const std::size_t frames = results.frames.size(), points = columns.points();
  std::string html = "<ul class=\"facts\">\n";
  html += fact(number(scenes.size()), scenes.size() == 1 ? "scene" : "scenes");
  html += fact(number(frames), frames == 1 ? "frame" : "frames");
  html += fact(number(points), points == 1 ? "point measured" : "points measured");
  html += fact(number(failed), failed == 1 ? "point failed" : "points failed");
  html += "</ul>\n";
  std::vector<std::string> axes;
  for (const Column* axis : columns.axes()) {
    std::vector<std::string> values;
    for (const Value& value : axis->distinct) values.push_back(value_text(value));
    const bool many = values.size() > 9;
    axes.push_back(fmt::format(
        "{} ({})", axis->label,
        many ? fmt::format("{} values, {} to {}", values.size(), values.front(), values.back())
             : fmt::format("{}", fmt::join(values, ", "))));
  }
  std::vector<std::string> names(scenes.begin(), scenes.end());
  constexpr std::size_t kMostNames = 12;
  if (names.size() > kMostNames) {
    names.resize(kMostNames);
    names.push_back(fmt::format("{} more", scenes.size() - kMostNames));
  }
  html += fmt::format("<p>Scenes: {}.</p>\n", escape(listed(names)));
  if (!axes.empty())
    html += fmt::format("<p>Varied: {}.</p>\n", escape(fmt::format("{}", fmt::join(axes, "; "))));
  const auto planned = static_cast<std::size_t>(std::max<std::int64_t>(0, results.points_planned));
  if (planned > points) {
    html += fmt::format("<p class=\"notice\">Unfinished: {} of {} points.</p>\n", number(points),
                        number(planned));
  }
  return html;
}

std::string best_html(const Columns& columns) {
  const auto best = find_best(columns);
  if (!best) return "";
  std::string html = "<div class=\"best\">\n<h3>Best configuration</h3>\n<dl>\n";
  for (const auto& [column, value] : best->settings) {
    if (std::holds_alternative<std::monostate>(value)) continue;  // means nothing here
    html += fmt::format("<div>{}{}</div>\n", element("dt", column->label),
                        element("dd", value_text(value)));
  }
  const Column& metric = *best->metric;
  html += fmt::format("</dl>\n<p>Judged by {}: {}{} in the median frame", escape(metric.label),
                      number_text(best->value.median),
                      metric.unit.empty() ? "" : " " + escape(metric.unit));
  if (best->value.count > 1) {
    html += fmt::format(" (5th to 95th percentile of {} frames: {} to {})", best->value.count,
                        number_text(best->value.low), number_text(best->value.high));
  }
  if (best->behind.high <= 1.0) {
    html += "; the best in every frame.</p>\n</div>\n";
    return html;
  }
  html += fmt::format(
      "; {} behind the best of each frame in the median, {} at the 95th percentile.</p>\n</div>\n",
      percent_text(best->behind.median - 1.0), percent_text(best->behind.high - 1.0));
  return html;
}

std::string findings_html(const Columns& columns) {
  const std::vector<std::string> findings = find_findings(columns);
  if (findings.empty()) return "";
  std::string html = "<div class=\"findings\">\n<h3>Findings</h3>\n<ol>\n";
  for (const std::string& finding : findings) html += element("li", finding) + '\n';
  return html + "</ol>\n</div>\n";
}

std::string failures_html(const Columns& columns) {
  constexpr std::size_t kMostFailures = 10;
  std::string rows;
  std::size_t failed = 0;
  const auto add = [&](const std::string& frame, std::string_view what,
                       const std::string& message) {
    if (++failed > kMostFailures) return;
    rows +=
        "<tr>" + element("td", frame) + element("td", what) + element("td", message) + "</tr>\n";
  };
  std::set<std::string> without_trace;
  for (const FrameRow& frame : columns.results().frames) {
    if (frame.failure.empty()) continue;
    add(frame.label, "no trace", frame.failure);
    without_trace.insert(frame.label);
  }
  for (const PointRow& point : columns.results().points) {
    if (point.state == PointState::done || without_trace.contains(point.frame)) continue;
    std::vector<std::string> words;
    for (const Column* axis : columns.axes()) {
      const auto found = point.configuration.find(axis->key);
      if (found != point.configuration.end()) words.push_back(setting_text(*axis, found->second));
    }
    add(point.frame, fmt::format("{}", fmt::join(words, ", ")), point.message);
  }
  if (failed == 0) return "";
  const std::string rest =
      failed > kMostFailures
          ? fmt::format("<p>And {} more: sort the table of points by state.</p>\n",
                        failed - kMostFailures)
          : "";
  return "<div class=\"failures\">\n<h3>What failed</h3>\n<div class=\"scroll\" tabindex=\"0\" "
         "role=\"region\" "
         "aria-label=\"What failed\"><table>\n<thead><tr><th scope=\"col\">Frame</th>"
         "<th scope=\"col\">Configuration</th><th "
         "scope=\"col\">Message</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody>\n</table></div>\n" + rest + "</div>\n";
}

}  // namespace

std::string summary_html(const Columns& columns) {
  return studied_html(columns) + "<div class=\"lead\">\n" + best_html(columns) +
         findings_html(columns) + "</div>\n" + failures_html(columns);
}

std::string charts_html(const std::vector<Chart>& charts) {
  std::string html;
  for (const Chart& chart : charts) {
    html += fmt::format(
        "<figure id=\"chart-{0}\" class=\"chart\">\n{1}\n<p class=\"about\">{2}</p>\n"
        "<div class=\"series\" role=\"group\" aria-label=\"Series of: {3}\"></div>\n"
        "<div class=\"plot\"></div>\n<p "
        "class=\"held\"></p>\n<figcaption>{4}</figcaption>\n</figure>\n",
        escape(chart.id), element("h3", chart.title), escape(chart.about), escape(chart.title),
        escape(chart.caption));
  }
  return html;
}

std::string sections_html(const std::vector<Section>& sections) {
  std::string html;
  for (const Section& section : sections) {
    html += fmt::format(
        "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n",
        escape(section.id), escape(section.heading));
    if (!section.text.empty()) html += element("p", section.text) + '\n';
    html += fmt::format(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
        "aria-label=\"{}\"><table>\n<thead><tr>",
        escape(section.heading));
    for (const std::string& column : section.columns) {
      html += fmt::format("<th scope=\"col\">{}</th>", escape(column));
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : section.rows) {
      html += "<tr>";
      for (const std::string& cell : row) html += element("td", cell);
      html += "</tr>\n";
    }
    html += "</tbody>\n</table></div>\n</section>\n";
  }
  return html;
}

std::string downloads_html(const std::vector<Link>& links) {
  std::string html;
  for (const Link& link : links) {
    html += fmt::format("<li><a href=\"{0}\" download>{0}</a> {1}</li>\n", escape(link.path),
                        escape(link.text));
  }
  return html;
}

}  // namespace wedgesim::reports::page

#include "reports/accuracy/accuracy_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/file.h"
#include "reports/accuracy/accuracy_charts.h"
#include "reports/accuracy/accuracy_json.h"
#include "reports/accuracy/accuracy_table.h"
#include "reports/accuracy/accuracy_words.h"
#include "reports/accuracy/published.h"
#include "reports/page/assets.h"
#include "reports/page/html.h"
#include "reports/page/row_charts.h"
#include "reports/page/shell.h"

namespace wedgesim::reports::accuracy {
namespace {

using page::escape;

std::string summary_html(const Report& report, const std::vector<std::string>& labels) {
  std::size_t measured = 0;
  std::size_t refused = 0;
  for (const SceneResult& scene : report.scenes) {
    for (const Measured& one : scene.methods) ++(one.refused ? refused : measured);
  }
  std::string html =
      "<ul class=\"facts\">\n" + page::fact(report.scenes.size(), "scenes") +
      page::fact(method_names(report.scenes).size(), "methods") +
      page::fact(measured, "choices measured") + page::fact(refused, "refused with a reason") +
      page::fact(static_cast<std::size_t>(report.options.rays),
                 "rays of the reference where it matters") +
      "</ul>\n<div class=\"lead\">\n<div class=\"findings\">\n<h3>Findings</h3>\n<ol>\n";
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    html += fmt::format("<li><a href=\"#scene-{}\">{}</a>:", labels[i],
                        escape(report.scenes[i].scene.name));
    for (const std::string& words : finding_words(report.scenes[i])) html += " " + escape(words);
    html += "</li>\n";
  }
  return html + "</ol>\n</div>\n</div>\n";
}

// A choice may be broken after its name and between its options.
std::string breakable(const std::string& choice) {
  std::string html;
  for (const char c : escape(choice)) {
    html += c;
    if (c == ':' || c == ',') html += "<wbr>";
  }
  return html;
}

std::string table_html(const SceneResult& result) {
  std::string groups;
  std::string names;
  std::size_t span = 0;
  std::string_view group;
  const auto end_group = [&] {
    if (span == 0) return;
    groups += group.empty() ? fmt::format("<td colspan=\"{}\"></td>", span)
                            : fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", span,
                                          escape(group));
  };
  for (const Column& column : columns()) {
    if (!column.group.empty()) {
      end_group();
      group = column.group;
      span = 0;
    }
    ++span;
    names += column.number ? page::number_heading(column.name)
                           : "<th scope=\"col\">" + escape(column.name) + "</th>";
  }
  end_group();
  std::string html = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Choices on {}\"><table>\n"
      "<thead><tr>{}</tr>\n<tr>{}</tr></thead>\n<tbody>\n",
      escape(result.scene.name), groups, names);
  const std::vector<std::size_t> front = pareto_front(result.methods);
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    if (result.methods[i].refused) continue;
    const bool on_front = std::ranges::find(front, i) != front.end();
    const std::vector<std::string> cells = cells_of(result.methods[i], on_front);
    html += on_front ? "<tr class=\"front\">" : "<tr>";
    for (std::size_t k = 0; k < cells.size(); ++k) {
      html += columns()[k].number ? "<td class=\"number\">" + escape(cells[k]) + "</td>"
                                  : "<td>" + breakable(cells[k]) + "</td>";
    }
    html += "</tr>\n";
  }
  return html +
         "</tbody>\n</table></div>\n<p class=\"about\">*: no other choice is both faster and "
         "more exact.</p>\n";
}

std::string refused_html(const SceneResult& result) {
  const std::vector<Refusal> all = refusals(result);
  if (all.empty()) return "";
  std::string html = "<h3>Refused</h3>\n<ul class=\"refused\">\n";
  for (const Refusal& refusal : all) {
    html += fmt::format("<li><strong>{}</strong>: {}</li>\n", escape(refusal.choices),
                        escape(refusal.reason));
  }
  return html + "</ul>\n";
}

std::string strips_html(const SceneResult& result, const Pictures& pictures) {
  std::string html = "<h3>Pictures</h3>\n" + scale_html() + "<div class=\"strips\">\n";
  html += fmt::format(
      "<figure>\n<figcaption><strong>Reference</strong></figcaption>\n{}\n"
      "</figure>\n",
      image_html(pictures.reference, "Reference."));
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    const Strip& strip = pictures.strips[i];
    const Measured& measured = result.methods[i];
    if (measured.refused) continue;
    html += fmt::format(
        "<figure>\n<figcaption><a href=\"{}\">{}</a>, RMSE {} in {}</figcaption>\n{}\n</figure>\n",
        escape(strip.file), escape(measured.choice.text), error_text(error_of(measured)),
        time_text(seconds_of(measured)),
        image_html(strip.small, measured.choice.text + " and its difference from the reference."));
  }
  return html + "</div>\n";
}

std::string scene_html(const SceneResult& result, const std::string& label,
                       const std::vector<page::RowChart>& charts, const Pictures& pictures) {
  std::string html = fmt::format(
      "<section class=\"scene\" id=\"scene-{0}\" aria-labelledby=\"scene-{0}-heading\">\n"
      "<h2 id=\"scene-{0}-heading\">{1}</h2>\n",
      label, escape(result.scene.name));
  html +=
      fmt::format("<p class=\"about\">{}. Frame {}: {}.</p>\n", escape(result.scene.description),
                  result.scene.frame, escape(facts_of(result)));
  html += "<div class=\"charts\">\n";
  for (const page::RowChart& chart : charts) html += page::chart_html(chart, "h3");
  html += "</div>\n" + table_html(result) + refused_html(result);
  return html + strips_html(result, pictures) + "</section>\n";
}

}  // namespace

std::string accuracy_page(const Report& report) {
  const std::vector<std::string> labels = labels_of(report.scenes);
  const std::vector<std::string> methods = method_names(report.scenes);
  std::vector<page::RowChart> charts;
  std::string scenes;
  for (std::size_t i = 0; i < report.scenes.size(); ++i) {
    const SceneResult& scene = report.scenes[i];
    std::vector<page::RowChart> own;
    for (page::RowChart& chart : std::vector{time_chart(scene, labels[i], methods),
                                             bytes_chart(scene, labels[i], methods)}) {
      if (!chart.rows.empty()) own.push_back(std::move(chart));
    }
    scenes += scene_html(scene, labels[i], own, report.pictures[i]);
    charts.insert(charts.end(), own.begin(), own.end());
  }
  return page::in_shell({
      .title = "Error against run time",
      .kind = "<code>accuracy</code>",
      .question = "Which shadow method for which scene, at which error?",
      .name = "accuracy",
      .body = page::fill(page::assets::accuracy_html(),
                         {{"summary", summary_html(report, labels)},
                          {"legend", page::legend_html("Methods")},
                          {"scenes", scenes},
                          {"artifacts", artifacts_html(report.artifacts)},
                          {"published", published_html(report.scenes)}}),
      .data = page::row_chart_data(methods, charts),
      .script = page::assets::row_charts_script(),
  });
}

void write_accuracy(const std::filesystem::path& folder, const Report& report, const Wish* wish) {
  std::vector<ShownArtifact> shown;
  for (const ArtifactPictures& artifact : report.artifacts) shown.push_back(artifact.shown);
  write_json(folder / "accuracy.json", accuracy_json(report.options, report.scenes, wish, shown));
  write_file(folder / "accuracy.html", accuracy_page(report));
}

}  // namespace wedgesim::reports::accuracy

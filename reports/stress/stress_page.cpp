#include "reports/stress/stress_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/file.h"
#include "base/image.h"
#include "reports/page/assets.h"
#include "reports/page/html.h"
#include "reports/page/row_charts.h"
#include "reports/page/shell.h"
#include "reports/stress/case_name.h"
#include "reports/stress/stress_charts.h"
#include "reports/stress/stress_json.h"
#include "reports/stress/stress_picture.h"
#include "reports/stress/stress_words.h"

namespace wedgesim::reports::stress {
namespace {

using page::element;
using page::escape;

constexpr int kScale = 6;  // of pictures in the page

std::string summary_html(const RunOptions& options, const std::vector<FamilyResult>& results) {
  std::size_t cases = 0;
  std::size_t refused = 0;
  std::size_t held = 0;
  std::string wrong;
  for (const FamilyResult& result : results) {
    for (const auto& level : result.levels) {
      cases += level.size();
      refused += static_cast<std::size_t>(
          std::ranges::count_if(level, [](const Measurement& m) { return m.refused.has_value(); }));
    }
    const auto complaints = result.complaints();
    held += complaints.empty() ? 1 : 0;
    if (!complaints.empty()) {
      wrong += fmt::format("<li><a href=\"#family-{0}\">{0}</a>: {1}</li>\n",
                           escape(result.family->name),
                           escape(fmt::format("{}", fmt::join(complaints, "; "))));
    }
  }
  std::string html = "<ul class=\"facts\">\n" + page::fact(results.size(), "families") +
                     page::fact(held, "as they must be") + page::fact(cases, "cases") +
                     page::fact(refused, "refused with a reason") +
                     page::fact(options.seeds, "cases of each difficulty") + "</ul>\n";
  html += "<div class=\"lead\">\n<div class=\"findings\">\n<h3>Findings</h3>\n<ol>\n";
  for (const std::string& words : finding_words(results)) html += element("li", words) + "\n";
  html += "</ol>\n</div>\n";
  html += "</div>\n";
  if (wrong.empty()) return html;
  return html + "<h3>Not as it must be</h3>\n<ul class=\"wrong\">\n" + wrong + "</ul>\n";
}

std::string number_cell(const std::optional<double>& level, bool is_short) {
  return fmt::format("<td class=\"number{}\">{}</td>", is_short ? " short" : "",
                     level ? difficulty_text(*level) : "–");
}

std::string table_html(const std::vector<FamilyResult>& results) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Bounds\"><table>\n<thead>"
      "<tr><td colspan=\"3\"></td><th scope=\"colgroup\" colspan=\"2\">must hold to</th><th "
      "scope=\"colgroup\" colspan=\"4\">holds to</th><td></td></tr>\n<tr><th "
      "scope=\"col\">Family</th><th scope=\"col\">Difficulty</th><th scope=\"col\" "
      "class=\"number\">Harmless</th>";
  for (const char* name : {"fixed", "double"}) html += page::number_heading(name);
  for (const Arithmetic a : kArithmetics) html += page::number_heading(name_of(a));
  html += "<th scope=\"col\">Verdict</th></tr></thead>\n<tbody>\n";
  for (const FamilyResult& result : results) {
    const Family& family = *result.family;
    const std::string unit = family.unit.empty() ? "" : fmt::format(" ({})", family.unit);
    html += fmt::format("<tr><td><a href=\"#family-{0}\">{0}</a></td>{1}", escape(family.name),
                        element("td", std::string(family.parameter) + unit));
    html += number_cell(family.levels.front(), false);
    html += number_cell(result.required(Arithmetic::fixed), false);
    html += number_cell(result.required(Arithmetic::double_precision), false);
    for (const Arithmetic a : kArithmetics) {
      html += number_cell(result.holds_to(a), !result.meets_required(a));
    }
    const bool held = result.complaints().empty();
    html += held ? "<td>held</td></tr>\n" : "<td class=\"short\">not held</td></tr>\n";
  }
  return html + "</tbody>\n</table></div>\n";
}

std::string failures_html(const FamilyResult& result, const std::vector<FailurePicture>& pictures) {
  std::string html;
  for (const FailurePicture& picture : pictures) {
    if (picture.family != result.family) continue;
    const std::size_t level = result.levels_held(picture.arithmetic);
    const CaseName name{result.family, *result.first_failure(picture.arithmetic, level),
                        result.family->levels[level]};
    const Errors& errors =
        result.levels[level][name.seed].errors[static_cast<std::size_t>(picture.arithmetic)];
    const std::string words = fmt::format("{} first breaks at {}: {}.", name_of(picture.arithmetic),
                                          difficulty_text(name.difficulty), broken_words(errors));
    html += fmt::format(
        "<figure>\n<figcaption>{0}</figcaption>\n<img width=\"{1}\" height=\"{2}\" alt=\"Judge, "
        "{3} and their difference.\" src=\"data:image/png;base64,{4}\">\n<p><code>wedgesim stress "
        "--replay {5}</code></p>\n</figure>\n",
        escape(words), picture.width, picture.height, name_of(picture.arithmetic),
        page::base64(picture.png), escape(to_text(name)));
  }
  if (html.empty()) return html;
  return "<div class=\"broken\">\n" + html + "</div>\n";
}

std::string family_html(const FamilyResult& result, const std::vector<page::RowChart>& charts,
                        const std::vector<FailurePicture>& pictures) {
  const Family& family = *result.family;
  std::string html = fmt::format(
      "<article class=\"family\" id=\"family-{0}\" aria-labelledby=\"family-{0}-heading\">\n"
      "<h3 id=\"family-{0}-heading\">{0}</h3>\n",
      escape(family.name));
  const std::string unit = family.unit.empty() ? "" : fmt::format(" ({})", family.unit);
  html += fmt::format("<p class=\"about\">Difficulty: {}{}.</p>\n", escape(family.parameter),
                      escape(unit));
  html += element("p", bounds_words(result)) + "\n";
  for (const std::string& complaint : result.complaints()) {
    html += fmt::format("<p class=\"notice\">{}</p>\n", escape(complaint));
  }
  const std::string refused = refused_words(result);
  if (!refused.empty()) html += element("p", refused) + "\n";
  html += "<div class=\"charts\">\n";
  for (const page::RowChart& chart : charts) html += page::chart_html(chart, "h4");
  return html + "</div>\n" + failures_html(result, pictures) + "</article>\n";
}

std::filesystem::path picture_path(const std::filesystem::path& folder, const Family& family,
                                   Arithmetic arithmetic) {
  return folder / "pictures" / fmt::format("{}_{}.png", family.name, name_of(arithmetic));
}

// Of whatever families: a page of some stands beside no picture of others.
void remove_pictures(const std::filesystem::path& folder) {
  for (const Family& family : families()) {
    for (const Arithmetic a : kArithmetics) {
      std::error_code error;  // what cannot be removed cannot be written over, which is reported
      std::filesystem::remove(picture_path(folder, family, a), error);
    }
  }
}

FailurePicture draw(const FamilyResult& result, Arithmetic arithmetic, const Measurement& failed,
                    const std::filesystem::path& folder) {
  const Image image =
      picture_of(failed, std::array{arithmetic}, std::min(kScale, visible_scale(failed)));
  const std::filesystem::path path = picture_path(folder, *result.family, arithmetic);
  write_image(path, image);
  return {result.family, arithmetic, std::string(MappedFile(path).text()), image.width,
          image.height};
}

}  // namespace

std::string stress_page(const RunOptions& options, const std::vector<FamilyResult>& results,
                        const std::vector<FailurePicture>& pictures) {
  std::vector<page::RowChart> charts{time_chart(results), condition_chart(results)};
  const std::string cost = "<div class=\"charts\">\n" + page::chart_html(charts[0], "h3") +
                           page::chart_html(charts[1], "h3") + "</div>\n";
  std::string sections;
  for (const FamilyResult& result : results) {
    const std::vector<page::RowChart> own{excess_chart(result), rms_chart(result)};
    sections += family_html(result, own, pictures);
    charts.insert(charts.end(), own.begin(), own.end());
  }
  return page::in_shell({
      .title = "Numerical stability",
      .kind = "<code>stress</code>",
      .question =
          "Families of cases from harmless to past breaking, four arithmetics, and a judge of 200 "
          "bits.",
      .name = "stress",
      .body = page::fill(page::assets::stress_html(), {{"summary", summary_html(options, results)},
                                                       {"table", table_html(results)},
                                                       {"legend", page::legend_html("Arithmetics")},
                                                       {"cost", cost},
                                                       {"families", sections}}),
      .data = page::row_chart_data({kArithmeticNames.begin(), kArithmeticNames.end()}, charts),
      .script = page::assets::row_charts_script(),
  });
}

std::vector<std::filesystem::path> stress_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{folder / "stress.json", folder / "stress.html"};
  for (const Family& family : families()) {
    for (const Arithmetic a : kArithmetics) files.push_back(picture_path(folder, family, a));
  }
  return files;
}

void require_stress_writable(const std::filesystem::path& folder) {
  for (const std::filesystem::path& file : stress_files(folder)) require_writable(file);
}

void write_stress(const std::filesystem::path& folder, const RunOptions& options,
                  const std::vector<FamilyResult>& results) {
  remove_pictures(folder);
  write_json(folder / "stress.json", stress_json(options, results));
  std::vector<FailurePicture> pictures;
  for (const FamilyResult& result : results) {
    for (const Arithmetic a : kArithmetics) {
      const std::size_t level = result.levels_held(a);
      if (level == result.levels.size()) continue;
      const auto seed = result.first_failure(a, level);
      if (seed) pictures.push_back(draw(result, a, result.levels[level][*seed], folder));
    }
  }
  write_file(folder / "stress.html", stress_page(options, results, pictures));
}

}  // namespace wedgesim::reports::stress

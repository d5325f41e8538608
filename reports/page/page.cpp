#include "reports/page/page.h"

#include "base/file.h"
#include "reports/page/assets.h"
#include "reports/page/html.h"
#include "reports/page/page_data.h"
#include "reports/page/shell.h"
#include "reports/page/summary.h"

namespace wedgesim::reports::page {
namespace {

// A section's heading that stays away with what is below it.
std::string section(const std::string& id, const std::string& heading, const std::string& body) {
  if (body.empty()) return "";
  return "<section id=\"" + id + "\" aria-labelledby=\"" + id + "-heading\">\n<h2 id=\"" + id +
         "-heading\">" + heading + "</h2>\n" + body + "</section>\n";
}

std::string title_of(const StudyHead& study) {
  return study.title.empty() ? study.name : study.title;
}

}  // namespace

std::string page_html(const Page& page) {
  const Columns columns(page.results);
  const std::vector<Chart> charts = make_charts(columns);
  const StudyHead& study = page.results.study;
  std::string charts_body = charts_html(charts);
  if (!charts_body.empty()) charts_body = "<div class=\"charts\">\n" + charts_body + "</div>\n";
  const std::string maps_body = page.maps.empty() ? "" : "<div id=\"maps\"></div>\n";
  std::string downloads = downloads_html(page.downloads);
  if (!downloads.empty()) downloads = "<ul class=\"downloads\">\n" + downloads + "</ul>\n";
  return in_shell(
      {.title = title_of(study),
       .kind = "study " + element("code", study.name),
       .question = study.question,
       .name = "study",
       .body = fill(assets::html(),
                    {{"summary", summary_html(columns)},
                     {"charts", section("charts", "Charts", charts_body)},
                     {"maps", section("heat-maps", "Accesses, pixel by pixel", maps_body)},
                     {"sections", sections_html(page.sections)},
                     {"downloads", section("downloads", "Downloads", downloads)}}),
       .data = page_data(page, columns, charts),
       .script = assets::script()});
}

void write_page(const std::filesystem::path& path, const Page& page) {
  write_file(path, page_html(page));
}

}  // namespace wedgesim::reports::page

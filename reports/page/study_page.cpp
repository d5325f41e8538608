#include "reports/page/study_page.h"

#include <algorithm>

#include "reports/page/heat_maps.h"

namespace wedgesim::reports::page {
namespace {

std::vector<Link> links_of(const std::filesystem::path& folder) {
  std::vector<Link> links;
  const auto add = [&](const std::string& name, const char* text) {
    if (std::filesystem::is_regular_file(folder / name)) links.push_back({name, text});
  };
  add("results.csv", "every point: frame, configuration, metrics, all digits");
  add("results.json", "the same as JSON");
  add("results.sqlite", "the same as a database (SQLite)");
  add("summary.md", "the tables as Markdown");
  add("timeline.json", "what the units do when: for ui.perfetto.dev or chrome://tracing");
  return links;
}

}  // namespace

std::filesystem::path page_path(const std::filesystem::path& folder) {
  return folder / "report.html";
}

void write_study_page(const std::filesystem::path& folder, const Results& results,
                      const std::filesystem::path& path, const std::vector<Section>& sections) {
  Page page{results, {}, {}, sections, links_of(folder)};
  add_heat_maps(Columns(results), folder, page);
  write_page(path, page);
}

}  // namespace wedgesim::reports::page

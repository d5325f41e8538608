#include "reports/page/study_page.h"

#include <algorithm>

#include "reports/claims/claims.h"
#include "reports/page/heat_maps.h"
#include "reports/page/timeline_file.h"

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
  add("timeline.json",
      "what each unit does in the first cycles of the best configuration: for Perfetto");
  return links;
}

// The papers' claims, held against the results.
Section claims_section(const Results& results) {
  Section section{"claims", "Claims of the papers", "", {}, {}};
  section.text =
      "Measured: the median, or the largest value where the paper says up to, and in parentheses "
      "the 5th to 95th percentile, over frames and tiles, on the paper's kind of wedges.";
  section.columns = {"Claim",    "Paper, section", "The paper's band",
                     "Measured", "Measured as",    "Verdict"};
  for (const ClaimResult& result : judge_claims(study_claims(), results)) {
    const Claim& claim = *result.claim;
    std::string verdict(spelling(result.verdict));
    if (!result.because.empty()) verdict += ": " + result.because;
    section.rows.push_back({claim.says, claim.paper + ", " + claim.section, band_text(claim),
                            value_text(claim, result.literal()),
                            claim.measured.empty() ? "" : claim.measured.front().definition,
                            std::move(verdict)});
  }
  return section;
}

}  // namespace

std::filesystem::path page_path(const std::filesystem::path& folder) {
  return folder / "report.html";
}

void write_study_page(const std::filesystem::path& folder, const Results& results,
                      const std::filesystem::path& path) {
  const Columns columns(results);
  write_timeline(columns, folder);
  Page page{results, {}, {}, {}, links_of(folder)};
  if (results.study.claims) page.sections.push_back(claims_section(results));
  add_heat_maps(columns, folder, page);
  write_page(path, page);
}

}  // namespace wedgesim::reports::page

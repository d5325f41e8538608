#include "cli/study_output.h"

#include "base/file.h"
#include "reports/claims/claims.h"
#include "reports/page/study_page.h"
#include "reports/runner/summary.h"
#include "reports/table.h"

namespace wedgesim::cli {

std::string write_study(const std::filesystem::path& folder, const reports::Results& results,
                        const std::filesystem::path& claims) {
  reports::write_results(folder, results);
  reports::page::write_study_page(folder, results, reports::page::page_path(folder));
  std::string text = reports::summary(results).text() + '\n';
  if (!results.study.claims) return text;
  const auto judged = reports::judge_claims(reports::study_claims(), results);
  const std::string page = reports::claims_page(judged, results).markdown();
  write_file(folder / "claims.md", page);
  if (!claims.empty()) write_file(claims, page);
  return text + reports::claims_table(judged).text() + '\n';
}

}  // namespace wedgesim::cli

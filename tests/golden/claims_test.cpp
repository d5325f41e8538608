// Does docs/claims.md still say what the study of the papers' claims measures?
// docs/testing.md tells how to refresh it.
#include "reports/claims/claims.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "reports/runner/runner.h"
#include "reports/runner/store.h"
#include "tests/base/temporary_folder.h"
#include "tests/golden/golden.h"

namespace wedgesim::tests {
namespace {

TEST(GoldenClaims, TheDocumentIsWhatIsMeasured) {
  const TemporaryFolder folder;
  reports::RunOptions options;
  options.folder = folder / "claims";
  reports::run_study(reports::read_study("claims"), options);
  const reports::Results results = reports::read_results(options.folder);
  const auto claims = reports::judge_claims(reports::study_claims(), results);
  const std::string page = reports::claims_page(claims, results).markdown();
  const std::filesystem::path file = WEDGESIM_SOURCE_DIR "/docs/claims.md";
  if (updates_golden()) write_file(file, page);
  EXPECT_EQ(page, MappedFile(file).text());
}

}  // namespace
}  // namespace wedgesim::tests

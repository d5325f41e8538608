// write_pages FOLDER: writes the pages that page_test.mjs opens.
#include <filesystem>
#include <iostream>

#include "base/file.h"
#include "reports/page/page.h"
#include "reports/stress/stress_page.h"
#include "tests/reports/accuracy/sample.h"
#include "tests/reports/page/sample.h"
#include "tests/reports/stress/sample.h"

namespace wedgesim::tests {
namespace {

void write(const std::filesystem::path& folder, const reports::Results& results, bool maps) {
  reports::page::Page page{results, {}, {}, {}, {}};
  if (maps) page.maps = sample_maps(results);
  page.sections.push_back({"more",
                           "More to say",
                           "A table of another part: " + results.study.title,
                           {"Claim", "Verdict"},
                           {{results.study.title, "depends"}}});
  page.downloads = {{"results.csv", "every point, all digits"}};
  write_file(folder / "results.csv", "key\n1\n");
  write_page(folder / (results.study.name + ".html"), page);
}

}  // namespace
}  // namespace wedgesim::tests

int main(int argc, char** argv) {
  using namespace wedgesim::tests;  // NOLINT: of this file alone
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  write(folder, counted_results(), true);
  write(folder, timed_results(), false);
  write(folder, precision_results(), false);
  write(folder, large_results(2000), false);
  write(folder, hostile_results(), true);
  wedgesim::reports::stress::write_stress(folder / "stress", {{}, 2},
                                          wedgesim::reports::stress::tests::sample_results());
  namespace accuracy = wedgesim::reports::accuracy::tests;
  accuracy::write_sample(folder / "accuracy", accuracy::sample_scenes(5, 20));
  return 0;
}

// Does every study leave its page, and can the page be written again from the results alone?
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyReport, OfACount) {
  const TemporaryFolder folder;
  const std::filesystem::path out = folder / "out";
  expect_good(run_command(
      {"study", "paper2", "-o", out.string(), "--size", "64x48", "--scenes", "cylinder"}));
  const std::string page = read_text(out / "report.html");
  for (const char* part : {"<h1>Single-pass against three-pass</h1>", "<h3>Best configuration</h3>",
                           "<a href=\"results.sqlite\" download>", "\"cull_efficiency\"",
                           "<h3>Culling against a perfect cull</h3>"}) {
    EXPECT_TRUE(has(page, part)) << part;
  }
  EXPECT_TRUE(std::filesystem::exists(out / "maps/cylinder_single-pass_t8_z_reads.png"));
  EXPECT_FALSE(std::filesystem::exists(out / "timeline.json"));
  const std::filesystem::path again = folder / "again.html";
  const Outcome outcome = run_command({"study", "report", out.string(), "-o", again.string()});
  expect_good(outcome);
  EXPECT_TRUE(has(outcome.out, again.string()));
  EXPECT_EQ(read_text(again), page);
}

TEST(StudyReport, OfAStudyInTimeHasItsTimeline) {
  const TemporaryFolder folder;
  std::ofstream(folder / "quick.toml") << "title = \"Quick\"\nmeasure = \"cycles\"\n"
                                          "metrics = [\"cycles\"]\n[frames]\n"
                                          "scene = \"cylinder\"\nsize = \"64x48\"\n[[grid]]\n"
                                          "block.tile = [4, 8]\n";
  const std::filesystem::path out = folder / "out";
  expect_good(run_command({"study", (folder / "quick.toml").string(), "-o", out.string()}));
  EXPECT_TRUE(has(read_text(out / "timeline.json"), "traceEvents"));
  const std::string page = read_text(out / "report.html");
  EXPECT_TRUE(has(page, "<a href=\"timeline.json\" download>"));
  EXPECT_TRUE(has(page, "What the units do with their cycles"));
}

TEST(StudyReport, NeedsResults) {
  const TemporaryFolder folder;
  expect_bad_input(run_command({"study", "report", folder.path().string()}), {"results.sqlite"});
}

}  // namespace
}  // namespace wedgesim::cli

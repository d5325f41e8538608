#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

struct Dump : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path trace = make_trace(folder);
};

TEST_F(Dump, PrintsTheTraceAsJson) {
  const Outcome outcome = run_command({"dump", trace.string()});
  expect_good(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("name"), "plain-columns");
  EXPECT_EQ(json.at("width"), 96);
  EXPECT_EQ(json.at("depth").size(), 96U * 64U);
  EXPECT_GT(json.at("wedges").size(), 10U);
}

TEST_F(Dump, WritesTheWedgesAsAMesh) {
  const std::filesystem::path mesh = folder / "wedges.obj";
  const Outcome outcome = run_command({"dump", trace.string(), "--obj", mesh.string()});
  expect_good(outcome);
  EXPECT_EQ(outcome.out, "");
  const std::string text = read_text(mesh);
  EXPECT_NE(text.find("\nv "), std::string::npos);
  EXPECT_NE(text.find("\nf "), std::string::npos);
}

TEST_F(Dump, BadFilesAreRefused) {
  expect_bad_input(run_command({"dump", (folder / "missing.wtrace").string()}),
                   {"missing.wtrace", "No such file"});
  expect_bad_input(run_command({"dump", folder.path().string()}), {folder.path().string()});
  write_text(folder / "text", "description = \"a scene, not a trace\"");
  expect_bad_input(run_command({"dump", (folder / "text").string()}), {"text"});
  write_text(folder / "empty", "");
  expect_bad_input(run_command({"dump", (folder / "empty").string()}), {"empty"});
}

TEST_F(Dump, AMeshThatCannotBeWrittenLeavesNothing) {
  const std::size_t before = folder.entries();
  expect_bad_input(run_command({"dump", trace.string(), "--obj", (trace / "wedges.obj").string()}),
                   {"wedges.obj"});
  expect_bad_input(run_command({"dump", trace.string(), "--obj", "/proc/wedges.obj"}),
                   {"/proc/wedges.obj"});
  EXPECT_EQ(folder.entries(), before);
}

}  // namespace
}  // namespace wedgesim::cli

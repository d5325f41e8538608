#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

using Json = nlohmann::json;

struct Study : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path out = folder / "out";

  Outcome study(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"study", "paper2", "-o", out.string(), "--size", "64x48"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
};

TEST_F(Study, PrintsTablesAndKeepsEverything) {
  const Outcome outcome = study({"--scenes", "plain-columns,cylinder"});
  expect_good(outcome);
  for (const char* word : {"plain-columns: 64x48", "cylinder: 64x48", "best tile at 0, 1, 2, 4",
                           "0 mismatched", "total / floor", "Paper II claims"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
  for (const std::string scene : {"plain-columns", "cylinder"}) {
    EXPECT_TRUE(std::filesystem::exists(out / (scene + ".wtrace")));
    for (const char* picture : {"_shaded", "_li", "_difference", "_z_reads", "_li_writes"}) {
      for (const char* kind : {".png", ".exr"}) {
        EXPECT_TRUE(std::filesystem::exists(out / (scene + picture + kind))) << picture << kind;
      }
    }
  }
  EXPECT_EQ(outcome.out.find(read_text(out / "summary.txt")), 0U);
  const Json result = Json::parse(read_text(out / "results.json"));
  EXPECT_EQ(result["schema"], "wedgesim.study/1");
  ASSERT_EQ(result["scenes"].size(), 2U);
  EXPECT_EQ(result["scenes"][1]["trace"]["name"], "cylinder");
  const std::size_t configs = result["scenes"][0]["configs"].size();
  const std::string csv = read_text(out / "results.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), 1 + 2 * configs);
  EXPECT_EQ(csv.find("trace,checksum,mode,tile,"), 0U);
}

TEST_F(Study, CountsAsCountDoes) {
  expect_good(study({"--scenes", "plain-columns"}));
  const Json result = Json::parse(read_text(out / "results.json"));
  const std::filesystem::path file = folder / "count.json";
  expect_good(run_command({"count", (out / "plain-columns.wtrace").string(), "--tile", "16",
                           "--cull", "sat", "--json", file.string()}));
  const Json counted = Json::parse(read_text(file))["configs"][0];
  const auto& configs = result["scenes"][0]["configs"];
  const auto found = std::find_if(configs.begin(), configs.end(), [&](const Json& config) {
    return config["mode"] == counted["mode"] && config["tile"] == 16 &&
           config["cull"] == counted["cull"] && config["share"] == counted["share"];
  });
  ASSERT_NE(found, configs.end());
  EXPECT_EQ((*found)["counters"], counted["counters"]);
}

TEST_F(Study, TheSameStudyGivesTheSameTables) {
  expect_good(study({"--scenes", "cylinder"}));
  const std::string csv = read_text(out / "results.csv");
  const std::string summary = read_text(out / "summary.txt");
  expect_good(study({"--scenes", "cylinder"}));
  EXPECT_EQ(read_text(out / "results.csv"), csv);
  EXPECT_EQ(read_text(out / "summary.txt"), summary);
}

TEST_F(Study, ASceneWithoutItsMeshIsLeftOutInOneLine) {
  write_text(folder / "broken.toml",
             "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
             "[light]\nshape = \"point\"\ncentre = [0.0, 9.0, 0.0]\n"
             "[[object]]\nshape = \"mesh\"\nfile = \"/nowhere/x.obj\"\n");
  const Outcome outcome = study({"--scenes", (folder / "broken.toml").string() + ",cylinder"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.find("left out: " + (folder / "broken.toml").string() + ":10: /nowhere"),
            0U)
      << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(out / "cylinder.wtrace"));
  EXPECT_NE(outcome.out.find("cylinder: 64x48"), std::string::npos);
}

TEST_F(Study, BadInputIsRefused) {
  expect_bad_input(run_command({"study", "paper9", "-o", out.string()}),
                   {"paper9", "no such study", "paper2"});
  expect_bad_input(study({"--scenes", "cylinder,,"}), {"--scenes", "empty"});
  expect_bad_input(run_command({"study", "paper2", "--size", "0x1", "-o", out.string()}),
                   {"--size", "0x1"});
  expect_bad_input(study({"--scenes", "cylinder,nowhere"}), {"nowhere: no such scene"});
  expect_bad_input(study({"--scenes", "cylinder,/nowhere/x.toml"}), {"/nowhere/x.toml"});
  expect_bad_input(study({"--scenes", "cylinder,cylinder"}), {"cylinder", "the same files"});
  EXPECT_EQ(folder.entries(), 0U);
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder / name);
    write_text(folder / name / "s.toml", "");
  }
  const std::string first = (folder / "a/s.toml").string();
  const std::string second = (folder / "b/s.toml").string();
  expect_bad_input(study({"--scenes", first + "," + second}),
                   {second + ": writes the same files as " + first});
  EXPECT_EQ(folder.entries(), 2U);
  write_text(folder / "file", "");
  out = folder / "file/out";
  expect_bad_input(study({"--scenes", "cylinder"}), {"file/out"});
  EXPECT_EQ(folder.entries(), 3U);
}

}  // namespace
}  // namespace wedgesim::cli

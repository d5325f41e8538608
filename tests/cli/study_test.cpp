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
  EXPECT_EQ(read_text(out / "summary.md").find("## paper2: "), 0U);
  const Json result = Json::parse(read_text(out / "results.json"));
  EXPECT_EQ(result["schema"], "wedgesim.study/1");
  ASSERT_EQ(result["frames"].size(), 2U);
  EXPECT_EQ(result["frames"][1]["trace"]["name"], "cylinder");
  EXPECT_EQ(result["points"].size(), 480U);
  const std::string csv = read_text(out / "results.csv");
  EXPECT_EQ(std::ranges::count(csv, '\n'), 481);
  EXPECT_EQ(csv.find("label,scene,checksum,"), 0U);
}

TEST_F(Study, CountsAsCountDoes) {
  expect_good(study({"--scenes", "plain-columns"}));
  const Json result = Json::parse(read_text(out / "results.json"));
  const std::filesystem::path file = folder / "count.json";
  expect_good(run_command({"count", (out / "plain-columns.wtrace").string(), "--tile", "16",
                           "--cull", "sat", "--json", file.string()}));
  const Json counted = Json::parse(read_text(file))["configs"][0];
  const auto& points = result["points"];
  const auto found = std::find_if(points.begin(), points.end(), [&](const Json& point) {
    const Json& config = point["configuration"];
    return config["block.mode"] == counted["mode"] && config["block.tile"] == 16 &&
           config["block.cull"] == "sat" && config["block.umbra_cull"] == "zmax" &&
           config["block.accept"] == "none" && config["block.share"] == counted["share"];
  });
  ASSERT_NE(found, points.end());
  for (const auto& [counter, value] : counted["counters"].items()) {
    EXPECT_EQ((*found)["metrics"][counter], value) << counter;
  }
  for (const char* metric : {"compared", "max_error", "rms_error", "mismatched"}) {
    EXPECT_EQ((*found)["metrics"][metric], counted["pixels"][metric]) << metric;
  }
}

TEST_F(Study, ASecondRunComputesNothing) {
  expect_good(study({"--scenes", "cylinder"}));
  const std::string csv = read_text(out / "results.csv");
  const std::string json = read_text(out / "results.json");
  const Outcome second = study({"--scenes", "cylinder"});
  expect_good(second);
  EXPECT_NE(second.out.find("All 240 points were there already: nothing was computed."),
            std::string::npos);
  EXPECT_EQ(read_text(out / "results.csv"), csv);
  EXPECT_EQ(read_text(out / "results.json"), json) << "timing, too";
}

TEST_F(Study, TheSameStudyGivesTheSameTables) {
  expect_good(study({"--scenes", "cylinder", "--jobs", "1"}));
  const std::string csv = read_text(out / "results.csv");
  const std::string summary = read_text(out / "summary.txt");
  out = folder / "other";
  expect_good(study({"--scenes", "cylinder", "--jobs", "3"}));
  EXPECT_EQ(read_text(out / "results.csv"), csv);
  EXPECT_EQ(read_text(out / "summary.txt"), summary);
}

TEST_F(Study, ASceneWithoutItsMeshFailsAndTheRestGoesOn) {
  write_text(folder / "broken.toml",
             "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
             "[light]\nshape = \"point\"\ncentre = [0.0, 9.0, 0.0]\n"
             "[[object]]\nshape = \"mesh\"\nfile = \"/nowhere/x.obj\"\n");
  const Outcome outcome = study({"--scenes", (folder / "broken.toml").string() + ",cylinder"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out.find("240 of 480 points could not be measured"), std::string::npos);
  EXPECT_NE(outcome.out.find((folder / "broken.toml").string() + ":10: /nowhere/x.obj"),
            std::string::npos)
      << outcome.out;
  EXPECT_TRUE(std::filesystem::exists(out / "cylinder.wtrace"));
  EXPECT_NE(outcome.out.find("cylinder: 64x48"), std::string::npos);
}

TEST_F(Study, ADryRunListsPointsAndSeconds) {
  const Outcome first = study({"--scenes", "cylinder", "--dry-run"});
  expect_good(first);
  EXPECT_EQ(std::ranges::count(first.out, '\n'), 242);
  EXPECT_EQ(first.out.find("cylinder count block.umbra_cull=none block.mode=three-pass "), 0U);
  EXPECT_NE(first.out.find("240 points, 0 there already; 1 frames to render\n"), std::string::npos);
  EXPECT_NE(first.out.find("a guess"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0U);
  expect_good(study({"--scenes", "cylinder"}));
  const Outcome second = study({"--scenes", "cylinder,overlap", "--dry-run"});
  EXPECT_NE(second.out.find("480 points, 240 there already; 1 frames to render\n"),
            std::string::npos);
  EXPECT_NE(second.out.find("from seconds recorded"), std::string::npos);
}

TEST_F(Study, MetricsAreListed) {
  const Outcome outcome = run_command({"study", "--metrics"});
  expect_good(outcome);
  for (const char* word :
       {"z_reads ", "over_floor ", "penumbra.busy_cycles ", "frames_per_second "}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
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
  expect_bad_input(study({"--scenes", "cylinder", "--jobs", "0"}), {"--jobs", "'0'"});
  expect_bad_input(study({"--scenes", "cylinder", "--shard", "3/2"}), {"--shard", "3/2", "i/n"});
  EXPECT_EQ(folder.entries(), 0U);
  for (const char* name : {"a", "b"}) {
    std::filesystem::create_directory(folder / name);
    write_text(folder / name / "s.toml",
               "[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n");
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

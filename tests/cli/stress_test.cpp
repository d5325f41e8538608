#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/image.h"
#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

struct Stress : testing::Test {
  TemporaryFolder folder;
  std::string file(const std::string& name) const { return (folder / name).string(); }
};

Outcome stress(std::vector<std::string> options) {
  options.insert(options.begin(), "stress");
  return run_command(options);
}

bool has(const Outcome& outcome, const std::string& words) {
  return outcome.out.find(words) != std::string::npos;
}

TEST_F(Stress, ReplayWritesPictureAndTrace) {
  const Outcome good = stress({"--replay", "frame-size,0,2", "-o", file("small")});
  expect_good(good);
  EXPECT_TRUE(has(good, "frame-size, seed 0, difficulty 2")) << good.out;
  EXPECT_TRUE(has(good, "5x3 pixels")) << good.out;
  const Image image = read_image(file("small.png"));
  EXPECT_EQ(image.width, 3 * 5 * 51 + 2 * 4);  // three panels, pixels of 51 by 51, two gaps
  EXPECT_EQ(image.height, 4 * 3 * 51 + 3 * 4);
  expect_good(run_command({"count", file("small.wtrace"), "--tile", "4"}));
}

TEST_F(Stress, ReplaySaysThatARefusedCaseHasNoPicture) {
  const Outcome refused = stress({"--replay", "touching-light,1,-3", "-o", file("none")});
  expect_good(refused);
  EXPECT_TRUE(has(refused, "refused: ")) << refused.out;
  EXPECT_TRUE(has(refused, "no picture and no trace")) << refused.out;
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_F(Stress, ReplayShowsWhatIsWrong) {
  // Far from what the fixed datapath can hold.
  const Outcome bad = stress({"--replay", "line-light,0,1e-8"});
  EXPECT_TRUE(has(bad, "does not hold")) << bad.out;
  EXPECT_TRUE(has(bad, "worst pixels")) << bad.out;
}

TEST_F(Stress, ShrinkNamesTheEdges) {
  const std::vector<std::string> options{"--replay", "line-light,0,1e-8", "--shrink",
                                         "--arithmetic"};
  const auto shrink = [&](const std::string& arithmetic) {
    std::vector<std::string> all = options;
    all.push_back(arithmetic);
    return stress(all);
  };
  const Outcome bad = shrink("fixed");
  EXPECT_TRUE(has(bad, " edges and polygons alone pass the bar")) << bad.out;
  EXPECT_TRUE(has(bad, ") to (")) << bad.out;
  EXPECT_TRUE(has(shrink("renderer"), "nothing to shrink"));
}

TEST_F(Stress, WritesAPageAndJson) {
  const Outcome good = stress({"--family", "frame-size", "--seeds", "2", "-o", file("out")});
  expect_good(good);
  EXPECT_TRUE(has(good, "1 of 1 families are as they must be")) << good.out;
  const std::string page = read_text(folder / "out/stress.html");
  EXPECT_NE(page.find("<h3 id=\"family-frame-size-heading\">frame-size</h3>"), std::string::npos);
  const auto json = nlohmann::json::parse(read_text(folder / "out/stress.json"));
  EXPECT_EQ(json["schema"], "wedgesim.stress/1");
  EXPECT_EQ(json["configuration"]["seeds"], 2);
  EXPECT_EQ(json["families"][0]["name"], "frame-size");
  EXPECT_EQ(json["families"][0]["holds_to"]["fixed"], json["families"][0]["required"]["fixed"]);
}

TEST_F(Stress, SaysWhatItIsAtOnATerminal) {
  const Outcome outcome = run_on_terminal({"stress", "--family", "frame-size", "--seeds", "1"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("frame-size (1 of 1)"), std::string::npos) << outcome.err;
}

TEST_F(Stress, BadCasesAreRefused) {
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> bad{
      {{"--replay", "offset"}, {"--replay", "'offset'", "FAMILY,SEED,DIFFICULTY"}},
      {{"--replay", "offset,0,1,2"}, {"--replay", "FAMILY,SEED,DIFFICULTY"}},
      {{"--replay", "nothing,0,1"}, {"'nothing'", "grazing-edge, "}},
      {{"--replay", "offset,-1,1"}, {"--replay", "'-1'", "a whole number"}},
      {{"--replay", "small-light,0,7"}, {"--replay", "'7'", "a number from 0 to 1"}},
      {{"--replay", "overlap,0,2.5"}, {"--replay", "'2.5'", "a multiple of 1 from 1 to 1000"}},
      {{"--replay", "vertex-degree,0,3"}, {"'3'", "a multiple of 2 from 2 to 8"}},
      {{"--replay", "small-light,0,nan"}, {"--replay", "'nan'"}},
      {{"--replay", "small-light,0,1", "--family", "offset"}, {"--family", "--replay"}},
      {{"--replay", "small-light,0,1", "--json", file("x")}, {"--json", "--replay"}},
      {{"--replay", "small-light,0,1", "-o", "/proc/x"}, {"/proc/x"}},
      {{"--replay", "small-light,0,1", "-o", file("d/")}, {"d/", "a file name"}},
      {{"--replay", "small-light,0,1", "-o", "."}, {"a file name"}},
      {{"--family", "frame-size", "-o", file("a"), "--json", file("a/stress.html")},
       {"a/stress.html", "written twice"}},
      {{"--replay", "small-light,0,1", "--shrink", "--arithmetic", "int"},
       {"--arithmetic", "'int'", "fixed, float32, double, renderer"}},
      {{"--replay", "small-light,0,1", "--arithmetic", "fixed"}, {"--arithmetic", "--shrink"}},
      {{"--shrink"}, {"--shrink", "--replay"}},
      {{"--arithmetic", "fixed"}, {"--arithmetic", "--shrink"}},
      {{"--family", "frame-size", "-o", "/proc/x"}, {"/proc/x"}},
      {{"--family", "frame-size", "--json", "/proc/x"}, {"/proc/x"}},
      {{"--family", "nothing"}, {"'nothing'"}},
      {{"--family", "offset,offset"}, {"--family", "twice"}},
      {{"--seeds", "0"}, {"--seeds", "'0'"}},
  };
  for (const auto& [options, words] : bad) {
    expect_bad_input(stress(options), words);
    EXPECT_EQ(folder.entries(), 0U) << options.back();
  }
}

}  // namespace
}  // namespace wedgesim::cli

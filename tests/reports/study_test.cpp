#include "reports/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "reports/accesses.h"
#include "reports/sweep.h"
#include "tests/base/temporary_folder.h"

namespace wedgesim::reports {
namespace {

Study small_study() {
  Study study = built_in_study("paper2");
  study.scenes = {"cylinder"};
  study.size = {32, 24};
  Sweep sweep;
  sweep.modes = {model::Mode::three_pass, model::Mode::single_pass};
  sweep.tiles = {4, 8};
  study.configs = sweep.configs();
  return study;
}

TEST(Study, Paper2CoversWhatPaper2Asks) {
  const Study study = built_in_study("paper2");
  EXPECT_EQ(study.scenes,
            (std::vector<std::string>{"plain-columns", "columns", "fractal", "text2002", "bunny"}));
  EXPECT_EQ(tiles_of(study).size(), 8U);
  const auto has = [&study](const model::CountConfig& config) {
    return std::ranges::count(study.configs, config) == 1;
  };
  for (const model::Mode mode : {model::Mode::three_pass, model::Mode::single_pass}) {
    for (const unsigned tile : all_tiles()) {
      for (const model::Cull cull : {model::Cull::none, model::Cull::zmax, model::Cull::zrange,
                                     model::Cull::planes, model::Cull::both, model::Cull::sat}) {
        EXPECT_TRUE(has({mode, tile, cull}));
      }
      EXPECT_TRUE(has({mode, tile, model::Cull::none, model::UmbraCull::none}));
      EXPECT_TRUE(
          has({mode, tile, model::Cull::both, model::UmbraCull::zmax, model::Accept::zmin}));
    }
  }
  EXPECT_TRUE(has(study.pictured));
  EXPECT_EQ(study.pictured.tile, 8U);
}

TEST(Study, UnknownStudiesAreRefused) { EXPECT_THROW(built_in_study("paper9"), InputError); }

TEST(Study, CountsEveryConfigurationAndSaysWhatItDoes) {
  const TemporaryFolder folder;
  std::vector<std::string> steps;
  const StudyResults results = run_study(small_study(), folder.path(),
                                         [&](std::string_view what) { steps.emplace_back(what); });
  ASSERT_EQ(results.scenes.size(), 1U);
  EXPECT_TRUE(held(results));
  EXPECT_EQ(results.scenes.front().results.size(), 4U);
  EXPECT_EQ(results.scenes.front().trace.width, 32U);
  ASSERT_FALSE(steps.empty());
  EXPECT_EQ(steps.front(), "paper2: cylinder: rendering");
  EXPECT_EQ(folder.entries(), 1U + 10U + 3U) << "trace, pictures, results";
}

TEST(Study, AWrongPixelOfAnySceneFails) {
  const TemporaryFolder folder;
  Study study = small_study();
  study.scenes = {"cylinder", "plain-columns"};
  StudyResults results = run_study(study, folder.path(), [](std::string_view) {});
  EXPECT_TRUE(held(results));
  results.scenes.front().results.back().pixels.mismatched = 1;
  EXPECT_FALSE(held(results));
}

TEST(Study, ASceneThatCannotBeLoadedIsLeftOut) {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty.toml") << "";
  Study study = small_study();
  study.scenes = {(folder / "empty.toml").string(), "cylinder"};
  const StudyResults results = run_study(study, folder.path(), [](std::string_view) {});
  ASSERT_EQ(results.scenes.size(), 2U);
  EXPECT_NE(results.scenes[0].failure.find("empty.toml"), std::string::npos);
  EXPECT_TRUE(results.scenes[0].results.empty());
  EXPECT_EQ(results.scenes[1].failure, "");
}

TEST(Study, ScenesAreLookedForBeforeAnyWork) {
  const TemporaryFolder folder;
  const auto refuse = [&folder](const std::vector<std::string>& scenes) {
    Study study = small_study();
    study.scenes = scenes;
    bool worked = false;
    const auto progress = [&worked](std::string_view) { worked = true; };
    EXPECT_THROW(run_study(study, folder / "out", progress), InputError) << scenes.back();
    EXPECT_FALSE(worked) << scenes.back();
    EXPECT_FALSE(std::filesystem::exists(folder / "out")) << scenes.back();
  };
  refuse({"cylinder", "nowhere"});
  refuse({"cylinder", "/nowhere/x.toml"});
  refuse({"cylinder", "cylinder"});
  std::ofstream(folder / "cylinder.toml") << "";
  refuse({"cylinder", (folder / "cylinder.toml").string()});
}

TEST(Study, AFolderThatCannotBeMadeIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_THROW(run_study(small_study(), folder / "file/out", [](std::string_view) {}), InputError);
}

}  // namespace
}  // namespace wedgesim::reports

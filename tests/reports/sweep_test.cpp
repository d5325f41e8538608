#include "reports/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace wedgesim::reports {
namespace {

TEST(Sweep, TheDefaultIsTheDefaultConfiguration) {
  EXPECT_EQ(Sweep().configs(), std::vector{model::CountConfig{}});
}

TEST(Sweep, CombinesAllSetsInOrder) {
  Sweep sweep;
  sweep.modes = {model::Mode::three_pass, model::Mode::single_pass};
  sweep.tiles = {4, 16};
  sweep.accepts = {model::Accept::none, model::Accept::zmin};
  sweep.z = model::ZChoice::fail;
  sweep.tile_build = model::TileBuild::lazy;
  const auto configs = sweep.configs();
  ASSERT_EQ(configs.size(), 8U);
  EXPECT_EQ(configs[1].accept, model::Accept::zmin);
  EXPECT_EQ(configs[2].tile, 16U);
  EXPECT_EQ(configs[4].mode, model::Mode::single_pass);
  EXPECT_TRUE(std::ranges::all_of(configs, [](const model::CountConfig& config) {
    return config.z == model::ZChoice::fail && config.tile_build == model::TileBuild::lazy;
  }));
}

TEST(Sweep, AllTilesAreThePowersOfTwoTo256) {
  EXPECT_EQ(all_tiles(), (std::vector<unsigned>{2, 4, 8, 16, 32, 64, 128, 256}));
}

}  // namespace
}  // namespace wedgesim::reports

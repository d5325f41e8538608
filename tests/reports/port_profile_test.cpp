#include "reports/port_profile.h"

#include <gtest/gtest.h>

namespace wedgesim::reports {
namespace {

using model::memory::MemoryRecord;

constexpr std::uint64_t kWindow = PortProfile::kWindowCycles;

TEST(PortProfile, ThePeakIsOfTheBusiestWindow) {
  PortProfile profile(1);
  EXPECT_EQ(profile.peak_bytes_per_cycle(), 0.0);
  // The last cycle of the first window, the first of the second, and one long after.
  for (const std::uint64_t cycle : {kWindow - 1, kWindow, kWindow + 1, 9 * kWindow}) {
    profile.add({.cycle = cycle, .bytes = 512});
  }
  EXPECT_EQ(profile.peak_bytes_per_cycle(), 2.0 * 512 / kWindow);
}

TEST(PortProfile, OrderDoesNotMatter) {
  PortProfile profile(1);
  for (const std::uint64_t cycle : {5 * kWindow, std::uint64_t{0}, 5 * kWindow + 1}) {
    profile.add({.cycle = cycle, .bytes = 64});
  }
  EXPECT_EQ(profile.peak_bytes_per_cycle(), 2.0 * 64 / kWindow);
}

TEST(PortProfile, ATileHasTheBytesThatNameIt) {
  PortProfile profile(3);
  profile.add({.bytes = 64, .tile = 2});
  profile.add({.write = true, .bytes = 64, .tile = 2});
  profile.add({.bytes = 128, .tile = 0});
  profile.add({.bytes = 1000});  // of no tile
  EXPECT_EQ(profile.tile_bytes(), (std::vector<std::uint64_t>{128, 0, 128}));
}

}  // namespace
}  // namespace wedgesim::reports

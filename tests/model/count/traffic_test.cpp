#include "model/count/traffic.h"

#include <gtest/gtest.h>

namespace wedgesim::model {
namespace {

void set_counted(Counters& counters, std::uint64_t stencil_writes) {
  counters.z_reads = 100;
  counters.tile_reads = 10;
  counters.tile_build_reads = 20;
  counters.li_writes = 50;
  counters.stencil_writes = stencil_writes;
  counters.wedge_bytes = 1000;
}

TEST(Traffic, ThreePassMergesAndClearsTheStencil) {
  Counters counters;
  set_counted(counters, 30);
  finish_traffic(counters, Mode::three_pass, traces::fb::DepthFormat_unorm24, 64, 7);
  EXPECT_EQ(counters.stencil_reads.value(), 30u);
  EXPECT_EQ(counters.li_reads.value(), 20u);
  EXPECT_EQ(counters.merge_reads.value(), 64u + 7u);
  EXPECT_EQ(counters.merge_writes.value(), 7u);
  EXPECT_EQ(counters.clear_writes.value(), 128u);
  // Depth 4 * (100 + 10 + 20); LI 2 * (20 + 20, merge 7 + 7, clear 64); stencil 30 + 30, merge 64,
  // clear 64; records.
  EXPECT_EQ(counters.all_bytes.value(), 520u + 2 * 118u + 188u + 1000u);
}

TEST(Traffic, SinglePassHasNoStencil) {
  Counters counters;
  set_counted(counters, 0);
  finish_traffic(counters, Mode::single_pass, traces::fb::DepthFormat_unorm16, 64, 7);
  EXPECT_EQ(counters.stencil_reads.value(), 0u);
  EXPECT_EQ(counters.li_reads.value(), 50u);
  EXPECT_EQ(counters.merge_reads.value(), 0u);
  EXPECT_EQ(counters.merge_writes.value(), 0u);
  EXPECT_EQ(counters.clear_writes.value(), 64u);
  // Depth 2 * (100 + 10 + 20); LI 2 * (50 + 50, clear 64); records.
  EXPECT_EQ(counters.all_bytes.value(), 260u + 2 * 164u + 1000u);
}

TEST(Traffic, TakesWordsAtTheirWidths) {
  EXPECT_EQ(bytes_of_bits(8), 1u);
  EXPECT_EQ(bytes_of_bits(9), 2u);
  EXPECT_EQ(bytes_of_bits(16), 2u);
  EXPECT_EQ(bytes_of_bits(17), 4u);
  EXPECT_EQ(bytes_of_bits(48), 8u);
  Counters counters;
  set_counted(counters, 30);
  finish_traffic(counters, Mode::three_pass, traces::fb::DepthFormat_unorm24, 64, 7, {8, 2});
  EXPECT_EQ(counters.all_bytes.value(), 520u + 8 * 118u + 2 * 188u + 1000u);
}

}  // namespace
}  // namespace wedgesim::model

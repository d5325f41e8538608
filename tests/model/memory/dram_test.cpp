#include "model/memory/dram.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace wedgesim::model::memory {
namespace {

/// One channel, two groups of two banks, rows of 256 bytes, numbers easy to tell apart; no refresh
/// in sight. The block's clock is the memory's.
DramConfig simple() {
  DramConfig c;
  c.clock_mhz = 1000;
  c.channels = 1;
  c.bank_groups = 2;
  c.banks = 4;
  c.row_bytes = 256;
  c.burst_bytes = c.interleave_bytes = 32;
  c.burst_cycles = 4;
  c.ccd_s = 5;
  c.ccd_l = 6;
  c.read_latency = 20;
  c.write_latency = 10;
  c.rcd_read = c.rcd_write = 15;
  c.rp = 14;
  c.ras = 33;
  c.rrd_s = 5;
  c.rrd_l = 7;
  c.faw = 30;
  c.rtp = 8;
  c.wr = 16;
  c.wtr_s = 3;
  c.wtr_l = 9;
  c.turnaround = 2;
  c.refi = 1'000'000;
  c.rfc = 100;
  return c;
}

// Addresses of simple(): bit 5 is the group, bits 6 to 8 the column's upper part, bit 9 the bank
// within its group, bits 10 and up the row. A row holds 8 bursts.
constexpr std::uint64_t kGroup1 = 32, kColumn1 = 64, kBank1 = 512, kRow1 = 1024;

/// Is an access that arrived done at a cycle, and not at the cycle before?
void expect_ready(Cycle done, Cycle cycle) {
  EXPECT_FALSE(done <= cycle - 1) << "ready one cycle early: " << done;
  EXPECT_TRUE(done <= cycle) << "ready late: " << done;
}

TEST(Dram, ClosedBankIsActivated) {
  Dram dram(simple(), 1000);
  // ACT 100, RD 100 + 15, data from 115 + 20 for 4 cycles.
  expect_ready(dram.access(0, 32, false, 100), 139);
  EXPECT_EQ(dram.counters().row_misses.value(), 1U);
}

TEST(Dram, OpenRowIsRead) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);
  expect_ready(dram.access(kColumn1, 32, false, 100), 124);  // RD 100, data 120 to 124
  EXPECT_EQ(dram.counters().row_hits.value(), 1U);
}

TEST(Dram, AnotherRowIsClosedFirst) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);
  // PRE 100 (33 after ACT 0, 8 after RD 15), ACT 114, RD 129, data 149 to 153.
  expect_ready(dram.access(kRow1, 32, false, 100), 153);
  EXPECT_EQ(dram.counters().row_conflicts.value(), 1U);
}

TEST(Dram, ARowStaysOpenItsLeastTime) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);
  // PRE 33 (ACT 0 + 33), ACT 47, RD 62, data 82 to 86.
  expect_ready(dram.access(kRow1, 32, false, 1), 86);
}

TEST(Dram, WrittenDataArriveBeforeTheRowCloses) {
  Dram dram(simple(), 1000);
  // ACT 0, WR 15, data 25 to 29.
  expect_ready(dram.access(0, 32, true, 0), 29);
  // PRE 29 + 16 = 45, ACT 59, RD 74, data 94 to 98.
  expect_ready(dram.access(kRow1, 32, false, 1), 98);
}

TEST(Dram, ReadMayCloseItsRowAfterRtp) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);
  dram.access(kColumn1, 32, false, 60);  // RD 60
  // PRE 68, ACT 82, RD 97, data 117 to 121.
  expect_ready(dram.access(kRow1, 32, false, 61), 121);
}

TEST(Dram, ColumnsOfAGroupAreFartherApart) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);                                        // ACT 0
  dram.access(kGroup1, 32, false, 0);                                  // ACT 5
  expect_ready(dram.access(0, 32, false, 100), 124);                   // RD 100
  expect_ready(dram.access(kGroup1, 32, false, 100), 129);             // RD 105: ccd_s
  expect_ready(dram.access(kGroup1 + kColumn1, 32, false, 100), 135);  // RD 111: ccd_l
}

TEST(Dram, BanksArePreparedWhileAnotherDelivers) {
  Dram dram(simple(), 1000);
  expect_ready(dram.access(0, 32, false, 0), 39);        // ACT 0, RD 15
  expect_ready(dram.access(kGroup1, 32, false, 0), 44);  // ACT 5: rrd_s; RD 20
  // Group 0 again: ACT max(0 + 7, 5 + 5) = 10, RD 25, data 45 to 49.
  expect_ready(dram.access(kBank1, 32, false, 0), 49);
}

TEST(Dram, ActivatesOfAGroupAreFartherApart) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);                         // ACT 0, RD 15
  expect_ready(dram.access(kBank1, 32, false, 0), 46);  // ACT 7: rrd_l; RD 22
}

TEST(Dram, FourActivatesFillTheWindow) {
  DramConfig config = simple();
  config.banks = 8;  // bank in group: bits 9 and 10
  Dram dram(config, 1000);
  dram.access(0, 32, false, 0);                                       // ACT 0
  dram.access(kGroup1, 32, false, 0);                                 // ACT 5
  dram.access(kBank1, 32, false, 0);                                  // ACT 10
  dram.access(kBank1 + kGroup1, 32, false, 0);                        // ACT 15
  expect_ready(dram.access(2 * kBank1, 32, false, 0), 69);            // ACT 0 + 30, RD 45
  expect_ready(dram.access(2 * kBank1 + kGroup1, 32, false, 0), 74);  // ACT 5 + 30, RD 50
}

TEST(Dram, TheBusTurnsAround) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 0);
  dram.access(kGroup1, 32, false, 0);
  dram.access(0, 32, false, 100);  // RD 100, data 120 to 124
  // Data may start at 124 + 2: WR 116, data 126 to 130.
  expect_ready(dram.access(kGroup1, 32, true, 100), 130);
  // RD of the other group 130 + 3 = 133, data 153 to 157.
  expect_ready(dram.access(0, 32, false, 100), 157);
}

TEST(Dram, ReadAfterWriteInAGroupWaitsLonger) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, true, 0);                            // WR 15, data 25 to 29
  expect_ready(dram.access(kColumn1, 32, false, 0), 62);  // RD 29 + 9 = 38, data 58 to 62
}

TEST(Dram, RefreshClosesAllBanksAndTakesItsTime) {
  DramConfig config = simple();
  config.refi = 1000;
  Dram dram(config, 1000);
  dram.access(0, 32, false, 0);
  // A column at 999 still goes before the refresh that is due at 1000 ...
  expect_ready(dram.access(0, 32, false, 999), 1023);
  EXPECT_EQ(dram.counters().refreshes.value(), 0U);
  // ... one at 1000 does not: PRE 999 + 8 = 1007, REF 1021, ACT 1121, RD 1136, data 1156 to 1160.
  expect_ready(dram.access(0, 32, false, 1000), 1160);
  EXPECT_EQ(dram.counters().refreshes.value(), 1U);
  EXPECT_EQ(dram.counters().row_misses.value(), 2U);
}

TEST(Dram, RefreshesOfAnIdleTimeAreOnTime) {
  DramConfig config = simple();
  config.refi = 1000;
  Dram dram(config, 1000);
  // REF 1000, 2000, ... 5000; ACT 5100, RD 5115, data 5135 to 5139.
  expect_ready(dram.access(0, 32, false, 5050), 5139);
  EXPECT_EQ(dram.counters().refreshes.value(), 5U);
}

TEST(Dram, TheQueueBoundsHowFarAheadBanksArePrepared) {
  DramConfig config = simple();
  config.queue_bursts = 1;
  Dram dram(config, 1000);
  dram.access(0, 32, false, 0);  // ACT 0, RD 15
  // ACT only when the burst before has left, at 15; RD 30, data 50 to 54.
  expect_ready(dram.access(kGroup1, 32, false, 0), 54);
}

TEST(Dram, ClocksAreConvertedExactly) {
  // Memory at 1000 MHz, block at 300: block cycle 100 is memory cycle 333.3, so the access
  // arrives at 334, is done at 373, and 373 memory cycles are 111.9 block cycles.
  Dram dram(simple(), 300);
  expect_ready(dram.access(0, 32, false, 100), 112);
  // 1750 MHz, block at 1750 / 2: no rounding. 39 memory cycles after 2000 are block cycle 1019.5.
  DramConfig config = simple();
  config.clock_mhz = 1750;
  Dram even(config, 875);
  expect_ready(even.access(0, 32, false, 1000), 1020);
}

TEST(Dram, AnAccessIsSplitIntoBursts) {
  Dram dram(simple(), 1000);
  // Bytes 40 to 103 lie in bursts 1, 2, 3: groups 1, 0, 1.
  dram.access(40, 64, false, 0);
  EXPECT_EQ(dram.counters().reads.value(), 1U);
  EXPECT_EQ(dram.counters().read_bursts.value(), 3U);
  EXPECT_EQ(dram.counters().bytes.value(), 96U);
  EXPECT_EQ(dram.counters().data_bus_cycles.value(), 12U);
  EXPECT_EQ(dram.counters().row_hits.value(), 1U);
}

TEST(Dram, PresetsHaveTheirFirstAccessTime) {
  const auto first = [](std::string_view name) {
    const DramConfig& config = dram_preset(name, "test");
    return Dram(config, config.clock_mhz).access(0, 32, false, 0);
  };
  expect_ready(first("lpddr4-3200"), 29 + 31 + 8);  // tRCD + RL and tDQSCK + BL/2
  expect_ready(first("gddr6-14000"), 26 + 24 + 2);
  expect_ready(first("hbm2-2000"), 12 + 18 + 2);
}

TEST(Dram, PresetsStreamNearTheirPeak) {
  for (const DramPreset& preset : dram_presets()) {
    SCOPED_TRACE(preset.name);
    Dram dram(preset.config, 500);
    Cycle done = 0;
    constexpr std::uint64_t kBytes = 4 << 20;
    for (std::uint64_t address = 0; address < kBytes; address += 64) {
      done = dram.access(address, 64, false, 0);
    }
    const double share = kBytes / (static_cast<double>(done) * dram.peak_bytes_per_cycle());
    // Refresh takes rfc / refi, 6 or 7 %, and what closing and opening the rows again costs.
    EXPECT_GT(share, 0.88);
    EXPECT_LT(share, 1.0 - 0.9 * preset.config.rfc / preset.config.refi);
  }
}

TEST(Dram, TimeMustNotRunBackwards) {
  Dram dram(simple(), 1000);
  dram.access(0, 32, false, 10);
  EXPECT_THROW(dram.access(0, 32, false, 9), CheckError);
}

}  // namespace
}  // namespace wedgesim::model::memory

#include "model/memory/dram_channel.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "tests/model/memory/dram_rules.h"

namespace wedgesim::model::memory {
namespace {

/// Where a burst goes, by the bits of its address.
Dram::Place place_of(const DramConfig& c, std::uint64_t address) {
  const auto bits = [](int value) { return std::countr_zero(static_cast<unsigned>(value)); };
  int low = bits(c.interleave_bytes);
  const auto field = [&](int width) {
    const auto value = static_cast<unsigned>(address >> low & ((std::uint64_t{1} << width) - 1));
    low += width;
    return value;
  };
  Dram::Place place;
  place.channel = field(bits(c.channels));
  const unsigned group = field(bits(c.bank_groups));
  field(bits(c.row_bytes) - bits(c.interleave_bytes));
  place.bank = field(bits(c.banks) - bits(c.bank_groups)) << bits(c.bank_groups) | group;
  place.row = address >> low;
  return place;
}

DramConfig random_config(std::mt19937_64& random) {
  const auto number = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  DramConfig c;
  for (const DramKey& key : kDramKeys) {
    c.*key.value = key.power_of_two ? 1 << number(0, 3) : number(key.low, 40);
  }
  c.clock_mhz = number(100, 3000);
  c.banks *= c.bank_groups;
  c.burst_bytes *= 8;
  c.interleave_bytes = c.burst_bytes << number(0, 2);
  c.row_bytes = std::max(64, c.interleave_bytes << number(0, 4));
  c.refi = number(100, 3000);
  c.rfc = number(1, 99);
  return c;
}

/// Bursts of neighbours, leaps, pauses: addresses near each other, so that rows are hit.
void expect_rules(const DramConfig& config, unsigned seed) {
  std::mt19937_64 random(seed);
  const int block_mhz = 100 + static_cast<int>(random() % 2000);
  Dram dram(config, block_mhz);
  std::vector<DramCommand> commands;
  dram.listen([&](const DramCommand& command) { commands.push_back(command); });
  DramRules rules(config);
  const auto memory = static_cast<std::int64_t>(config.clock_mhz);
  const auto block = static_cast<std::int64_t>(block_mhz);
  std::int64_t at = 0;
  std::uint64_t address = 0;
  for (int round = 0; round < 2000 && !testing::Test::HasFailure(); ++round) {
    if (random() % 2 == 0) at += static_cast<std::int64_t>(random() % 30);
    if (random() % 300 == 0) at += 4 * config.refi;
    address = random() % 4 == 0 ? random() % (1 << 18) : address + 64;
    const auto bytes = static_cast<unsigned>(1 + random() % 200);
    const auto done = static_cast<std::int64_t>(
        dram.access(address, bytes, random() % 3 == 0, static_cast<Cycle>(at)));
    std::vector<Dram::Place> places;
    const auto step = static_cast<std::uint64_t>(config.burst_bytes);
    for (std::uint64_t burst = address / step * step; burst < address + bytes; burst += step) {
      places.push_back(place_of(config, burst));
    }
    std::int64_t arrival = at * memory / block;
    if (arrival * block < at * memory) ++arrival;
    const std::int64_t end = rules.take(commands, arrival, places);
    ASSERT_GE(done * memory, end * block);
    ASSERT_LT((done - 1) * memory, end * block);
    commands.clear();
  }
}

TEST(DramChannel, EveryCommandIsAsEarlyAsTheRulesAllow) {
  for (const DramPreset& preset : dram_presets()) {
    SCOPED_TRACE(preset.name);
    expect_rules(preset.config, 1);
  }
  for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    expect_rules(random_config(random), seed);
  }
}

}  // namespace
}  // namespace wedgesim::model::memory

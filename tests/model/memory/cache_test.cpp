#include "model/memory/cache.h"

#include <gtest/gtest.h>

#include <list>
#include <map>
#include <random>
#include <vector>

#include "tests/support/expect_input_error.h"

namespace wedgesim::model::memory {
namespace {

std::vector<std::uint64_t> flushed(Cache& cache) {
  std::vector<std::uint64_t> lines;
  cache.flush([&](std::uint64_t line, std::size_t) { lines.push_back(line); });
  return lines;
}

TEST(Cache, ALineThatCameInIsHit) {
  Cache cache({256, 64, 2});
  const Cache::Access first = cache.access(64, false);
  EXPECT_FALSE(first.hit);
  EXPECT_TRUE(first.fill);
  EXPECT_FALSE(first.write_back);
  const Cache::Access second = cache.access(64, false);
  EXPECT_TRUE(second.hit);
  EXPECT_FALSE(second.fill);
  EXPECT_EQ(second.slot, first.slot);
  EXPECT_EQ(cache.hits(), 1U);
  EXPECT_EQ(cache.misses(), 1U);
}

TEST(Cache, TheLeastRecentlyUsedLineGoesOut) {
  Cache cache({256, 64, 2});  // 2 sets: lines 0, 2, 4, ... and 1, 3, 5, ...
  cache.access(0 * 64, true);
  cache.access(2 * 64, true);
  cache.access(0 * 64, false);
  const Cache::Access third = cache.access(4 * 64, false);
  ASSERT_TRUE(third.write_back);
  EXPECT_EQ(*third.write_back, 2U * 64);
  EXPECT_TRUE(cache.access(0 * 64, false).hit);
  EXPECT_EQ(cache.evictions(), 1U);
}

TEST(Cache, ACleanLineGoesOutSilently) {
  Cache cache({64, 64, 1});
  cache.access(0, false);
  EXPECT_FALSE(cache.access(64, true).write_back);
  EXPECT_EQ(cache.evictions(), 1U);
  EXPECT_EQ(cache.write_backs(), 0U);
}

TEST(Cache, FlushVisitsDirtyLinesOnceSetBySet) {
  Cache cache({256, 64, 2});
  cache.access(3 * 64, true);
  cache.access(2 * 64, true);
  cache.access(0 * 64, false);
  cache.access(1 * 64, true);
  EXPECT_EQ(flushed(cache), (std::vector<std::uint64_t>{2 * 64, 3 * 64, 1 * 64}));
  EXPECT_EQ(flushed(cache), std::vector<std::uint64_t>{});
  EXPECT_TRUE(cache.access(2 * 64, false).hit);
  EXPECT_EQ(cache.write_backs(), 3U);
}

TEST(Cache, ALineIsReadyWhenItsUserSaysSo) {
  Cache cache({64, 64, 1});
  const std::size_t slot = cache.access(0, false).slot;
  cache.set_ready(slot, 500);
  EXPECT_EQ(cache.ready(cache.access(0, false).slot), 500U);
  EXPECT_EQ(cache.ready(cache.access(64, false).slot), 0U);  // another line, not yet set
}

TEST(Cache, WithoutACacheReadsMissAndWritesGoThrough) {
  Cache cache({0, 64, 4});
  for (int round = 0; round < 2; ++round) {
    const Cache::Access read = cache.access(128, false);
    EXPECT_FALSE(read.hit);
    EXPECT_TRUE(read.fill);
    EXPECT_FALSE(read.write_back);
    EXPECT_EQ(read.slot, Cache::kNoSlot);
    const Cache::Access write = cache.access(128, true);
    EXPECT_FALSE(write.hit);
    EXPECT_FALSE(write.fill);
    EXPECT_EQ(write.write_back, std::optional<std::uint64_t>(128));
  }
  EXPECT_EQ(cache.misses(), 4U);
  EXPECT_EQ(cache.write_backs(), 2U);
  EXPECT_EQ(flushed(cache), std::vector<std::uint64_t>{});
}

/// A set as a list, most recently used first: what the cache must do, written the plain way.
struct NaiveCache {
  std::size_t sets, ways;
  std::map<std::uint64_t, std::list<std::pair<std::uint64_t, bool>>> lists;

  std::pair<bool, std::optional<std::uint64_t>> access(std::uint64_t line, bool write) {
    auto& list = lists[line % sets];
    for (auto it = list.begin(); it != list.end(); ++it) {
      if (it->first == line) {
        const bool dirty = it->second || write;
        list.erase(it);
        list.push_front({line, dirty});
        return {true, {}};
      }
    }
    std::optional<std::uint64_t> out;
    if (list.size() == ways) {
      if (list.back().second) out = list.back().first * 64;
      list.pop_back();
    }
    list.push_front({line, write});
    return {false, out};
  }
};

TEST(Cache, EqualsAListPerSetOnRandomAccesses) {
  constexpr unsigned kSeed = 7;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (const CacheConfig config : {CacheConfig{1024, 64, 1}, CacheConfig{1024, 64, 4},
                                   CacheConfig{1024, 64, 16}, CacheConfig{4096, 64, 64}}) {
    Cache cache(config);
    NaiveCache naive{static_cast<std::size_t>(config.size_bytes / 64 / config.ways),
                     static_cast<std::size_t>(config.ways),
                     {}};
    for (int round = 0; round < 20000; ++round) {
      const std::uint64_t line = random() % 100;
      const bool write = random() % 3 == 0;
      const Cache::Access access = cache.access(line * 64, write);
      const auto [hit, out] = naive.access(line, write);
      ASSERT_EQ(access.hit, hit);
      ASSERT_EQ(access.write_back, out);
    }
    EXPECT_EQ(cache.hits() + cache.misses(), 20000U);
  }
}

TEST(Cache, KeysAreChecked) {
  const auto error = [](CacheConfig config) {
    return input_error_of([&] { Cache cache(config, "block.toml:9"); });
  };
  EXPECT_EQ(error({32, 64, 1}),
            "block.toml:9: 'size_bytes' is 32; expected a power of two from 64 to 67108864");
  EXPECT_EQ(error({96, 32, 1}),
            "block.toml:9: 'size_bytes' is 96; expected a power of two from 32 to 67108864");
  EXPECT_EQ(error({1024, 48, 1}),
            "block.toml:9: 'line_bytes' is 48; expected a power of two from 8 to 4096");
  EXPECT_EQ(error({128, 64, 4}), "block.toml:9: 'ways' is 4; expected a power of two from 1 to 2");
  EXPECT_EQ(error({8192, 64, 3}),
            "block.toml:9: 'ways' is 3; expected a power of two from 1 to 64");
}

}  // namespace
}  // namespace wedgesim::model::memory

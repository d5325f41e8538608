#include "model/memory/ideal_memory.h"

#include <gtest/gtest.h>

#include "tests/support/expect_input_error.h"

namespace wedgesim::model::memory {
namespace {

TEST(IdealMemory, TakesItsLatencyAfterTheLastByte) {
  IdealMemory memory({100, 32});
  EXPECT_EQ(memory.access(0, 64, false, 10), 10U + 2 + 100);
  EXPECT_EQ(memory.access(0, 1, false, 1000), 1000U + 1 + 100);
}

TEST(IdealMemory, LatencyOverlapsBandwidthDoesNot) {
  IdealMemory memory({500, 64});
  for (Cycle n = 1; n <= 10; ++n) EXPECT_EQ(memory.access(0, 64, n % 2 == 0, 0), n + 500);
  EXPECT_EQ(memory.access(0, 64, false, 100), 601U);  // the pipe is free again
}

TEST(IdealMemory, SmallAccessesShareACycle) {
  IdealMemory memory({0, 64});
  for (int n = 0; n < 4; ++n) EXPECT_EQ(memory.access(0, 16, false, 5), 6U);
  EXPECT_EQ(memory.access(0, 16, false, 5), 7U);
}

TEST(IdealMemory, CountsBytes) {
  IdealMemory memory({1, 64});
  memory.access(0, 64, false, 0);
  memory.access(0, 64, false, 0);
  memory.access(0, 32, true, 0);
  const std::uint64_t expected[] = {2, 1, 128, 32};  // reads, writes, read_bytes, write_bytes
  std::size_t index = 0;
  for (const Counter* counter : memory.statistics().counters()) {
    EXPECT_EQ(counter->value(), expected[index++]) << counter->name();
  }
  EXPECT_EQ(memory.peak_bytes_per_cycle(), 64.0);
}

TEST(IdealMemory, TimeMustNotRunBackwards) {
  IdealMemory memory({1, 64});
  memory.access(0, 64, false, 10);
  EXPECT_THROW(memory.access(0, 64, false, 9), CheckError);
}

TEST(IdealMemory, KeysAreChecked) {
  EXPECT_EQ(input_error_of([] {
              IdealMemory memory({-1, 64}, "b.toml:2");
            }),
            "b.toml:2: 'latency_cycles' is -1; expected an integer from 0 to 1000000");
  EXPECT_EQ(input_error_of([] {
              IdealMemory memory({1, 0}, "b.toml:2");
            }),
            "b.toml:2: 'bytes_per_cycle' is 0; expected an integer from 1 to 65536");
}

}  // namespace
}  // namespace wedgesim::model::memory

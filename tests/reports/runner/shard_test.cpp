#include "reports/runner/shard.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/expect_input_error.h"

namespace wedgesim::reports {
namespace {

using Variables = std::map<std::string, std::string>;

std::string found(const Variables& variables) {
  const auto shard = shard_of_scheduler([&variables](const char* name) -> const char* {
    const auto variable = variables.find(name);
    return variable == variables.end() ? nullptr : variable->second.c_str();
  });
  return shard ? shard->first.name() : "none";
}

TEST(Shard, TogetherTheyHaveEveryPointOnce) {
  for (const std::int64_t points : {0, 1, 7, 100}) {
    std::int64_t next = 0;
    for (std::int64_t number = 1; number <= 8; ++number) {
      const auto [begin, end] = Shard{number, 8}.positions(points);
      EXPECT_EQ(begin, next);
      EXPECT_LE(end - begin, (points + 7) / 8);
      next = end;
    }
    EXPECT_EQ(next, points);
  }
}

TEST(Shard, IsWrittenAsAFraction) {
  EXPECT_EQ(parse_shard("2/3").name(), "shard-2-of-3");
  for (const char* text : {"", "2", "0/3", "4/3", "1/0", "a/b", "1/2/3", "-1/3", "1/"}) {
    EXPECT_NE(input_error_of([text] { parse_shard(text); }).find("--shard"), std::string::npos)
        << text;
  }
}

TEST(Shard, SlurmArraysAndOpenMpiChoose) {
  EXPECT_EQ(found({}), "none");
  EXPECT_EQ(found({{"SLURM_ARRAY_TASK_ID", "0"},
                   {"SLURM_ARRAY_TASK_MIN", "0"},
                   {"SLURM_ARRAY_TASK_MAX", "7"}}),
            "shard-1-of-8");
  EXPECT_EQ(found({{"SLURM_ARRAY_TASK_ID", "14"},
                   {"SLURM_ARRAY_TASK_MIN", "10"},
                   {"SLURM_ARRAY_TASK_MAX", "18"},
                   {"SLURM_ARRAY_TASK_STEP", "4"}}),
            "shard-2-of-3");
  EXPECT_EQ(found({{"SLURM_ARRAY_TASK_ID", "3"}}), "none");
  EXPECT_EQ(found({{"OMPI_COMM_WORLD_RANK", "3"}, {"OMPI_COMM_WORLD_SIZE", "4"}}), "shard-4-of-4");
  EXPECT_EQ(found({{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "1"}}), "none");
  EXPECT_EQ(found({{"OMPI_COMM_WORLD_RANK", "x"}, {"OMPI_COMM_WORLD_SIZE", "4"}}), "none");
}

}  // namespace
}  // namespace wedgesim::reports

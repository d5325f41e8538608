#include "reports/runner/schedule.h"

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

namespace wedgesim::reports {
namespace {

Study study_of(std::size_t points, int formats) {
  Study study;
  study.frames.resize(1);
  study.configurations.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    study.configurations[i].measure = Measure::cycles;
    study.configurations[i].block.formats.form_bits =
        static_cast<int>(i % static_cast<std::size_t>(formats));
  }
  return study;
}

std::vector<std::size_t> all_of(const Study& study) {
  std::vector<std::size_t> all(study.configurations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

TEST(Schedule, PointsThatHaveValuesInCommonAreInOneJob) {
  const Study study = study_of(6, 3);
  Schedule schedule(study);
  schedule.add_points(0, all_of(study));
  for (std::size_t first = 0; first < 3; ++first) {
    const auto job = schedule.next({}, {false});
    ASSERT_TRUE(job);
    EXPECT_EQ(job->configurations, (std::vector<std::size_t>{first, first + 3}));
  }
  EXPECT_FALSE(schedule.next({}, {false}));
}

// Each compared with each other they would take more than ten seconds.
TEST(Schedule, ManyDifferentPointsAreAddedInNoTime) {
  constexpr std::size_t kPoints = 50000;
  const Study study = study_of(kPoints, static_cast<int>(kPoints));
  Schedule schedule(study);
  const auto start = std::chrono::steady_clock::now();
  schedule.add_points(0, all_of(study));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 2.0);
}

}  // namespace
}  // namespace wedgesim::reports

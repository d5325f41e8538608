#include "reports/stress/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "functional/reference/judge.h"
#include "reports/stress/case_name.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/frame_parts.h"
#include "reports/stress/replay.h"

namespace wedgesim::reports::stress {
namespace {

TEST(FrameParts, SharesAddUpToTheWhole) {
  for (const char* name : {"distance-ratio,0,10", "small-light,1,0.1", "offset,2,1", "overlap,0,2",
                           "eye-in-umbra,1,0.01"}) {
    SCOPED_TRACE(name);
    const Case made = parse_case("name", name).make();
    const functional::Frame frame = frame_of(made);
    const std::vector<std::size_t> pixels{200, 390, 400, 410};
    std::vector<double> whole = functional::judge_light_intensity(made.scene, frame, pixels);
    std::vector<std::int64_t> sums = evaluate(frame.trace.view(), method_of(frame), {}).sums;
    const auto one = static_cast<std::int64_t>(model::Datapath().one());
    PartFrame alone(frame);
    const std::vector<Part> parts = parts_of(frame);
    EXPECT_GE(parts.size(), frame.trace.wedges.size());
    double most = 0.0;
    for (const Part& part : parts) {
      const functional::Frame& single = alone.only(part);
      const auto shares = functional::judge_light_intensity(made.scene, single, pixels);
      const auto words = evaluate(single.trace.view(), method_of(single), {}).sums;
      for (std::size_t i = 0; i < pixels.size(); ++i) whole[i] -= shares[i] - 1.0;
      for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] -= words[i] - one;
        most = std::max(most, std::abs(static_cast<double>(words[i] - one)));
      }
    }
    EXPECT_GT(most, 0.0);
    for (const double rest : whole) EXPECT_NEAR(rest, 1.0, 1e-12);
    for (const std::int64_t rest : sums) EXPECT_EQ(rest, one);
  }
}

TEST(Shrink, KeepsTheFewestEdgesThatPassTheBar) {
  const Case made = parse_case("name", "line-light,0,1e-8").make();
  const Measurement measurement = measure(made);
  const auto shrunk = shrink(made, measurement, Arithmetic::fixed);
  ASSERT_TRUE(shrunk.has_value());
  const std::size_t pixel = static_cast<std::size_t>(shrunk->y * measurement.width + shrunk->x);
  EXPECT_EQ(worst_pixels(measurement, Arithmetic::fixed, 1).front(), pixel);
  ASSERT_FALSE(shrunk->culprits.empty());
  EXPECT_LE(shrunk->culprits.size(), shrunk->parts);
  double sum = 0.0;
  double before = std::abs(shrunk->culprits.front().error());
  for (const Culprit& culprit : shrunk->culprits) {
    EXPECT_LE(std::abs(culprit.error()), before);
    before = std::abs(culprit.error());
    EXPECT_LE(std::abs(sum), tolerance_of(Arithmetic::fixed) + shrunk->sensitivity);
    sum += culprit.error();
    ASSERT_TRUE(culprit.has_edge);
    const auto& corners = made.scene.objects[1].mesh.positions;
    EXPECT_EQ(std::ranges::count(corners, culprit.begin), 1);
    EXPECT_EQ(std::ranges::count(corners, culprit.end), 1);
  }
  EXPECT_GT(std::abs(sum), tolerance_of(Arithmetic::fixed) + shrunk->sensitivity);
  EXPECT_EQ(std::signbit(sum), std::signbit(shrunk->li - shrunk->judge));
}

// A sum that leaves its word wraps: each of its parts is right.
TEST(Shrink, BlamesNoEdgeWhereLightIntensityLeavesItsWord) {
  const Case made = parse_case("name", "overlap,0,18").make();
  const auto shrunk = shrink(made, measure(made), Arithmetic::fixed);
  ASSERT_TRUE(shrunk.has_value());
  EXPECT_TRUE(shrunk->culprits.empty());
  EXPECT_NEAR(shrunk->sum, shrunk->judge, tolerance_of(Arithmetic::fixed));
  EXPECT_NEAR(std::abs(shrunk->li - shrunk->sum), 32.0, 1e-9);
  EXPECT_NE(shrunk_text(*shrunk).find("which leaves LI's word"), std::string::npos);
}

TEST(Shrink, LeavesWhatIsRightAlone) {
  const Case made = parse_case("name", "distance-ratio,0,1").make();
  const Measurement measurement = measure(made);
  for (const Arithmetic arithmetic : kArithmetics) {
    EXPECT_FALSE(shrink(made, measurement, arithmetic).has_value()) << name_of(arithmetic);
  }
}

}  // namespace
}  // namespace wedgesim::reports::stress

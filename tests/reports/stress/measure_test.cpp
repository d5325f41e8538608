#include "reports/stress/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/stress/case_name.h"

namespace wedgesim::reports::stress {
namespace {

Measurement of(const char* name) { return measure(parse_case("name", name).make()); }

TEST(Measure, HarmlessCasesHold) {
  for (const char* name : {"distance-ratio,0,1", "distance-ratio,1,1", "distance-ratio,2,1"}) {
    SCOPED_TRACE(name);
    const Measurement m = of(name);
    ASSERT_FALSE(m.refused.has_value()) << *m.refused;
    EXPECT_EQ(m.judged, static_cast<std::size_t>(m.width * m.height));
    EXPECT_TRUE(m.configurations_agree);
    EXPECT_GT(m.wedges, 0U);
    for (const Arithmetic a : kArithmetics) {
      const Errors& errors = m.errors[static_cast<std::size_t>(a)];
      EXPECT_TRUE(errors.holds) << name_of(a);
      EXPECT_GT(errors.max_error, 0.0) << name_of(a);
      EXPECT_EQ(errors.li.size(), m.judge.size());
      EXPECT_EQ(errors.visits > 0, a != Arithmetic::renderer) << name_of(a);
    }
  }
}

// What is said of a frame agrees with its pictures.
TEST(Measure, ErrorsAreThoseOfThePictures) {
  const Measurement m = of("distance-ratio,0,1e8");
  for (const Arithmetic a : kArithmetics) {
    const Errors& errors = m.errors[static_cast<std::size_t>(a)];
    double most = 0.0;
    std::uint64_t beyond = 0;
    std::uint64_t off = 0;
    for (std::size_t i = 0; i < m.judge.size(); ++i) {
      const double error = std::fabs(errors.li[i] - m.judge[i]);
      most = std::max(most, error);
      beyond += error > tolerance_of(a) + m.sensitivities[i] ? 1 : 0;
      off += error > 1.0 / 255.0 ? 1 : 0;
    }
    EXPECT_EQ(errors.max_error, most) << name_of(a);
    EXPECT_EQ(errors.beyond, beyond) << name_of(a);
    EXPECT_EQ(errors.off, off) << name_of(a);
  }
  EXPECT_GT(m.errors[static_cast<std::size_t>(Arithmetic::fixed)].beyond, 0U);
  EXPECT_GT(m.condition, 1e5);
}

TEST(Measure, ARefusedFrameSaysWhy) {
  Case made = parse_case("name", "distance-ratio,0,1").make();
  made.scene.camera.near_plane = -1.0;
  const Measurement m = measure(made);
  ASSERT_TRUE(m.refused.has_value());
  EXPECT_NE(m.refused->find("near"), std::string::npos) << *m.refused;
}

}  // namespace
}  // namespace wedgesim::reports::stress

#include "reports/stress/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/stress/case_name.h"
#include "tests/reports/stress/silhouettes.h"

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
  const Measurement m = of("line-light,0,1e-8");
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
  EXPECT_GT(m.condition, 5.0);
}

// Pixels that the fixed datapath gets wrong are at wedges that it flags without any other
// arithmetic: for its forms, its word, its roundings.
TEST(Measure, TheFixedDatapathForeseesWhatItGetsWrong) {
  for (const char* name :
       {"near-far-float32,0,1e8", "line-light,0,1e-8", "overlap,0,30", "many-edges,0,1000"}) {
    SCOPED_TRACE(name);
    const Measurement m = of(name);
    const Errors& errors = m.errors[static_cast<std::size_t>(Arithmetic::fixed)];
    EXPECT_GT(errors.beyond, 0U);
    EXPECT_EQ(errors.unforeseen, 0U);
    EXPECT_FALSE(errors.holds);
  }
}

TEST(Measure, HarmlessCasesAreNotFlagged) {
  for (const char* name : {"offset,0,1", "offset,1,1", "offset,2,1", "grazing-edge,1,0.001"}) {
    SCOPED_TRACE(name);
    const Measurement m = of(name);
    EXPECT_TRUE(m.flagged[static_cast<std::size_t>(Arithmetic::fixed)].empty());
    EXPECT_TRUE(m.flagged[static_cast<std::size_t>(Arithmetic::double_precision)].empty());
  }
}

// Of a line of light the `linear` wedges of the edges along it have no volume.
TEST(Measure, CountsDegenerateWedges) {
  for (const char* name : {"line-light,2,1e-24", "line-light,0,1e-24", "line-light,2,0.1"}) {
    SCOPED_TRACE(name);
    const Case made = parse_case("name", name).make();
    const glm::dvec3 line = made.scene.light.half_u;
    std::size_t along = 0;
    for (const Edge& edge : first_loop(made)) {
      along += glm::cross(edge.end - edge.begin, line) == glm::dvec3(0.0) ? 1 : 0;
    }
    EXPECT_GT(along, 0U);
    const bool is_line = glm::length(made.scene.light.half_v) < 1e-20;
    const bool linear = made.options.kind == traces::fb::WedgeKind_linear;
    EXPECT_EQ(of(name).degenerate_wedges, is_line && linear ? along : 0U);
  }
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

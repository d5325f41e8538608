// Which polygons of a trace take part, over which pixels, and with which step?
#include "model/units/primitive_setup.h"

#include <gtest/gtest.h>

#include "tests/model/count/synthetic.h"

namespace wedgesim::model::units {
namespace {

using test::Facing;
using test::Point;
using traces::fb::UmbraRole_cap;
using traces::fb::WedgeKind_coverage;

// Covers the pixels [2, 14) x [3, 12): a centre is inside from 2 - 0.5 on.
std::vector<Point> outline() {
  return {{2.0, 3.0, 0.2}, {14.0, 3.0, 0.2}, {14.0, 12.0, 0.4}, {2.0, 12.0, 0.4}};
}

/// A wedge of two faces, one seen from outside; its umbra polygon; a lone one and a lone cap.
struct PrimitiveSetupTest : testing::Test {
  PrimitiveSetupTest() {
    const std::uint32_t plane = source.add_plane(0.0, 0.0, 1.0, -0.1);
    source.add_face(outline(), Facing::eye, plane);
    source.add_face({{0.0, 0.0, 0.1}, {16.0, 0.0, 0.1}, {0.0, 16.0, 0.1}}, Facing::away, plane);
    const std::uint32_t wedge = source.add_wedge(WedgeKind_coverage, {plane}, 0.1, 0.4);
    source.add_umbra(outline(), Facing::eye, plane, wedge);
    source.add_umbra(outline(), Facing::away, plane, traces::kNone);
    source.add_umbra(outline(), Facing::eye, plane, traces::kNone, UmbraRole_cap);
    view = source.trace.view();
  }
  test::SyntheticTrace source{16, 16, 0.5};
  traces::TraceView view;
};

TEST_F(PrimitiveSetupTest, FacesThatFaceTheEyeTakePartInZPass) {
  const SetupPrimitive wedge = PrimitiveSetup(view, false, {}).penumbra(0);
  ASSERT_EQ(wedge.faces.size(), 1U);
  EXPECT_EQ(wedge.planes.size(), 1U);
  EXPECT_EQ(wedge.faces[0].polygon.edges.size(), 4U);
  const PixelBox bounds = wedge.bounds();
  EXPECT_EQ(bounds.x0, 2);
  EXPECT_EQ(bounds.y0, 3);
  EXPECT_EQ(bounds.x1, 14);
  EXPECT_EQ(bounds.y1, 12);
}

TEST_F(PrimitiveSetupTest, TheOthersTakePartInZFail) {
  const SetupPrimitive wedge = PrimitiveSetup(view, true, {}).penumbra(0);
  ASSERT_EQ(wedge.faces.size(), 1U);
  EXPECT_EQ(wedge.faces[0].polygon.edges.size(), 3U);
  EXPECT_FALSE(wedge.faces[0].polygon.eye_facing);
}

// An eye-facing side darkens where the point is inner in z-pass, lightens where it is not in
// z-fail.
TEST_F(PrimitiveSetupTest, UmbraPolygonsStepByFacingAndMethod) {
  const PrimitiveSetup pass(view, false, {});
  const auto eye = pass.umbra_of_wedge(0);
  ASSERT_TRUE(eye.has_value());
  EXPECT_TRUE(eye->hits_inner);
  EXPECT_EQ(eye->step, -1);
  const auto away = pass.umbra(1);
  ASSERT_TRUE(away.has_value());
  EXPECT_FALSE(away->hits_inner);
  EXPECT_EQ(away->step, 1);
  EXPECT_FALSE(pass.umbra(2).has_value());  // a cap
  const PrimitiveSetup fail(view, true, {});
  EXPECT_EQ(fail.umbra_of_wedge(0)->step, 1);
  EXPECT_TRUE(fail.umbra(2)->cap);
  EXPECT_EQ(pass.lone_umbras(), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace wedgesim::model::units

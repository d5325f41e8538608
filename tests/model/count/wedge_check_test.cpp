#include "model/count/wedge_check.h"

#include <gtest/gtest.h>

#include "tests/model/count/synthetic.h"

namespace wedgesim::model {
namespace {

using test::Facing;
using test::SyntheticTrace;

// A wedge between z >= z0 and z <= 0.9 under a plane, its edge 1 long or without length.
traces::Trace wedge_with(double a, double c, double d, traces::fb::WedgeKind kind,
                         bool edge = true) {
  SyntheticTrace synthetic(64, 64, 0.5);
  const std::uint32_t plane = synthetic.add_plane(a, 0, c, d);
  synthetic.add_face({{0, 0, 0.2}, {8, 0, 0.2}, {8, 8, 0.2}}, Facing::eye, plane);
  synthetic.add_wedge(kind, {plane, plane, plane, plane}, 0.2, 0.9);
  traces::fb::Wedge& wedge = synthetic.trace.wedges[0];
  wedge.mutable_edge_begin() = {-0.5, 0.2, 0.7};
  wedge.mutable_edge_end() = edge ? traces::fb::Vec3(0.5, 0.2, 0.7) : wedge.edge_begin();
  return std::move(synthetic.trace);
}

constexpr auto kLinear = traces::fb::WedgeKind_linear;

TEST(FlagWedges, FindsAPlaneWhoseConstantHidesItsSlope) {
  // A step of z is 2^-24; the form's bound is 2^50, so at 58 bits a unit is about 2^-7.
  const traces::Trace harmless = wedge_with(0.01, 1.0, -0.5, kLinear);
  const traces::Trace hidden = wedge_with(1e-9, 1.0, -0x1p50, kLinear);
  for (const DatapathKind kind :
       {DatapathKind::exact, DatapathKind::paper255, DatapathKind::fixed}) {
    EXPECT_TRUE(flag_wedges(harmless.view(), kind).empty()) << spelling(kind);
    const auto flags = flag_wedges(hidden.view(), kind);
    ASSERT_EQ(flags.size(), 1u) << spelling(kind);
    EXPECT_EQ(flags[0].wedge, 0u);
    EXPECT_EQ(flags[0].reason, FlagReason::plane);
    EXPECT_GT(flags[0].value, 1.0);
  }
}

TEST(FlagWedges, FormatsAndPrecisionDecide) {
  // Steep in z alone: a unit in the last place of c, over all of z, against a step.
  const traces::Trace trace = wedge_with(0.0, 1.0, -0.5, kLinear);
  Datapath datapath(DatapathKind::fixed);
  EXPECT_TRUE(flag_wedges(trace.view(), datapath).empty());
  datapath.formats.form_bits = 48;
  EXPECT_EQ(flag_wedges(trace.view(), datapath).size(), 1u);
  EXPECT_TRUE(flag_wedges(trace.view(), DatapathKind::exact).empty());
  EXPECT_EQ(flag_wedges(trace.view(), DatapathKind::float32).size(), 1u);
}

TEST(FlagWedges, APlaneThatIsSteepOnTheScreenNeedsNoDepth) {
  const traces::Trace trace = wedge_with(1.0, 1e-9, -8.3, kLinear);
  EXPECT_TRUE(flag_wedges(trace.view(), DatapathKind::fixed).empty());
  EXPECT_TRUE(flag_wedges(trace.view(), DatapathKind::float32).empty());
}

TEST(FlagWedges, AnEdgeWithoutLengthIsNamed) {
  const auto kind = traces::fb::WedgeKind_coverage;
  EXPECT_TRUE(flag_wedges(wedge_with(0.01, 1.0, -0.5, kind).view(), DatapathKind::exact).empty());
  const auto flags =
      flag_wedges(wedge_with(0.01, 1.0, -0.5, kind, false).view(), DatapathKind::fixed);
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].reason, FlagReason::edge);
  EXPECT_EQ(name(flags[0].reason), "edge");
  EXPECT_EQ(describe(flags[0].reason), "the edge has no length");
}

}  // namespace
}  // namespace wedgesim::model

// Does the bound hold what the datapath's forms may do, and is it small where they are good?
#include "model/count/rounding_bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/model/count/synthetic.h"

namespace wedgesim::model {
namespace {

using test::Facing;
using test::SyntheticTrace;

constexpr int kEdge = 16;

// A wedge over the whole frame: front and back a few steps of z apart, its sides far away.
traces::Trace thin_wedge(double thickness, double tilt) {
  SyntheticTrace synthetic(kEdge, kEdge, 0.5);
  const std::uint32_t front = synthetic.add_plane(tilt, 0.0, 1.0, -0.5 + thickness);
  const std::uint32_t back = synthetic.add_plane(-tilt, 0.0, -1.0, 0.5 + thickness);
  const std::uint32_t left = synthetic.add_plane(1.0, 0.0, 0.0, 1.0);
  const std::uint32_t right = synthetic.add_plane(-1.0, 0.0, 0.0, kEdge + 1.0);
  synthetic.add_face({{0, 0, 0.2}, {kEdge, 0, 0.2}, {kEdge, kEdge, 0.2}, {0, kEdge, 0.2}},
                     Facing::eye, front);
  synthetic.add_wedge(traces::fb::WedgeKind_linear, {front, back, left, right}, 0.2, 0.9);
  return std::move(synthetic.trace);
}

double worst(const traces::Trace& trace, const Datapath& datapath) {
  const traces::TraceView view = trace.view();
  const Operands operands(view, datapath);
  double most = 0.0;
  for (const Doubt& doubt :
       RoundingBound(operands, datapath)(wedge_primitive(operands, ZMethod::pass, 0))) {
    EXPECT_LT(doubt.pixel, trace.depth.size());
    EXPECT_GE(doubt.li, 0.0);
    most = std::max(most, doubt.li);
  }
  return most;
}

Datapath narrow(int form_bits) {
  Datapath datapath(DatapathKind::fixed);
  datapath.formats.form_bits = form_bits;
  return datapath;
}

TEST(RoundingBound, IsSmallWhereFormsAreGood) {
  const traces::Trace thick = thin_wedge(0.2, 0.001);
  EXPECT_LT(worst(thick, DatapathKind::exact), 1e-9);
  EXPECT_LT(worst(thick, DatapathKind::fixed), 1e-4);
  EXPECT_LT(worst(thick, DatapathKind::float32), 1e-4);
}

TEST(RoundingBound, GrowsWithWhatIsDropped) {
  // 64 steps of z thick: single precision has lost a good part of it, 40 bits nearly all.
  const traces::Trace thin = thin_wedge(0x1p-18, 0.0);
  EXPECT_LT(worst(thin, DatapathKind::fixed), 1e-2);
  EXPECT_GT(worst(thin, DatapathKind::float32), 1e-3);
  EXPECT_GT(worst(thin, narrow(40)), 0.4);
  EXPECT_GT(worst(thin, narrow(48)), worst(thin, narrow(52)));
}

// Every intensity that planes within half a unit of the datapath's give is within the bound.
TEST(RoundingBound, HoldsWhatRoundingDoes) {
  for (const double thickness : {0x1p-12, 0x1p-16, 0x1p-20}) {
    const traces::Trace trace = thin_wedge(thickness, 0.37 * thickness);
    const traces::TraceView view = trace.view();
    const Operands exact_operands(view);
    const Primitive exact = wedge_primitive(exact_operands, ZMethod::pass, 0);
    for (const int form_bits : {40, 44, 48, 58}) {
      const Datapath datapath = narrow(form_bits);
      const Operands operands(view, datapath);
      const Primitive fixed = wedge_primitive(operands, ZMethod::pass, 0);
      std::vector<double> bound(trace.depth.size(), 0.0);
      for (const Doubt& doubt : RoundingBound(operands, datapath)(fixed)) {
        bound[doubt.pixel] = doubt.li;
      }
      for (std::size_t i = 0; i < trace.depth.size(); ++i) {
        const auto share = [&](const Primitive& primitive, double z) {
          const double x = static_cast<double>(i % kEdge) + 0.5;
          const double y = static_cast<double>(i / kEdge) + 0.5;
          for (const Plane& plane : primitive.planes) {
            if (!plane.inside(x, y, z)) return 0.0;
          }
          return contribution(primitive.terms, x, y, z);
        };
        const double off = std::fabs(share(fixed, operands.depth(trace.depth[i])) -
                                     share(exact, exact_operands.depth(trace.depth[i])));
        EXPECT_LE(off, bound[i] + 1e-4) << i << ' ' << thickness << ' ' << form_bits;
      }
    }
  }
}

}  // namespace
}  // namespace wedgesim::model

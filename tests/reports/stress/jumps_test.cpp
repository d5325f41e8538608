#include "reports/stress/jumps.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "reports/stress/case_name.h"
#include "reports/stress/frame.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

std::vector<std::size_t> all_pixels(const functional::Frame& frame) {
  std::vector<std::size_t> pixels(frame.trace.depth.size());
  std::iota(pixels.begin(), pixels.end(), std::size_t{0});
  return pixels;
}

const Jump& jump_of(const std::array<Jumps, kArithmetics.size()>& jumps, Arithmetic arithmetic) {
  return *jumps.at(static_cast<std::size_t>(arithmetic)).largest;
}

// In harmless frames LI steps across every plane as the judge's does.
TEST(Jumps, AreNoneInHarmlessFrames) {
  for (const char* name : {"grazing-edge,0,0.1", "grazing-edge,1,0.1", "grazing-edge,2,0.1"}) {
    SCOPED_TRACE(name);
    const Case made = parse_case("name", name).make();
    const functional::Frame frame = frame_of(made);
    const auto jumps = largest_jumps(made, frame, all_pixels(frame));
    for (const Arithmetic a : {Arithmetic::fixed, Arithmetic::double_precision}) {
      EXPECT_LE(jump_of(jumps, a).excess, largest_jump_of(a)) << name_of(a);
    }
    EXPECT_FALSE(jumps[static_cast<std::size_t>(Arithmetic::renderer)].largest.has_value());
  }
}

// A side plane that is shifted shows as a jump, though no pixel's own point is between where the
// plane is and where it should be.
TEST(Jumps, ShowAShiftedPlane) {
  const Case made = parse_case("name", "grazing-edge,0,0.1").make();
  functional::Frame frame = frame_of(made);
  for (std::uint16_t side = 0; side < frame.trace.wedges[0].plane_count(); ++side) {
    // In the trace alone: the judge makes its own.
    const std::uint32_t reference = (*frame.trace.wedges[0].planes())[side];
    traces::fb::Plane& plane = frame.trace.planes[traces::plane_index(reference)];
    const traces::fb::Plane right = plane;
    plane.mutate_d(plane.d() - (traces::is_minus(reference) ? -1.0 : 1.0) * 0.002 * plane.c());
    const auto jumps = largest_jumps(made, frame, all_pixels(frame));
    plane = right;
    if (jump_of(jumps, Arithmetic::double_precision).excess < 0.01) continue;
    EXPECT_GT(jump_of(jumps, Arithmetic::fixed).excess, 0.01);
    return;
  }
  FAIL() << "no plane of wedge 0 was looked at";
}

// What is no number at a point that was moved onto a plane is counted.
TEST(Jumps, CountWhatIsNoNumber) {
  const Case made = parse_case("name", "grazing-edge,2,0.1").make();
  functional::Frame frame = frame_of(made);
  const auto index = static_cast<std::size_t>(Arithmetic::double_precision);
  EXPECT_EQ(largest_jumps(made, frame, all_pixels(frame)).at(index).not_finite, 0U);
  for (traces::fb::Wedge& wedge : frame.trace.wedges) {
    wedge.mutable_linear_factors()->Mutate(0, std::numeric_limits<double>::infinity());
    wedge.mutable_linear_factors()->Mutate(1, -std::numeric_limits<double>::infinity());
  }
  EXPECT_GT(largest_jumps(made, frame, all_pixels(frame)).at(index).not_finite, 0U);
}

}  // namespace
}  // namespace wedgesim::reports::stress

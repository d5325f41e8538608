#include "reports/stress/light_rounding.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/reports/stress/bounded.h"

namespace wedgesim::reports::stress {
namespace {

// Harmless frames are far from any doubt, whatever the light.
TEST(LightRounding, IsNextToNothingInHarmlessFrames) {
  for (const char* name :
       {"grazing-edge,0,0.1", "grazing-edge,1,0.1", "offset,0,1", "offset,1,1"}) {
    const double bound = worst_bound(name);
    EXPECT_GT(bound, 1e-16) << name;
    EXPECT_LT(bound, 1e-10) << name;
  }
}

// It is a bound: nowhere is the sum of what double gives farther from the judge's. And it is not
// one because it is everywhere the whole light.
TEST(LightRounding, BoundsTheError) {
  std::size_t far_off = 0;
  for (const char* name : {"found,0,50", "found,0,52", "found-flagged,0,4", "found-flagged,0,5",
                           "small-light,0,1e-11", "small-light,1,1e-11", "line-light,0,1e-14"}) {
    const Bounded bounded = expect_within_bounds(name);
    EXPECT_GE(bounded.tight, bounded.all / 2) << name;
    far_off += bounded.far_off;
  }
  EXPECT_GT(far_off, 10U);
}

}  // namespace
}  // namespace wedgesim::reports::stress

#include "reports/stress/linear_rounding.h"

#include <gtest/gtest.h>

#include <string>

#include "reports/stress/families/random_case.h"
#include "tests/reports/stress/bounded.h"

namespace wedgesim::reports::stress {
namespace {

TEST(LinearRounding, IsNextToNothingInHarmlessFrames) {
  for (const char* name : {"grazing-edge,2,0.1", "offset,2,1"}) {
    const double bound = worst_bound(name);
    EXPECT_GT(bound, 1e-16) << name;
    EXPECT_LT(bound, 1e-8) << name;
  }
}

// Corners that are opposite one another in such a loop share their side plane: each wedge's
// neighbour is the one that begins where it ends.
TEST(LinearRounding, IsNextToNothingInSymmetricLoops) {
  for (const char* genes : {"kind=1 first.shape=1", "kind=1 first.shape=3"}) {
    const double bound = worst_bound(case_of(genes_of(genes)));
    EXPECT_GT(bound, 1e-16) << genes;
    EXPECT_LT(bound, 1e-10) << genes;
  }
}

// Lines in which planes meet that are all but one.
TEST(LinearRounding, SeesWhatPlanesHaveLost) {
  for (int i = 6; i <= 8; ++i) {
    const std::string name = "found-flagged,0," + std::to_string(i);
    EXPECT_GT(worst_bound(name), 0.25e-6) << name;
  }
}

// It is a bound: nowhere is the sum of what double gives farther from the judge's. And it is not
// one because it is everywhere the whole light.
TEST(LinearRounding, BoundsTheError) {
  for (const char* name : {"found-flagged,0,6", "found-flagged,0,13", "found,0,54",
                           "acute-corner,2,1e-8", "zigzag,2,1e-12", "distance-ratio,2,1e8"}) {
    const Bounded bounded = expect_within_bounds(name);
    EXPECT_GE(bounded.tight, bounded.all / 2) << name;
  }
}

// Where all pixels are in doubt, too.
TEST(LinearRounding, BoundsLargeErrors) {
  std::size_t far_off = 0;
  for (const char* name : {"found-flagged,0,7", "found-flagged,0,8"}) {
    far_off += expect_within_bounds(name).far_off;
  }
  EXPECT_GT(far_off, 60U);
}

}  // namespace
}  // namespace wedgesim::reports::stress

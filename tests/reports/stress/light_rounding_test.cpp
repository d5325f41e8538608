#include "reports/stress/light_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "functional/reference/judge.h"
#include "reports/stress/case_name.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/linear_rounding.h"
#include "reports/stress/trace_rounding.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

// The largest bound of a frame's wedges.
double worst_bound(const std::string& name) {
  const functional::Frame frame = frame_of(parse_case("name", name).make());
  double worst = 0.0;
  for (const TraceRounding& one : trace_roundings(frame.trace.view(), method_of(frame))) {
    worst = std::max(worst, one.moved);
  }
  return worst;
}

// Harmless frames are far from any doubt, whatever the light.
TEST(LightRounding, IsNextToNothingInHarmlessFrames) {
  for (const char* name :
       {"grazing-edge,0,0.1", "grazing-edge,1,0.1", "offset,0,1", "offset,1,1"}) {
    const double bound = worst_bound(name);
    EXPECT_GT(bound, 1e-16) << name;
    EXPECT_LT(bound, 1e-10) << name;
  }
}

TEST(LinearRounding, IsNextToNothingInHarmlessFrames) {
  for (const char* name : {"grazing-edge,2,0.1", "offset,2,1"}) {
    const double bound = worst_bound(name);
    EXPECT_GT(bound, 1e-16) << name;
    EXPECT_LT(bound, 1e-8) << name;
  }
}

// Of `linear` wedges: lines in which planes meet that are all but one.
TEST(LinearRounding, SeesWhatPlanesHaveLost) {
  for (int i = 11; i <= 13; ++i) {
    const std::string name = "found-flagged,0," + std::to_string(i);
    EXPECT_GT(worst_bound(name), 0.25e-6) << name;
  }
}

// How many pixels are off by more than a word's rounding, none of them by more than the sum of all
// wedges' bounds.
int far_off_within_bounds(const std::string& name) {
  const Case made = parse_case("name", name).make();
  const functional::Frame frame = frame_of(made);
  const traces::TraceView trace = frame.trace.view();
  const Evaluation exact = evaluate(trace, method_of(frame), {});
  const LinearRounding linear_rounding(trace);
  std::vector<std::size_t> pixels(trace.depth.size());
  std::iota(pixels.begin(), pixels.end(), 0);
  const auto judged = functional::judge_light_intensity(made.scene, frame, pixels);
  const auto width = static_cast<std::size_t>(trace.header.width);
  int far_off = 0;
  for (const std::size_t pixel : pixels) {
    const double error =
        std::fabs(static_cast<double>(exact.sums[pixel]) / model::Datapath().one() - judged[pixel]);
    const double x = static_cast<double>(pixel % width) + 0.5;
    const double y = static_cast<double>(pixel / width) + 0.5;
    const double z = traces::decode_depth(trace.header.depth_format, trace.depth[pixel]);
    double bound = 1e-6;  // a word's rounding
    for (std::uint32_t w = 0; w < trace.wedges.size(); ++w) {
      const traces::fb::Wedge& wedge = trace.wedges[w];
      bound += wedge.kind() == traces::fb::WedgeKind_linear ? linear_rounding(w, x, y, z)
                                                            : light_rounding(trace, wedge, x, y, z);
    }
    EXPECT_LE(error, bound) << name << " at pixel " << pixel;
    far_off += error > 1e-6 ? 1 : 0;
  }
  return far_off;
}

// It is a bound: nowhere is the sum of what double gives farther from the judge's.
TEST(LightRounding, BoundsTheError) {
  int far_off = 0;
  for (int i = 5; i <= 10; ++i) {
    far_off += far_off_within_bounds("found-flagged,0," + std::to_string(i));
  }
  EXPECT_GT(far_off, 0);
}

TEST(LinearRounding, BoundsTheError) {
  int far_off = 0;
  for (const int i : {11, 12, 13, 18, 19}) {
    far_off += far_off_within_bounds("found-flagged,0," + std::to_string(i));
  }
  for (const char* name : {"acute-corner,2,1e-8", "zigzag,2,1e-12", "distance-ratio,2,1e8"}) {
    far_off += far_off_within_bounds(name);
  }
  EXPECT_GT(far_off, 0);
}

}  // namespace
}  // namespace wedgesim::reports::stress

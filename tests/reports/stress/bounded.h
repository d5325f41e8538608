#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "functional/reference/judge.h"
#include "reports/stress/case_name.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/light_rounding.h"
#include "reports/stress/linear_rounding.h"
#include "reports/stress/trace_rounding.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {

/// The largest bound of a frame's wedges.
inline double worst_bound(const Case& made) {
  const functional::Frame frame = frame_of(made);
  double worst = 0.0;
  for (const TraceRounding& one : trace_roundings(frame.trace.view(), method_of(frame))) {
    worst = std::max(worst, one.moved);
  }
  return worst;
}
inline double worst_bound(const std::string& name) {
  return worst_bound(parse_case("name", name).make());
}

/// A frame's pixels: those that double gets wrong by more than a word's rounding, and those where
/// the sum of all wedges' bounds says something.
struct Bounded {
  std::size_t all = 0, far_off = 0;
  std::size_t tight = 0;  // below 1/100 of the light
};

/// Expects that none is off by more than that sum.
inline Bounded expect_within_bounds(const std::string& name) {
  const Case made = parse_case("name", name).make();
  const functional::Frame frame = frame_of(made);
  const traces::TraceView trace = frame.trace.view();
  const Evaluation exact = evaluate(trace, method_of(frame), {});
  const LinearRounding linear_rounding(trace);
  std::vector<std::size_t> pixels(trace.depth.size());
  std::iota(pixels.begin(), pixels.end(), 0);
  const auto judged = functional::judge_light_intensity(made.scene, frame, pixels);
  const auto width = static_cast<std::size_t>(trace.header.width);
  Bounded bounded{pixels.size()};
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
    bounded.far_off += error > 1e-6 ? 1 : 0;
    bounded.tight += bound < 0.01 ? 1 : 0;
  }
  return bounded;
}

}  // namespace wedgesim::reports::stress

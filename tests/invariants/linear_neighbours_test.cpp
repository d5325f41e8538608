// Do the block's intensities of neighbouring `linear` wedges agree on their common side plane, side
// planes not crossing? Else the penumbra would show a step there (Paper I, section 4.2).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <vector>

#include "base/error.h"
#include "functional/methods/frame.h"
#include "model/count/contribution.h"
#include "tests/support/random_scene.h"

namespace wedgesim::tests {
namespace {

using model::LinearTerms;
using model::Plane;

constexpr std::size_t kFront = 0, kBack = 1, kLeft = 2, kRight = 3;
// In double they agree far closer than the bound that any format has, one LSB: 1/2048 in S5_11.
constexpr double kTolerance = 1e-8;

struct Point {
  double x, y, z;
};
double inward(const Plane& plane, const Point& p) { return plane.inward(p.x, p.y, p.z); }

// The wedges on the two sides of one stored plane.
struct Pair {
  LinearTerms one;   // its right side
  LinearTerms next;  // its left side
};

std::vector<Pair> pairs(const traces::TraceView& trace) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> by_left;  // reference: wedges
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    by_left[(*trace.wedges[i].planes())[kLeft]].push_back(i);
  }
  std::vector<Pair> result;
  for (const traces::fb::Wedge& wedge : trace.wedges) {
    for (std::uint32_t next : by_left[(*wedge.planes())[kRight] ^ 1U]) {
      result.push_back({std::get<LinearTerms>(model::light_terms(trace, wedge)),
                        std::get<LinearTerms>(model::light_terms(trace, trace.wedges[next]))});
    }
  }
  return result;
}

// Random points of a plane, in the frame.
std::vector<Point> points_on(const Plane& plane, const traces::TraceView& trace,
                             std::mt19937_64& random, std::size_t count) {
  std::vector<Point> points;
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (std::size_t tries = 0; tries < 20 * count && points.size() < count; ++tries) {
    const double x = uniform(random) * trace.header.width;
    const double y = uniform(random) * trace.header.height;
    const double z = -(plane.a * x + plane.b * y + plane.d) / plane.c;
    if (z > 0.0 && z < 1.0) points.push_back({x, y, z});
  }
  return points;
}

// Front planes, and back planes, of neighbours meet in the common side plane nearly always; where
// they would meet too far aside, the side plane is placed more simply. Where they do meet, the
// ratio of their values is the same everywhere on the side plane.
bool meet_in_side(const Pair& pair, const std::vector<Point>& points) {
  for (const std::size_t q : {kFront, kBack}) {
    const auto size = [&](const LinearTerms& terms) {
      double most = 0.0;
      for (const Point& p : points) most = std::max(most, std::abs(inward(terms.planes[q], p)));
      return most;
    };
    const double scale = size(pair.one) * size(pair.next);
    for (const Point& p : points) {
      const double cross = inward(pair.one.planes[q], p) * inward(pair.next.planes[q], points[0]) -
                           inward(pair.one.planes[q], points[0]) * inward(pair.next.planes[q], p);
      if (std::abs(cross) > 1e-9 * scale) return false;
    }
  }
  return true;
}

// Inside both wedges but for the common plane.
bool between(const Pair& pair, const Point& p) {
  for (const std::size_t q : {kFront, kBack}) {
    if (inward(pair.one.planes[q], p) <= 0.0 || inward(pair.next.planes[q], p) <= 0.0) return false;
  }
  return inward(pair.one.planes[kLeft], p) > 0.0 && inward(pair.next.planes[kRight], p) > 0.0;
}

struct Seen {
  int pairs = 0, irregular = 0, points = 0;
  double worst = 0.0;
};

void compare(const traces::TraceView& trace, std::mt19937_64& random, Seen& seen) {
  for (const Pair& pair : pairs(trace)) {
    const auto points = points_on(pair.one.planes[kRight], trace, random, 40);
    if (points.size() < 40) continue;  // seen edge-on, or hardly at all
    ++seen.pairs;
    if (!meet_in_side(pair, points)) {
      ++seen.irregular;
      continue;
    }
    for (const Point& p : points) {
      if (!between(pair, p)) continue;
      ++seen.points;
      const double difference =
          model::intensity(pair.one, p.x, p.y, p.z) - model::intensity(pair.next, p.x, p.y, p.z);
      seen.worst = std::max(seen.worst, std::abs(difference));
      ASSERT_LE(std::abs(difference), kTolerance) << p.x << ' ' << p.y << ' ' << p.z;
    }
  }
}

TEST(LinearNeighbours, AgreeOnTheirCommonPlane) {
  Seen seen;
  functional::FrameOptions options;
  options.kind = traces::fb::WedgeKind_linear;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    try {
      const functional::Frame frame =
          functional::make_frame(random_scene(seed, EyePlace::outside), options);
      std::mt19937_64 random(seed);
      compare(frame.trace.view(), random, seen);
    } catch (const InputError&) {
      continue;  // the light is not clear of a caster
    }
    if (HasFatalFailure()) return;
  }
  std::cout << seen.pairs << " pairs, " << seen.irregular << " irregular, " << seen.points
            << " points, largest difference " << seen.worst << '\n';
  EXPECT_GT(seen.points, 4000);
  EXPECT_LT(seen.irregular, seen.pairs / 5);
}

}  // namespace
}  // namespace wedgesim::tests

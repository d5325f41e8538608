// Does the fixed datapath hold where numbers are awkward? Points on planes that wedges share and on
// the quad's own, polygons seen edge-on, contact, many edges in one penumbra, LI out of range.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <random>

#include "model/count/contribution.h"
#include "model/count/count.h"
#include "model/datapath/edge_function.h"
#include "model/datapath/setup.h"
#include "tests/model/count/synthetic.h"
#include "tests/model/datapath/one_point.h"

namespace wedgesim::model::datapath {
namespace {

using traces::fb::LightShape;

constexpr LightShape kShapes[]{LightShape::LightShape_rectangle, LightShape::LightShape_sphere};
constexpr unsigned kSeed = 2005;
const Place kAnywhere{1, 1, 8388608};

double fixed_coverage(const OnePoint& one, const Formats& formats) {
  const ZSteps steps(traces::fb::DepthFormat_unorm24);
  return contribution(light_setup(one.trace.view(), one.wedge, steps, formats), kAnywhere,
                      formats.round());
}

double exact_coverage(const OnePoint& one) {
  return model::contribution(light_terms(one.trace.view(), one.wedge), 0.5, 0.5, 0.5);
}

struct Uniform {
  explicit Uniform(unsigned seed) : engine(seed) { std::cout << "seed " << seed << '\n'; }
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  std::mt19937 engine;
};

// The planes of a trace through points that are exactly in the datapath's numbers: both references
// to a plane see the same value, and exactly one takes the point.
TEST(SharedPlane, TakesAPointOnItInExactlyOneOfItsWedges) {
  test::SyntheticTrace synthetic(64, 64, 0.5);
  Uniform uniform(kSeed);
  const ZSteps steps(traces::fb::DepthFormat_unorm24);
  int on_plane = 0;
  for (int i = 0; i < 2000; ++i) {
    // Through the centre of pixel (x, y) whatever z: edge-on; half of them tilted in z.
    const double x = std::floor(uniform(0, 64)) + 0.5;
    const double y = std::floor(uniform(0, 64)) + 0.5;
    const double a = std::floor(uniform(-99, 99)) / 64;
    const double b = std::floor(uniform(-99, 99)) / 64;
    const double c = i % 2 == 0 ? 0.0 : uniform(-1e6, 1e6);
    const std::uint32_t plus = synthetic.add_plane(a, b, c, -(a * x + b * y));
    const FixedPlane of_one = plane_setup(synthetic.trace.view(), plus, steps, Formats{});
    const FixedPlane of_other = plane_setup(synthetic.trace.view(), plus ^ 1U, steps, Formats{});
    ASSERT_NE(of_one.minus, of_other.minus);
    for (const double z : {0.0, 1.0, 8388608.0, 16777215.0}) {
      const Place at = place(x, y, z);
      ASSERT_NE(of_one.inside(at), of_other.inside(at));
      on_plane += of_one.form.at(at) == 0 ? 1 : 0;
      // Edge-on, z cannot matter.
      if (c == 0.0) {
        ASSERT_EQ(of_one.form.at(at), of_one.form.at(place(x, y, 0.0)));
      }
    }
  }
  EXPECT_GT(on_plane, 4000);
}

// One straight edge in two pieces, seen from points on the plane between their wedges among others.
TEST(Coverage, OfTwoNeighboursAddsUp) {
  Uniform uniform(kSeed);
  for (const LightShape shape : kShapes) {
    double largest = 0.0;
    double most = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 point{uniform(-3, 3), uniform(-3, 3), uniform(5, 50)};
      const auto towards = [&](double u, double v) {
        return glm::dvec3(u, v, 0.0) + (point - glm::dvec3(u, v, 0.0)) * 0.5;
      };
      const double v = uniform(-1.1, 1.1);
      // Every third joint is seen before the light's centre line, every third at its outline.
      const double joint = i % 3 == 0 ? 0.0 : i % 3 == 1 ? 1.0 : uniform(-1, 1);
      const glm::dvec3 begin = towards(-2.0, v);
      const glm::dvec3 middle = towards(joint, v);
      const glm::dvec3 end = towards(2.0, v);
      const double whole = exact_coverage({shape, point, 1.0, begin, end});
      const double parts = fixed_coverage({shape, point, 1.0, begin, middle}, Formats{}) +
                           fixed_coverage({shape, point, 1.0, middle, end}, Formats{});
      largest = std::max(largest, std::fabs(parts - whole));
      most = std::max(most, whole);
    }
    std::cout << EnumNameLightShape(shape) << ": largest difference " << largest << '\n';
    EXPECT_GT(most, 0.45);
    EXPECT_LE(largest, 1e-4);
  }
}

// On the quad's plane the edge is seen through the light's centre: half of it is hidden whichever
// side the point is taken to be on, so lit - 1 + 0.5 and lit - 0.5 are one word.
TEST(Coverage, OnTheQuadsPlaneIsOneHalf) {
  Uniform uniform(kSeed);
  const LiWord word;
  for (const LightShape shape : kShapes) {
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 point{uniform(-3, 3), uniform(-3, 3), uniform(5, 50)};
      const double angle = uniform(0, 6.283185307179586);
      const glm::dvec3 direction{3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.0};
      const double share = uniform(0.1, 0.9);
      const OnePoint one(shape, point, 1.0, point * share - direction, point * share + direction);
      const double half = fixed_coverage(one, Formats{});
      ASSERT_NEAR(half, 0.5, 1e-4);
      ASSERT_LE(std::abs(word.of(1.0) - word.of(half) - word.of(half)), 1);
    }
  }
}

TEST(EdgeOnPolygon, CoversNothing) {
  Uniform uniform(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const auto integer = [&](double low, double high) {
      return static_cast<std::int64_t>(std::floor(uniform(low, high)));
    };
    // Three points of one line through pixel centres.
    const std::int64_t x = 256 * integer(0, 8) + 128;
    const std::int64_t y = 256 * integer(0, 8) + 128;
    const std::int64_t dx = 128 * integer(-6, 7);
    const std::int64_t dy = 128 * integer(-6, 7);
    const std::int64_t m = integer(-3, 4);
    const EdgeFunction edges[] = {
        EdgeFunction::between(x, y, x + dx, y + dy),
        EdgeFunction::between(x + dx, y + dy, x + m * dx, y + m * dy),
        EdgeFunction::between(x + m * dx, y + m * dy, x, y),
    };
    for (int py = 0; py < 8; ++py) {
      for (int px = 0; px < 8; ++px) {
        ASSERT_FALSE(edges[0].inside(px, py) && edges[1].inside(px, py) && edges[2].inside(px, py));
      }
    }
  }
}

// A point on the edge's own line, at its ends, between them and beyond: any answer between 0 and
// 1/2 is right, none is not a number.
TEST(Contact, GivesACoverageInRange) {
  Uniform uniform(kSeed);
  for (const LightShape shape : kShapes) {
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec3 begin{uniform(-3, 3), uniform(-3, 3), uniform(2, 50)};
      const glm::dvec3 end = begin + glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-0.9, 1));
      const double at[] = {0.0, 1.0, 0.5, uniform(0, 1), uniform(-1, 2)};
      const glm::dvec3 point = begin + (end - begin) * at[i % 5];
      const double coverage =
          fixed_coverage({shape, point, uniform(0.1, 10), begin, end}, Formats{});
      ASSERT_TRUE(coverage >= 0.0 && coverage <= 0.5) << coverage;
    }
  }
}

TEST(Contact, GivesALightIntensityInRange) {
  // Planes that all pass the point, or lie one step of the form beside it.
  for (int i = 0; i < 256; ++i) {
    LinearSetup setup;
    setup.factors.fill(1.0);
    for (std::size_t k = 0; k < 4; ++k) setup.planes[k].d = (i >> (2 * k)) & 3;
    const double s = intensity(setup, kAnywhere, Formats{}.round());
    ASSERT_TRUE(s >= 0.0 && s <= 1.0) << s;
  }
}

// An arc of `edges` short edges across the light, seen from points about its axis: the words that
// they leave together against the exact sum, in units of full light.
struct ArcError {
  double rms = 0.0, largest = 0.0;
};

ArcError arc_error(LightShape shape, int edges, const Formats& formats, int points) {
  Uniform uniform(kSeed);
  const glm::dvec3 eye{0.0, 0.0, 20.0};
  const auto corner = [&](int i) {
    const double u = -0.55 + 1.1 * i / edges;
    const glm::dvec3 image{u, 0.35 + 0.2 * u - 0.5 * u * u, 0.0};  // no two edges alike
    return image + (eye - image) * 0.5;
  };
  ArcError error;
  double mean = 0.0;
  for (int k = 0; k < points; ++k) {
    const glm::dvec3 point =
        eye + glm::dvec3(uniform(-0.3, 0.3), uniform(-0.3, 0.3), uniform(-5, 10));
    double exact = 0.0;
    std::int64_t words = 0;
    for (int i = 0; i < edges; ++i) {
      const OnePoint one(shape, point, 1.0, corner(i), corner(i + 1));
      exact += exact_coverage(one);
      words += formats.li.of(fixed_coverage(one, formats));
    }
    mean += exact / points;
    const double off = std::ldexp(static_cast<double>(words), -formats.li.fraction_bits) - exact;
    error.rms += off * off / points;
    error.largest = std::max(error.largest, std::fabs(off));
  }
  EXPECT_GT(mean, 0.1);
  error.rms = std::sqrt(error.rms);
  std::cout << EnumNameLightShape(shape) << ", " << edges << " edges: RMS " << error.rms * 255
            << "/255, at most " << error.largest * 255 << "/255\n";
  return error;
}

TEST(ManyEdges, FortyEightInOnePenumbraFitTheDefaultWord) {
  for (const LightShape shape : kShapes) {
    const ArcError error = arc_error(shape, 48, Formats{}, 5000);
    EXPECT_LE(error.rms, 0.25 / 255);
    EXPECT_LE(error.largest, 2.0 / 255);
  }
}

TEST(ManyEdges, TenThousandInOnePenumbraFitAWiderWord) {
  Formats wide;
  wide.li.fraction_bits = 20;
  for (const LightShape shape : kShapes) {
    const ArcError error = arc_error(shape, 10000, wide, 20);
    EXPECT_LE(error.rms, 0.25 / 255);
    EXPECT_LE(error.largest, 2.0 / 255);
    EXPECT_GT(arc_error(shape, 10000, Formats{}, 2).rms, 2.0 / 255);  // the default is too narrow
  }
}

TEST(LightIntensityWord, OutOfRangeIsCountedWithItsFirstPixel) {
  // 20 polygons over all but the first row and column leave 1 - 20, in a word from -16 to 16.
  test::SyntheticTrace synthetic(12, 10, 0.5);
  const std::uint32_t plane = synthetic.add_plane(0, 0, 1, -0.2);
  for (int i = 0; i < 20; ++i) {
    synthetic.add_umbra({{1, 1, 0.2}, {12, 1, 0.2}, {12, 10, 0.2}, {1, 10, 0.2}}, test::Facing::eye,
                        plane, traces::kNone);
  }
  const CountConfig config;
  CountOptions options;
  options.datapath = DatapathKind::fixed;
  const CountResult narrow = std::move(count(synthetic.trace.view(), {&config, 1}, options)[0]);
  EXPECT_EQ(narrow.counters->li_overflow_pixels.value(), 99U);
  EXPECT_EQ(narrow.first_overflow, (std::array{1, 1}));
  options.datapath.formats.li.integer_bits = 6;
  const CountResult wide = std::move(count(synthetic.trace.view(), {&config, 1}, options)[0]);
  EXPECT_EQ(wide.counters->li_overflow_pixels.value(), 0U);
  EXPECT_EQ(wide.first_overflow, std::nullopt);
}

}  // namespace
}  // namespace wedgesim::model::datapath

// Does the fixed datapath give what double precision gives, on scenes and on points, lights and
// edges at random? The reference is the counter's exact arithmetic, written apart.
#include "model/datapath/setup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <random>

#include "model/count/primitive.h"
#include "model/count/z_frame.h"
#include "tests/functional/random.h"
#include "tests/model/datapath/one_point.h"
#include "tests/support/render.h"

namespace wedgesim::model::datapath {
namespace {

struct Errors {
  double largest = 0.0;  // beyond what one step of z changes
  double sum_of_squares = 0.0;
  std::size_t count = 0;

  void add(double exact, double fixed, double sensitivity) {
    const double error = std::fabs(exact - fixed);
    largest = std::max(largest, error - sensitivity);
    if (sensitivity <= 1.0 / 255.0) sum_of_squares += error * error;
    ++count;
  }
  double rms() const { return std::sqrt(sum_of_squares / static_cast<double>(count)); }
};

// Every pixel inside every wedge of a trace.
Errors errors_of(const traces::TraceView& trace, const Formats& formats) {
  const ZFrame frame(trace);
  const ZSteps steps(trace.header.depth_format);
  const ZMethod method = trace.header.z_fail_needed ? ZMethod::fail : ZMethod::pass;
  Errors errors;
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    const Primitive wedge = wedge_primitive(trace, method, i);
    const LightSetup setup = light_setup(trace, trace.wedges[i], steps, formats);
    for (int y = 0; y < frame.height(); ++y) {
      for (int x = 0; x < frame.width(); ++x) {
        const double z = frame.z(x, y);
        const double px = x + 0.5;
        const double py = y + 0.5;
        bool inside = z >= wedge.z.min && z <= wedge.z.max;
        for (const Plane& plane : wedge.planes) inside = inside && plane.inside(px, py, z);
        if (!inside) continue;
        const double exact = model::contribution(wedge.terms, px, py, z);
        double sensitivity = 0.0;
        for (const double step : {-1.0, 1.0}) {
          const double moved = model::contribution(wedge.terms, px, py, z + step / steps.one());
          sensitivity = std::max(sensitivity, std::fabs(moved - exact));
        }
        const Place at{2 * x + 1, 2 * y + 1, std::llrint(z * steps.one())};
        errors.add(exact, contribution(setup, at, formats.round()), sensitivity);
      }
    }
  }
  return errors;
}

traces::Trace render(const std::string& scene, traces::fb::WedgeKind kind,
                     functional::LightShape light) {
  return wedgesim::test::render(scene, kind, {240, 160}, light);
}

TEST(Contribution, IsWithinItsStatedErrorOnScenes) {
  for (const std::string scene : {"columns", "spheres27", "eye-in-shadow"}) {
    for (const auto& [kind, light] :
         {std::pair{traces::fb::WedgeKind_linear, functional::LightShape::rectangle},
          std::pair{traces::fb::WedgeKind_coverage, functional::LightShape::rectangle},
          std::pair{traces::fb::WedgeKind_coverage, functional::LightShape::sphere}}) {
      const Errors errors = errors_of(render(scene, kind, light).view(), Formats{});
      std::cout << scene << ' ' << traces::fb::EnumNameWedgeKind(kind) << ' '
                << (light == functional::LightShape::sphere ? "sphere" : "rectangle") << ": "
                << errors.count << " pixels, largest error " << errors.largest << ", RMS "
                << errors.rms() << '\n';
      EXPECT_GT(errors.count, 1000U);
      EXPECT_LE(errors.largest, 2e-5);
      EXPECT_LE(errors.rms(), 1e-5);
    }
  }
}

TEST(Contribution, LosesAccuracyWithItsBits) {
  const traces::Trace trace =
      render("columns", traces::fb::WedgeKind_coverage, functional::LightShape::sphere);
  Formats narrow;
  narrow.significand_bits = 10;
  EXPECT_GT(errors_of(trace.view(), narrow).rms(), 1e-4);
  narrow = {};
  narrow.form_bits = 40;
  EXPECT_GT(errors_of(trace.view(), narrow).rms(), 1e-3);
}

// Coverage by one edge, as seen from its point.
double in_double(const OnePoint& one) {
  return model::contribution(model::light_terms(one.trace.view(), one.wedge), 0.5, 0.5, 0.5);
}
double in_fixed(const OnePoint& one) {
  const ZSteps steps(traces::fb::DepthFormat_unorm24);
  const Formats formats;
  return contribution(light_setup(one.trace.view(), one.wedge, steps, formats), {1, 1, 8388608},
                      formats.round());
}

// Points behind an edge of any length that crosses the light's image, contact among them.
TEST(Contribution, IsWithinItsStatedErrorForPointsLightsAndEdgesAtRandom) {
  const unsigned seed = 2003;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (const bool sphere : {false, true}) {
    const auto shape = sphere ? traces::fb::LightShape_sphere : traces::fb::LightShape_rectangle;
    Errors errors;
    std::size_t lit = 0;
    for (int i = 0; i < 200000; ++i) {
      const double far = std::exp(uniform(std::log(2.0), std::log(300.0)));
      const double share = 1.0 - std::exp(uniform(std::log(1e-5), std::log(0.9)));
      const glm::dvec3 point{far * uniform(-0.7, 0.7), far * uniform(-0.7, 0.7), far};
      const double size = std::exp(uniform(std::log(1e-4), std::log(30.0)));
      const glm::dvec3 image{uniform(-1.2, 1.2), uniform(-1.2, 1.2), 0.0};
      const glm::dvec3 middle = image + (point - image) * share;
      const glm::dvec3 half{size * uniform(-1, 1), size * uniform(-1, 1), size * uniform(-1, 1)};
      if (middle.z - std::fabs(half.z) < 1.0) continue;
      const OnePoint one(shape, point, uniform(0.1, 10.0), middle - half, middle + half);
      const double exact = in_double(one);
      // What rounding the edge's ends to 2^-50 changes.
      const glm::dvec3 nudge = half * 1e-9;
      const OnePoint near(shape, point, 1.0, middle - half + nudge, middle + half + nudge);
      errors.add(exact, in_fixed(one), std::fabs(in_double(near) - exact));
      lit += exact > 0.0 ? 1 : 0;
    }
    std::cout << (sphere ? "sphere" : "rectangle") << ": " << errors.count << " points, " << lit
              << " in the penumbra, largest error " << errors.largest << ", RMS " << errors.rms()
              << '\n';
    EXPECT_GT(lit, errors.count / 4);
    EXPECT_LE(errors.largest, 2e-3);  // next to contact; the pixel bar is 8e-3
    EXPECT_LE(errors.rms(), 1e-5);
  }
}

// Edges with one end so far away that the other would have no digits on its exponent. The reference
// is double precision with the edge cut off outside the light.
TEST(Contribution, EndsThatAreNearKeepTheirDigits) {
  functional::Random random(2005);
  std::size_t lit = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 point{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0),
                           random.uniform(4.0, 20.0)};
    const glm::dvec3 image{random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9), 0.0};
    const glm::dvec3 begin = image + (point - image) * random.uniform(0.2, 0.8);
    const double angle = random.uniform(0.0, 6.3);
    const glm::dvec3 way{std::cos(angle), std::sin(angle), 0.0};
    const glm::dvec3 end = begin + way * std::exp2(random.uniform(10.0, 50.0));
    const OnePoint one(traces::fb::LightShape_rectangle, point, 1.0, begin, end);
    const OnePoint cut(traces::fb::LightShape_rectangle, point, 1.0, begin, begin + 8.0 * way);
    const double exact = in_double(cut);
    const double fixed = in_fixed(one);
    ASSERT_NEAR(exact, fixed, 1e-4) << "case " << i;
    lit += exact > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(lit, 10000U);
}

// Edges of which one end is seen before a corner of the light, but for rounding: the end and the
// line through both may be on different sides of that corner.
TEST(Contribution, EndsBeforeACornerOfTheLight) {
  const unsigned seed = 2004;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const auto whole = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  const auto eighths = [&](int most) { return whole(-most, most) / 8.0; };
  std::size_t lit = 0;
  for (int i = 0; i < 200000; ++i) {
    const glm::dvec3 point{eighths(64), eighths(64), whole(16, 320) / 8.0};
    const glm::dvec3 corner{whole(0, 1) * 2 - 1, whole(0, 1) * 2 - 1, 0.0};
    const glm::dvec3 other{eighths(16), eighths(16), 0.0};
    glm::dvec3 begin = corner + (point - corner) * (whole(1, 31) / 32.0);
    glm::dvec3 end = other + (point - other) * (whole(1, 31) / 32.0);
    const double longer = whole(0, 3) * std::ldexp(1.0, -whole(20, 54));
    const double nudge = std::ldexp(1.0, -whole(35, 54));
    begin += (begin - end) * longer;
    begin += glm::dvec3(whole(-1, 1), whole(-1, 1), whole(-1, 1)) * nudge;
    if (whole(0, 1) != 0) std::swap(begin, end);
    const OnePoint one(traces::fb::LightShape_rectangle, point, 1.0, begin, end);
    const double exact = in_double(one);
    const double fixed = in_fixed(one);
    ASSERT_NEAR(exact, fixed, 1e-4) << "case " << i;
    lit += exact > 1e-3 ? 1 : 0;
  }
  EXPECT_GT(lit, 100000U);
}

}  // namespace
}  // namespace wedgesim::model::datapath

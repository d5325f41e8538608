// Are random frames what their numbers say: text and back, closed meshes turned outwards, a
// harmless frame where all numbers are 0, and simpler ones that end there?
#include "reports/stress/families/random_case.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "functional/methods/frame.h"
#include "functional/scene/manifold.h"
#include "functional/scene/scene_check.h"
#include "reports/stress/families/random_shapes.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::reports::stress {
namespace {

TEST(RandomCase, TextSaysItsNumbers) {
  EXPECT_EQ(text_of(Genes{}), "");
  EXPECT_EQ(text_of(genes_of("light=1 second.then_by=-7")), "light=1 second.then_by=-7");
  std::mt19937_64 engine(1);
  for (int i = 0; i < 1000; ++i) {
    const Genes genes = draw(engine);
    EXPECT_EQ(genes_of(text_of(genes)), genes);
  }
}

TEST(RandomCase, OtherWordsAreRefused) {
  for (const char* word : {"light", "light=", "light=x", "light=1x", "lamp=1", "=1"}) {
    EXPECT_EQ(input_error_of([&] { genes_of(word); }),
              "random case: '" + std::string(word) + "' is no number of it; expected name=number");
  }
}

// Numbers beyond a range would be taken for places in tables that end there.
TEST(RandomCase, NumbersOutOfRangeAreRefused) {
  EXPECT_EQ(input_error_of([] { genes_of("light=1 up=7"); }),
            "random case: 'up=7' is out of range; expected a number from 0 to 2");
  EXPECT_EQ(input_error_of([] { genes_of("second.depth=-31"); }),
            "random case: 'second.depth=-31' is out of range; expected a number from -30 to 30");
  for (const Gene& gene : gene_table()) {
    const auto with = [&](int value) {
      return input_error_of(
          [&] { genes_of(std::string(gene.name) + "=" + std::to_string(value)); });
    };
    EXPECT_EQ(with(gene.low) + with(gene.high), "") << gene.name;
    EXPECT_NE(with(gene.low - 1), "") << gene.name;
    EXPECT_NE(with(gene.high + 1), "") << gene.name;
  }
}

TEST(RandomCase, NumbersAreInTheirRanges) {
  std::mt19937_64 engine(2);
  std::array<int, kGenes> nonzero{};
  for (int i = 0; i < 2000; ++i) {
    const Genes genes = draw(engine);
    for (std::size_t k = 0; k < kGenes; ++k) {
      EXPECT_GE(genes[k], gene_table()[k].low);
      EXPECT_LE(genes[k], gene_table()[k].high);
      nonzero[k] += genes[k] != 0 ? 1 : 0;
    }
  }
  for (std::size_t k = 0; k < kGenes; ++k) EXPECT_GT(nonzero[k], 0) << gene_table()[k].name;
}

TEST(RandomCase, ShapesAreClosedAndTurnedOutwards) {
  for (int number = 0; number < 6; ++number) {
    const Shape shape = shape_of(number);
    functional::Mesh mesh;
    mesh.positions = shape.corners;
    mesh.triangles = shape.triangles;
    EXPECT_NO_THROW(functional::require_closed(mesh, "shape"));
    double volume = 0.0;
    for (const auto& t : shape.triangles) {
      volume += glm::dot(shape.corners[t[0]], glm::cross(shape.corners[t[1]], shape.corners[t[2]]));
    }
    EXPECT_GT(volume, 0.1) << number;
  }
}

TEST(RandomCase, NothingButZerosIsHarmless) {
  const Case harmless = case_of(Genes{});
  functional::check_scene(harmless.scene, "harmless");
  const functional::Frame frame = functional::make_frame(harmless.scene, harmless.options);
  int penumbra = 0;
  for (const double li : frame.trace.expected_li) penumbra += li > 0.01 && li < 0.99 ? 1 : 0;
  EXPECT_GE(penumbra, 16);
}

TEST(RandomCase, SimplerFramesEndWithZeros) {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 100; ++i) {
    Genes genes = draw(engine);
    int steps = 0;
    // The last one is the least simple.
    for (auto next = simpler(genes); !next.empty(); next = simpler(genes)) {
      genes = next.back();
      ASSERT_LT(++steps, 10000);
    }
    EXPECT_EQ(genes, Genes{});
  }
}

}  // namespace
}  // namespace wedgesim::reports::stress

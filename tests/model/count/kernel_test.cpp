#include "model/count/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <random>
#include <set>

#include "model/count/footprint.h"
#include "tests/model/count/synthetic.h"
#include "tests/support/repetitions.h"

namespace wedgesim::model {
namespace {

// Blocks of random depth with random sets of pixels.
struct Pixels {
  std::vector<double> depths;
  std::vector<Block> blocks;
  std::vector<std::uint64_t> sets;
};

ZInterval around(const double* z) {
  return {*std::min_element(z, z + kBlockPixels), *std::max_element(z, z + kBlockPixels)};
}

Pixels random_pixels(std::mt19937& random, std::uint32_t blocks) {
  Pixels pixels;
  std::uniform_real_distribution<double> depth(0.0, 1.0);
  for (std::uint32_t i = 0; i < blocks * kBlockPixels; ++i) pixels.depths.push_back(depth(random));
  for (std::uint32_t i = 0; i < blocks; ++i) {
    // A block's depths are in a narrow interval, now and then in a wide one.
    const double narrow = i % 5 == 0 ? 1.0 : 0.05;
    double* z = &pixels.depths[std::size_t{i} * kBlockPixels];
    const double base = (1.0 - narrow) * depth(random);
    for (int k = 0; k < kBlockPixels; ++k) z[k] = base + narrow * z[k];
    pixels.blocks.push_back({i % 7, i / 7, z, around(z)});
    std::uint64_t set = random();
    set = set << 32 | random();
    for (unsigned thin = i % 4; thin > 0; --thin) set &= set >> 3;
    pixels.sets.push_back(i % 11 == 0 ? 0 : (i % 13 == 0 ? ~std::uint64_t{0} : set));
  }
  return pixels;
}

TEST(Kernel, ThereIsMoreThanOneInstructionSet) { EXPECT_GE(simd_kernels().size(), 2u); }

TEST(Kernel, EveryInstructionSetFindsTheSamePixelsInside) {
  std::size_t found = 0;
  for (unsigned seed = 1; seed <= repetitions(40); ++seed) {
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 56, 56, 4);
    Pixels pixels = random_pixels(random, 49);
    for (std::uint32_t w = 0; w < 4; ++w) {
      Primitive wedge = wedge_primitive(trace.view(), ZMethod::pass, w);
      // An interval that decides, not the planes alone.
      const double fifth = 0.2 * (wedge.z.max - wedge.z.min);
      wedge.z = {wedge.z.min + fifth, wedge.z.max - fifth};
      // Ties: depths on the interval's ends, planes through pixel centres.
      pixels.depths[5] = wedge.z.min;
      pixels.depths[6] = wedge.z.max;
      pixels.blocks[0].z_interval = around(pixels.blocks[0].z);
      wedge.planes.push_back({1.0, 0.0, 0.0, -3.5, (seed & 1) != 0});
      wedge.planes.push_back({0.0, 0.0, 0.0, 0.0, false});
      std::vector<std::uint64_t> expected(49), actual(49);
      scalar_kernel().inside(wedge, pixels.blocks, pixels.sets.data(), expected.data());
      for (std::uint64_t bits : expected) found += static_cast<std::size_t>(std::popcount(bits));
      for (const Kernel& kernel : simd_kernels()) {
        kernel.inside(wedge, pixels.blocks, pixels.sets.data(), actual.data());
        ASSERT_EQ(actual, expected) << kernel.name << " seed " << seed;
      }
    }
  }
  EXPECT_GT(found, 25u * repetitions(40));
}

// Block by block from the value at a corner, against one pixel at a time.
TEST(Kernel, TheFixedOneFindsWhatThePlainLoopFinds) {
  std::size_t found = 0;
  for (unsigned seed = 1; seed <= repetitions(40); ++seed) {
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 56, 56, 4);
    const traces::TraceView view = trace.view();
    const Operands operands(view, DatapathKind::fixed);
    Pixels pixels = random_pixels(random, 49);
    for (double& z : pixels.depths) z = std::floor(z * operands.far());
    for (Block& block : pixels.blocks) block.z_interval = around(block.z);
    for (std::uint32_t w = 0; w < 4; ++w) {
      const Primitive wedge = wedge_primitive(operands, ZMethod::pass, w);
      std::vector<std::uint64_t> expected(49), actual(49);
      scalar_kernel().inside(wedge, pixels.blocks, pixels.sets.data(), expected.data());
      fixed_kernel().inside(wedge, pixels.blocks, pixels.sets.data(), actual.data());
      for (std::uint64_t bits : expected) found += static_cast<std::size_t>(std::popcount(bits));
      ASSERT_EQ(actual, expected) << "seed " << seed;
      std::vector<UmbraBits> umbra(49), fixed(49);
      const ZInterval interval{pixels.depths[64 + 3], pixels.depths[64 + 9]};
      for (const Plane& plane : wedge.planes) {
        scalar_kernel().umbra(plane, interval, pixels.blocks, pixels.sets.data(), umbra.data());
        fixed_kernel().umbra(plane, interval, pixels.blocks, pixels.sets.data(), fixed.data());
        for (std::size_t i = 0; i < 49; ++i) {
          ASSERT_EQ(fixed[i].inner, umbra[i].inner) << "seed " << seed;
          ASSERT_EQ(fixed[i].before, umbra[i].before) << "seed " << seed;
          ASSERT_EQ(fixed[i].beyond, umbra[i].beyond) << "seed " << seed;
        }
      }
    }
  }
  EXPECT_GT(found, 25u * repetitions(40));
}

TEST(Kernel, EveryInstructionSetDecidesUmbraAlike) {
  for (unsigned seed = 1; seed <= repetitions(40); ++seed) {
    std::mt19937 random(seed);
    const Pixels pixels = random_pixels(random, 49);
    const Plane plane{0.01, -0.02, 0.6, -0.2, (seed & 1) != 0};
    const double tie = pixels.depths[64 + 3];
    const ZInterval interval{std::min(tie, 0.6), std::max(tie, 0.6)};
    std::vector<UmbraBits> expected(49), actual(49);
    scalar_kernel().umbra(plane, interval, pixels.blocks, pixels.sets.data(), expected.data());
    for (const Kernel& kernel : simd_kernels()) {
      kernel.umbra(plane, interval, pixels.blocks, pixels.sets.data(), actual.data());
      for (std::size_t i = 0; i < 49; ++i) {
        const std::uint64_t set = pixels.sets[i];
        ASSERT_EQ(actual[i].inner & set, expected[i].inner) << kernel.name << " seed " << seed;
        ASSERT_EQ(actual[i].before & set, expected[i].before) << kernel.name << " seed " << seed;
        ASSERT_EQ(actual[i].beyond & set, expected[i].beyond) << kernel.name << " seed " << seed;
      }
    }
  }
}

TEST(Kernel, EveryInstructionSetGivesTheSameWords) {
  std::set<std::size_t> kinds;
  std::size_t partial = 0;
  for (unsigned seed = 1; seed <= repetitions(60); ++seed) {
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 56, 56, 6);
    const Pixels pixels = random_pixels(random, 49);
    for (std::uint32_t w = 0; w < 6; ++w) {
      const Primitive wedge = wedge_primitive(trace.view(), ZMethod::pass, w);
      kinds.insert(wedge.terms.index());
      const double one = word_one(seed % 2 == 0 ? DatapathKind::exact : DatapathKind::paper255);
      std::vector<std::uint64_t> negated;
      for (std::uint64_t set : pixels.sets) negated.push_back(set * 0x9e3779b97f4a7c15U);
      std::vector<std::int64_t> expected(49 * kBlockPixels), actual(49 * kBlockPixels);
      scalar_kernel().words(wedge.terms, one, pixels.blocks, pixels.sets.data(), negated.data(),
                            expected.data());
      for (std::int64_t word : expected) {
        partial += word != 0 && std::abs(word) != static_cast<std::int64_t>(one) ? 1 : 0;
      }
      for (const Kernel& kernel : simd_kernels()) {
        kernel.words(wedge.terms, one, pixels.blocks, pixels.sets.data(), negated.data(),
                     actual.data());
        ASSERT_EQ(actual, expected) << kernel.name << " seed " << seed;
      }
    }
  }
  EXPECT_EQ(kinds.size(), 3u) << "linear, rectangle, sphere";
  EXPECT_GT(partial, 10000u);
}

}  // namespace
}  // namespace wedgesim::model

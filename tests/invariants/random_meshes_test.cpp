// Do the invariants hold on random closed meshes under random lights and cameras?
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "base/error.h"
#include "tests/support/invariants.h"
#include "tests/support/random_scene.h"

namespace wedgesim::tests {
namespace {

// WEDGESIM_SEED=N repeats one scene.
bool repeats_one() { return std::getenv("WEDGESIM_SEED") != nullptr; }
std::uint64_t first_seed() {
  return repeats_one() ? std::strtoull(std::getenv("WEDGESIM_SEED"), nullptr, 10) : 1;
}
int at_least(int scenes) { return repeats_one() ? 0 : scenes; }

struct Tally {
  int scenes = 0;
  int z_pass = 0;
  int z_fail = 0;
  int refused = 0;  // the light is not clear of a caster
  std::size_t most_witness_pixels = 0;
};

Tally run(EyePlace place, traces::fb::WedgeKind kind, int scenes) {
  Tally tally;
  for (std::uint64_t seed = first_seed(); tally.scenes < (repeats_one() ? 1 : scenes); ++seed) {
    functional::FrameOptions options;
    options.kind = kind;
    options.depth_format =
        seed % 3 == 0 ? traces::fb::DepthFormat_float32 : traces::fb::DepthFormat_unorm24;
    try {
      const InvariantReport report =
          check_invariants(random_scene(seed, place), options, seed % 50 == 0);
      EXPECT_EQ(report.failure, "") << "seed " << seed;
      (report.z_fail ? tally.z_fail : tally.z_pass) += 1;
      tally.most_witness_pixels = std::max(tally.most_witness_pixels, report.witness_pixels);
    } catch (const InputError& error) {
      ++tally.refused;
      EXPECT_LT(tally.refused, scenes / 10) << error.what();
      if (tally.refused >= scenes / 10) break;
      continue;
    }
    ++tally.scenes;
  }
  std::cout << "seeds from " << first_seed() << ": " << tally.scenes << " scenes, z-pass "
            << tally.z_pass << ", z-fail " << tally.z_fail << ", refused " << tally.refused
            << ", most pixels that differ from the witness " << tally.most_witness_pixels << '\n';
  return tally;
}

TEST(RandomMeshes, CoverageSeenFromOutside) {
  const Tally tally = run(EyePlace::outside, traces::fb::WedgeKind_coverage, 600);
  EXPECT_GE(tally.z_pass, at_least(400));
  EXPECT_LE(tally.most_witness_pixels, 8U);
}

TEST(RandomMeshes, CoverageSeenFromTheShadow) {
  const Tally tally = run(EyePlace::in_shadow, traces::fb::WedgeKind_coverage, 400);
  EXPECT_GE(tally.z_fail, at_least(300));
  EXPECT_LE(tally.most_witness_pixels, 8U);
}

TEST(RandomMeshes, LinearSeenFromOutside) {
  const Tally tally = run(EyePlace::outside, traces::fb::WedgeKind_linear, 150);
  EXPECT_LE(tally.most_witness_pixels, 20U);
}

TEST(RandomMeshes, LinearSeenFromTheShadow) {
  const Tally tally = run(EyePlace::in_shadow, traces::fb::WedgeKind_linear, 100);
  EXPECT_GE(tally.z_fail, at_least(75));
}

}  // namespace
}  // namespace wedgesim::tests

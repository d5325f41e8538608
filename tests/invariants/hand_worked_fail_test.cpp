// Is every counter right in z-fail, with a cap, a bottom and `linear` wedges, on a frame that was
// worked out by hand? 8x4 pixels, made without a renderer; every row is the same, so what follows
// is about one row of it, columns 0-7, and depth z.
//
// clang-format off
// THE SCENE. A caster above columns 0 and 1 (depth 0.15), a floor at 0.5. The caster's shadow begins
// at depth 0.2 and is skewed to the right:
//   cap     at 0.2, columns 0-2 as x goes from 0 to 2; faces the eye
//   left    from (x, z) = (0, 0.2) to (3.9, 0.8); faces away; inner: x >= 6.5 (z - 0.2)
//   right   from (2, 0.2) to (7.4, 0.8); faces the eye; inner: x <= 2 + 9 (z - 0.2)
//   bottom  at 0.8, x from 3.9 to 7.4; faces away
// Two `linear` wedges, whose front planes (full light) are the shadow's sides:
//   W1  right's: back from (2, 0.2) to (4.6, 0.8), x >= 2 + 13/3 (z - 0.2); bottom from 4.6 to 7.4
//   W2  left's:  back from (0, 0.2) to (5.8, 0.8), x <= 29/3 (z - 0.2);     bottom from 3.9 to 5.8
// Their side planes are y >= 0 and y <= 4. W1's far faces are its back and its bottom, W2's its
// front and its bottom; those are rasterized.
//
// THE PIXELS. On the floor, W1 is 3.3 <= x <= 4.7, W2 1.95 <= x <= 2.9. Centres are at .5. The cap is
// always hit, the others where the point is in front of them: left where inner, right where not.
//
//   column        0   1   2   3   4   5   6   7
//   cap           +   +                            + is +1, - is -1, o is covered and not hit
//   left          -   -   -   -
//   right                 o   o   o   +   +
//   bottom                        -   -   -
//   W1 faces              B   B   B   b   b        B back, b bottom
//   W1 inside                 i   i
//   W2 faces      F   F   F   F   b   b            F front, b bottom
//   W2 inside             i
//   stencil       0   0  -1  -1  -1   0   0   0
//   contributions 2   2   2   2   2   2   2   0
//
// An intensity is back / (front + back), the distances of a point to the two planes: W2 at column 2
// is 0.4 / (0.55 + 0.4) = 8/19, W1 at 3 is 0.2 / 1.4 = 1/7, at 4 it is 1.2 / 1.4 = 6/7. With the
// stencil that is LI in columns 2-4; it is 1 elsewhere.
//
// TILES of 4: A is columns 0-3 (z 0.15 to 0.5), B 4-7 (0.5). `both` and umbra `zmax`:
//   - W2 in B: x >= 4 is beyond its back plane, 2.9: `planes` culls its bottom there.
//   - nothing else: at a box corner each other plane and polygon is reached.
// TILES of 2: T0-T3, each twice, one above the other; T0 is at 0.15. With accept `zmin`, too:
//   - W2 in T0: 0.15 is before its interval: `zrange`. In T2: `planes`, as before. W1 in T3: x >= 6 is
//     beyond its front plane, 4.7: `planes`.
//   - right in T1: all of it is inner, even x = 4 (0.5 >= 0.2 + 2/9): culled. In T3 none is, not even
//     x = 6 (0.5 < 0.2 + 4/9): accepted. In T2 neither.
//   - left in T0: 0.15 is before its interval: accepted. In T1 all is inner, even x = 2 (0.5 <= 0.2 +
//     2/6.5): accepted. In A x = 0 is not.
//   - bottom in T2, T3: 0.5 <= 0.8: accepted.
//
// COUNTERS: three-pass, then single-pass, where left faces as W2's faces do and is shared, right is
// not. Pixels: 4 a column. `share all` is for `coverage`: on `linear` wedges it is as `eye`.
// z_reads             W1 5 columns, right 5, W2 6, left 4, bottom 3: 23, 92 pixels; left is within
//                     W2's faces: 16 less. Culled in tiles of 4: W2's columns 4, 5: 8 less. In tiles
//                     of 2: W1 2-5, right 4-5, W2 2-3: 32; left reads nothing, shared or not.
// z_reads_whole_tile  A and B for W1, right, W2; A for left, B for bottom: 8 tiles of 16; 7 if left
//                     is shared. Culled: 7 and 6. Tiles of 2: W1 2, right 1, W2 1, twice, 4 pixels: 32.
// li_writes           hit: cap 2, left 4, right 2, bottom 3: 44 pixels; inside 12: 56. Left shared:
//                     W2's pixels inside are among its hits: 4 less.
// stencil_writes, _reads   three-pass: the 44; li_reads is the rest: 12, 52.
// tile_visits         tiles of 4: W1's back A, B, its bottom B; W2's front A, bottom B: 5; right 2,
//                     left, cap, bottom 1 each: 5. Left shared: 9. Tiles of 2: W1's T1 T2, T2 T3; W2's
//                     T0 T1, T2: 7; right 3, left 2, cap 1, bottom 2: 8; twice: 30, shared 26.
// tile_reads          2 a face; umbra 1, with accept 2, none for the cap: 10 + 4, left shared 10 + 3;
//                     tiles of 2: twice 14 + 14, shared 14 + 10.
// tile_build_reads    32 where a test is enabled; tile_words two for each of 2 or 8 tiles.
// visits_culled_...   as in TILES: `planes` 1; `zrange` 1, `planes` 2, twice.
// umbra_visits_...    culled 1, accepted 1 + 2 + 2, twice.
// pixels_covered      23 columns as in z_reads, and 2 of the cap: 100. pixels_inside 12.
// merge_reads         32 and the 12 of columns 2-4; merge_writes 12; clear_writes 32, with stencil 64.
// wedge_bytes         each wedge 176, 5 planes 160, 3 faces 96, its polygon 40, 16 indices 64, as many
//                     vertices 256: 792; three-pass fetches both twice.
// z_reads_min         columns 0-6: 28; in tiles of 2, columns 2-5: 16. li_writes_min columns 0-6.
// z_reads_floor, li_writes_floor   columns 2-4: 12. contributions_max 2.
// all_bytes           4 (z_reads + tile_reads + tile_build_reads) + 2 (2 li_reads + 2 merge_writes +
//                     32) + (2 stencil_writes + 64) with a stencil + wedge_bytes. All but the first:
//                     160 + 152 + 3168 = 3480; single-pass 272 + 1584 = 1856. The first, in words:
//                     92, 76; 130, 113; 120, 112.
// clang-format on
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "model/count/count.h"
#include "tests/model/count/synthetic.h"

namespace wedgesim::tests {
namespace {

using namespace model;  // NOLINT: the vocabulary of configurations
using model::test::Facing;
using model::test::SyntheticTrace;
namespace fb = traces::fb;

// A polygon on all four rows, from (x0, z0) to (x1, z1).
std::vector<model::test::Point> strip(double x0, double z0, double x1, double z1) {
  return {{x0, 0, z0}, {x1, 0, z1}, {x1, 4, z1}, {x0, 4, z0}};
}

SyntheticTrace scene(fb::WedgeKind kind) {
  SyntheticTrace trace(8, 4, 0.5);
  for (std::uint32_t i = 0; i < 8; ++i) trace.set_depth(i % 2, i / 2, 0.15);
  const std::uint32_t above = trace.add_plane(0, 1, 0, 0);    // y >= 0
  const std::uint32_t below = trace.add_plane(0, -1, 0, 4);   // y <= 4
  const std::uint32_t ends = trace.add_plane(0, 0, -1, 0.8);  // z <= 0.8
  const std::uint32_t right = trace.add_plane(-1, 0, 9, 2 - 9 * 0.2);
  const std::uint32_t left = trace.add_plane(1, 0, -6.5, 6.5 * 0.2);
  const std::uint32_t back_1 = trace.add_plane(1, 0, -13.0 / 3, -2 + 13.0 / 3 * 0.2);
  const std::uint32_t back_2 = trace.add_plane(-1, 0, 29.0 / 3, -29.0 / 3 * 0.2);
  trace.add_face(strip(2, 0.2, 7.4, 0.8), Facing::eye, right);
  trace.add_face(strip(2, 0.2, 4.6, 0.8), Facing::away, back_1);
  trace.add_face(strip(4.6, 0.8, 7.4, 0.8), Facing::away, ends);
  const auto w1 = trace.add_wedge(kind, {right, back_1, above, below, ends}, 0.2, 0.8);
  trace.add_umbra(strip(2, 0.2, 7.4, 0.8), Facing::eye, right, w1);
  trace.add_face(strip(0, 0.2, 3.9, 0.8), Facing::away, left);
  trace.add_face(strip(0, 0.2, 5.8, 0.8), Facing::eye, back_2);
  trace.add_face(strip(3.9, 0.8, 5.8, 0.8), Facing::away, ends);
  const auto w2 = trace.add_wedge(kind, {left, back_2, above, below, ends}, 0.2, 0.8);
  trace.add_umbra(strip(0, 0.2, 3.9, 0.8), Facing::away, left, w2);
  trace.add_umbra(strip(0, 0.2, 2, 0.2), Facing::eye, 0, traces::kNone, fb::UmbraRole_cap);
  trace.add_umbra(strip(3.9, 0.8, 7.4, 0.8), Facing::away, ends, traces::kNone,
                  fb::UmbraRole_bottom);
  return trace;
}

// Three-pass and single-pass: not culled in tiles of 4; culled; culled in tiles of 2, accept
// `zmin`.
constexpr std::size_t kConfigs = 6;
std::vector<CountConfig> configurations(Share share) {
  std::vector<CountConfig> configs;
  for (const int step : {0, 1, 2}) {
    for (const Mode mode : {Mode::three_pass, Mode::single_pass}) {
      CountConfig config{.mode = mode, .tile = step == 2 ? 2U : 4U, .share = share};
      config.cull = step == 0 ? Cull::none : Cull::both;
      config.umbra_cull = step == 0 ? UmbraCull::none : UmbraCull::zmax;
      config.accept = step == 2 ? Accept::zmin : Accept::none;
      config.z = ZChoice::fail;
      configs.push_back(config);
    }
  }
  return configs;
}

struct Expected {
  std::string_view counter;
  std::array<std::uint64_t, kConfigs> values;
};

// clang-format off
constexpr Expected kExpected[] = {
  {"z_reads",               {  92,   76,   84,   68,   32,   32}},
  {"z_reads_whole_tile",    { 128,  112,  112,   96,   32,   32}},
  {"li_writes",             {  56,   52,   56,   52,   56,   52}},
  {"stencil_writes",        {  44,    0,   44,    0,   44,    0}},
  {"stencil_reads",         {  44,    0,   44,    0,   44,    0}},
  {"li_reads",              {  12,   52,   12,   52,   12,   52}},
  {"tile_visits",           {  10,    9,   10,    9,   30,   26}},
  {"tile_reads",            {   0,    0,   14,   13,   56,   48}},
  {"tile_build_reads",      {   0,    0,   32,   32,   32,   32}},
  {"tile_words",            {   0,    0,    4,    4,   16,   16}},
  {"visits_culled_zmax",    {   0,    0,    0,    0,    0,    0}},
  {"visits_culled_zrange",  {   0,    0,    0,    0,    2,    2}},
  {"visits_culled_planes",  {   0,    0,    1,    1,    4,    4}},
  {"visits_culled_sat",     {   0,    0,    0,    0,    0,    0}},
  {"umbra_visits_culled",   {   0,    0,    0,    0,    2,    2}},
  {"umbra_visits_accepted", {   0,    0,    0,    0,   10,   10}},
  {"tiles_inside",          {   0,    0,    0,    0,    0,    0}},
  {"pixels_covered",        { 100,  100,  100,  100,  100,  100}},
  {"pixels_inside",         {  12,   12,   12,   12,   12,   12}},
  {"merge_reads",           {  44,    0,   44,    0,   44,    0}},
  {"merge_writes",          {  12,    0,   12,    0,   12,    0}},
  {"clear_writes",          {  64,   32,   64,   32,   64,   32}},
  {"wedge_bytes",           {3168, 1584, 3168, 1584, 3168, 1584}},
  {"z_reads_min",           {  28,   28,   28,   28,   16,   16}},
  {"li_writes_min",         {  28,   28,   28,   28,   28,   28}},
  {"z_reads_floor",         {  12,   12,   12,   12,   12,   12}},
  {"li_writes_floor",       {  12,   12,   12,   12,   12,   12}},
  {"li_overflow_pixels",    {   0,    0,    0,    0,    0,    0}},
  {"contributions_max",     {   2,    2,    2,    2,    2,    2}},
  {"degenerate_wedges",     {   0,    0,    0,    0,    0,    0}},
  {"all_bytes",             {3848, 2160, 4000, 2308, 3960, 2304}},
};
// clang-format on

class HandWorkedFail : public ::testing::TestWithParam<Share> {};

TEST_P(HandWorkedFail, LinearWedgesUnderACaster) {
  const SyntheticTrace trace = scene(fb::WedgeKind_linear);
  CountOptions options;
  options.maps = true;
  const auto results = count(trace.trace.view(), configurations(GetParam()), options);
  ASSERT_EQ(std::size(kExpected), results[0].counters->counters().size());
  const std::array<double, 8> li{1, 1, 8.0 / 19, 1.0 / 7, 6.0 / 7, 1, 1, 1};
  for (std::size_t i = 0; i < kConfigs; ++i) {
    SCOPED_TRACE("configuration " + std::to_string(i));
    for (std::size_t k = 0; k < std::size(kExpected); ++k) {
      const Counter& counter = *results[i].counters->counters()[k];
      ASSERT_EQ(counter.name(), kExpected[k].counter);
      EXPECT_EQ(counter.value(), kExpected[k].values[i]) << counter.name();
    }
    for (std::size_t pixel = 0; pixel < 32; ++pixel) {
      EXPECT_NEAR(static_cast<double>(results[i].li[pixel]) / word_one(DatapathKind::exact),
                  li[pixel % 8], 1e-6);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shares, HandWorkedFail, ::testing::Values(Share::eye, Share::all));

// The same wedges of the kind `coverage`: `share all` shares right, too, with W1. Single-pass
// alone. z_reads             right is within W1's faces: 76 - 20, 68 - 20; tiles of 2: 32 - 8.
// z_reads_whole_tile  right's A and B less, its T2 less, twice.
// li_writes           W1's pixels inside are none of right's hits: as before.
// tile_visits         right's 2 less; in tiles of 2 its 3, twice. tile_reads: 2 less; 12 less.
TEST(HandWorkedFailShareAll, CoverageWedgesUnderACaster) {
  const SyntheticTrace trace = scene(fb::WedgeKind_coverage);
  const auto results = count(trace.trace.view(), configurations(Share::all));
  const auto expect = [&](std::size_t config, std::array<std::uint64_t, 5> values) {
    SCOPED_TRACE("configuration " + std::to_string(config));
    const Counters& counters = *results[config].counters;
    EXPECT_EQ(counters.z_reads.value(), values[0]);
    EXPECT_EQ(counters.z_reads_whole_tile.value(), values[1]);
    EXPECT_EQ(counters.li_writes.value(), values[2]);
    EXPECT_EQ(counters.tile_visits.value(), values[3]);
    EXPECT_EQ(counters.tile_reads.value(), values[4]);
  };
  expect(1, {56, 80, 52, 7, 0});
  expect(3, {48, 64, 52, 7, 11});
  expect(5, {24, 24, 52, 20, 36});
}

}  // namespace
}  // namespace wedgesim::tests

// Is every counter right on a frame that was worked out by hand: a triangular prism over a floor,
// 16x16 pixels, one rectangular light, `coverage`, unorm24, z-pass?
//
// clang-format off
// THE SCENE. The eye is 8 above the floor, looks straight down and sees 90 degrees, so that at
// distance D below it one world unit is 8/D pixels: 1 on the floor (D = 8), 2 on the prism's top
// (D = 4). World x is x on the screen, world z is y. Near plane 2 and far plane 10 give the depth
// 5/4 (1 - 2/D): 5/8 on the top, 15/16 on the floor. 5/8 of 2^24 - 1 ends in .375, so the stored
// depth of the top is rounded towards the eye, to 2e-8 less than 5/8.
//   The light is as high as the eye. A ray from its point l (in world x, z) through a point of the
// top whose image is Q is seen at Q - k l pixels, with k = 2 - 8/D, at each distance D: k = 0 on
// the top, 1 on the floor, 1.0074 where the volumes end (0.002 of the diagonal of all there is, 30,
// below the floor: 0.06).
//   The top is the triangle A (3/8, 3), B (8 3/8, 3), C (3/8, 11) in pixels; BC is x + y = 11 3/8.
// The prism is so thin (1/32) that its sides cover no pixel centre. The light's centre is at
// -(2 3/4, 1 5/8), its half axes are 1 1/2 and 1/2. It is above the inside of the top, which
// therefore is the only face that it shines on: one cap, three silhouette edges, three wedges.
//
// ON THE FLOOR (k = 1). The hard shadow is the top's image moved by (2 3/4, 1 5/8). The penumbra of
// an edge is its image moved by all of 2 3/4 +- 1 1/2, 1 5/8 +- 1/2:
//   AB  1 5/8 <= x <= 12 5/8, 4 1/8 <= y <= 5 1/8
//   CA  1 5/8 <= x <= 4 5/8,  4 1/8 <= y <= 13 1/8
//   BC  x >= 1 5/8, y >= 4 1/8, x <= 12 5/8, y <= 13 1/8, 13 3/4 <= x + y <= 17 3/4
// A wedge's planes cut the floor in the outline of its region, and the top's height in its edge: no
// pixel of the top is inside a wedge (nor is its depth in a wedge's interval, which begins 1e-9
// before 5/8).
//   A wedge is the hull of its edge (k = 0) and of that region with k = 1.0074. Sides that go
// outwards from the edge to the floor face the eye: L, which the whole edge bounds, E and F, at one
// end of it. The shadow quad goes from the edge to the edge moved by 1.0074 (2 3/4, 1 5/8); it is
// inside the hull. BC moves outwards: its quad faces the eye and passes where the floor is in the
// shadow, everywhere. AB and CA move inwards, below the top: their quads face away and pass where
// the point is not on the shadow's side: on the floor above y = 4 5/8 (AB), left of x = 3 1/8 (CA).
// No line comes within 1/20 pixel of a pixel centre; snapping moves it by less than 1/128.
//
// THE PIXELS, in tiles of 4; rows 0-2 and 13-15 are empty. Left to right: faces; the quad, # where
// it passes and o where not; pixels inside; then in turn the top (T), the sum that the stencil gets
// (- is -1, else 0), the number of contributions.
//
// AB  faces 21            quad 16, passed 5     inside 6
//   3  .LLL LLLL LE.. ....   .ooo oooo #... ....   .... .... .... ....   TTTT TTTT .... ....
//
//   4  .LLL LLLL LLLE E...   ...o ooo# ###. ....   .... ...i iiii i...   TTTT TTT. .... ....
//   5  .... .... .... ....   .... .... .... ....   .... .... .... ....   TTTT TT.. .... ....
//   6  .... .... .... ....   .... .... .... ....   .... .... .... ....   TTTT T... .... ....
//   7  .... .... .... ....   .... .... .... ....   .... .... .... ....   TTTT .... .... ....
//
//   8  .... .... .... ....   .... .... .... ....   .... .... .... ....   TTT. .... .... ....
//   9  .... .... .... ....   .... .... .... ....   .... .... .... ....   TT.. .... .... ....
//  10  .... .... .... ....   .... .... .... ....   .... .... .... ....   T... .... .... ....
//
// BC  faces 53            quad 32, passed 32    inside 35              stencil not 0: 22
//   3  .... .... EL.. ....   .... .... #... ....   .... .... .... ....   .... .... .... ....
//
//   4  .... ...L LLLE E...   .... ...# ###. ....   .... .... .iii i...   .... .... .... ....
//   5  .... ..LL LLLL ....   .... ..## ##.. ....   .... .... iiii ....   .... ..-- --.. ....
//   6  .... .LLL LLL. ....   .... .### #... ....   .... ...i iii. ....   .... .--- -... ....
//   7  .... LLLL LL.. ....   .... #### .... ....   .... ..ii ii.. ....   .... ---- .... ....
//
//   8  ...L LLLL L... ....   ...# ###. .... ....   .... .iii i... ....   ...- ---. .... ....
//   9  ..LL LLLL .... ....   ..## ##.. .... ....   .... iiii .... ....   ...- --.. .... ....
//  10  .LLL LLL. .... ....   .### #... .... ....   ...i iii. .... ....   ...- -... .... ....
//  11  .LLL LL.. .... ....   .### .... .... ....   ..ii ii.. .... ....   ...- .... .... ....
//
//  12  .FFL L... .... ....   .... .... .... ....   ..ii i... .... ....   .... .... .... ....
//
// CA  faces 45            quad 24, passed 5     inside 15              contributions
//   3  LL.. .... .... ....   o... .... .... ....   .... .... .... ....   .... .... 2... ....
//
//   4  LLLL L... .... ....   ooo. .... .... ....   .... .... .... ....   .... ...3 3442 2...
//   5  LLLL L... .... ....   ooo. .... .... ....   .... .... .... ....   .... ..11 2211 ....
//   6  LLLL L... .... ....   ooo. .... .... ....   .... .... .... ....   .... .112 211. ....
//   7  LLLL L... .... ....   ooo. .... .... ....   .... i... .... ....   .... 2122 11.. ....
//
//   8  LLLL L... .... ....   ooo. .... .... ....   ...i i... .... ....   ...2 2221 1... ....
//   9  LLLL L... .... ....   oo#. .... .... ....   ..ii i... .... ....   ..32 3211 .... ....
//  10  LLLL L... .... ....   o##. .... .... ....   ..ii i... .... ....   .233 311. .... ....
//  11  .LLL L... .... ....   .##. .... .... ....   ..ii i... .... ....   .243 21.. .... ....
//
//  12  .EEL L... .... ....   .... .... .... ....   ..ii i... .... ....   ..22 2... .... ....
//
// TILES. A visit of the faces has |face| pixels each; U is the quad's; `hit` and `in` are passed
// and inside, `h|i` is their union. `both` and umbra `zmax`, tile 4:
//   - tile (0,1) holds the top alone: zmax, rounded down, is before every wedge and quad begins.
//     `zrange` culls the faces there, umbra `zmax` the quads.
//   - tile (2,0) holds the floor alone and ends at y = 4, where no wedge on the floor has begun
//     (4 1/8): `planes` culls the faces. Its quads stay: AB's passes above y = 4 5/8, BC's up to
//     x + y = 15 3/4, and the tile begins at 8.
//   - tiles with top and floor are at one of the two depths partly inside each plane: all stay. So
//     do the other floor tiles, which all reach into the region on the floor.
//   - accept `zmin`: AB's quad passes in all of floor tile (2,0), which ends above y = 4 5/8.
//     Nowhere else: a tile would have to end at x + y = 15 3/4 (BC) or x = 3 1/8 (CA), and no point
//     of the top passes AB or CA, nor BC.
//   - no tile of 4 or 8 is within a region on the floor (4 1/8 to 5 1/8; 1 5/8 to 4 5/8; x + y 4
//     wide): tiles_inside 0.
// In tiles of 8 nothing is culled: each that is visited holds floor of the region or of the quad.
//
//   tile 8   faces  U hit in h|i                tile 4   faces  U hit in h|i
//   AB (0,0)    14 12   1  1   1                AB (0,0)     3  3   0  0   0
//      (1,0)   3+4  4   4  5   6                   (1,0)     4  4   0  0   0
//   BC (0,0)    10 10  10  3  10                   (2,0)   1+1  1   1  0   1  planes
//      (1,0)  3+13  7   7 13  15                   (0,1)     3  1   0  0   0  zrange, umbra zmax
//      (0,1)  24+2 15  15 18  25                   (1,1)     4  4   1  1   1
//      (1,1)     1  0   0  1   1                   (2,1)   1+3  3   3  4   4
//   CA (0,0)    22 13   0  1   1                   (3,1)     1  0   0  1   1
//      (0,1)  21+2 11   5 14  16
//
//   tile 4   faces  U hit in h|i                tile 4   faces  U hit in h|i
//   BC (2,0)   1+1  1   1  0   1  planes        CA (0,0)     2  1   0  0   0
//      (1,1)    10 10  10  3  10                   (0,1)    16 12   0  0   0  zrange, umbra zmax
//      (2,1)  1+12  6   6 12  13                   (1,1)     4  0   0  1   1
//      (3,1)     1  0   0  1   1                   (0,2)    15 11   5  7   9
//      (0,2)     9  9   9  3   9                   (1,2)     4  0   0  4   4
//      (1,2)    13  6   6 12  13                   (0,3)   1+2  0   0  2   2
//      (2,2)     1  0   0  1   1                   (1,3)     1  0   0  1   1
//      (0,3)   1+2  0   0  2   2
//      (1,3)     1  0   0  1   1
//
// COUNTERS. In single-pass BC's quad is shared; AB's and CA's are under `all` alone.
// z_reads             without culling: faces 21 + 53 + 45 = 119, quads 16 + 32 + 24 = 72: 191;
//                     quads are within faces: BC shared 191 - 32 = 159, all shared 119.
//                     Tile 4, culled: faces - (3 + 2) - 2 - 16 = 96, quads - 1 - 12 = 59: 155.
//                     BC shared: its quad counts only where its faces are culled: 96 + 1, own AB
//                     15, CA 12: 124; all: 96 + 1 + 1 = 98. `zmin`: AB's pixel of (2,0) less.
// z_reads_whole_tile  tile 8: 8 tiles of faces, 7 of quads: 15 * 64; 3 of BC's less: 12 * 64; all
//                     8 * 64. Tile 4: 23 and 14, 5 of BC's: 37, 32, 23 times 16. Culled: 19 and 12:
//                     31; BC shared: 19, own 5 + 2, BC's in (2,0): 27; all: 19 + 2 = 21.
//                     `zmin`: AB's in (2,0) less: 30 and 20.
// li_writes           hit 5 + 32 + 5 = 42, in 6 + 35 + 15 = 56: 98. BC shared: h|i 51, own 5 + 6
//                     and 5 + 15: 82; all: h|i 7 + 51 + 17 = 75. Culling and acceptance change
//                     none.
// stencil_writes, _reads   three-pass: the 42; li_reads is the rest: 56, 82, 75.
// tile_visits         tile 8: faces 3 + 6 + 3 = 12, quads 2 + 3 + 2 = 7: 19; BC shared 16; all 12.
//                     Tile 4: faces 9 + 12 + 8 = 29, quads 6 + 5 + 3 = 14: 43; 38; 29.
// tile_reads          two a face (`both`), one a quad of its own (`zmax`; with `zmin` two): tile 8
//                     24 + 7, 24 + 4, 24; tile 4 58 + 14, 58 + 9, 58; `zmin` 58 + 28, 58.
// tile_build_reads    256 pixels where a test is enabled; tile_words two for each of 4 or 16 tiles.
// visits_culled_...   `zrange` 1 + 1, `planes` 2 + 2; `zmax` and `sat` are not enabled.
// umbra_visits_culled AB's and CA's in (0,1): 2; umbra_visits_accepted AB's in (2,0): 1.
// pixels_covered      119 + 72 = 191; pixels_inside 56.
// merge_reads         256 stencil words and 22 LI words; merge_writes 22; clear_writes 256, with a
//                     stencil 512.
// wedge_bytes         AB, CA: 176, 5 planes 160, 5 faces 160, indices 4 (4 + 3 + 4 + 3 + 4), quad
//                     40 + 16, vertices 16 (2 + 4 + 4): 784. BC: 176, 7 planes 224, 7 faces 224,
//                     indices 4 (4 * 3 + 2 * 4 + 6), 56, vertices 16 (2 + 6 + 4): 976. (A wedge's
//                     outline is grown by 1/256 pixel: its edge's ends are not the quad's.)
//                     Together 2544; three-pass fetches each twice.
// z_reads_min         pixels in a face: AB and BC 21 + 53 - 8, 22 more of CA: 88. Culled, tile 4:
//                     (0,1) loses 16, (2,0) keeps (8,3) by the quads but not (9,3): 71. With `zmin`
//                     BC's quad still reads (8,3).
// li_writes_min       pixels with a contribution: 51.
// li_writes_floor     LI is what a point sees of the light: not 1 within the top's image moved as
//                     in ON THE FLOOR. That leaves out (8,3), (1,10) and (1,11), whose two
//                     contributions are +1 and -1: 48.
// z_reads_floor       pixels inside a wedge: 56, 4 in both AB and BC, 9 in both BC and CA: 43.
// contributions_max   4, at (9,4), (10,4) and (2,11). li_overflow_pixels, degenerate_wedges 0.
// all_bytes           4 (z_reads + tile_reads + tile_build_reads) + 2 (2 li_reads + 2 merge_writes
//                     + 256 clears) + (2 stencil_writes + 512) with a stencil + wedge_bytes.
//                     All but the first: three-pass 2 (112 + 44 + 256) + 84 + 512 + 5088 = 6508; BC
//                     shared 2 (164 + 256) + 2544 = 3384; all 2 (150 + 256) + 2544 = 3356.
//                     The first, in words: 191, 159, 119; culled in tile 8 191 + 31 + 256 = 478,
//                     443, 399, in tile 4 155 + 72 + 256 = 483, 447, 412, with `zmin` 496, 411.
// needless_visits     tile 8: CA's quad in (0,0) alone. Tile 4, faces with none inside: AB 1 + 1 + 2
//                     + 1, BC 2, CA 1 + 1; quads with no hit: AB 3, CA 2: 14. `both` finds 6 + 2.
// clang-format on
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "functional/methods/frame.h"
#include "model/count/count.h"
#include "tests/support/hand_worked_scene.h"

namespace wedgesim::tests {
namespace {

using namespace model;  // NOLINT: the vocabulary of configurations

// In threes: three-pass, single-pass sharing eye-facing umbra polygons, sharing all. Not culled in
// tiles of 8; culled; the same in tiles of 4. At last, culled in tiles of 4, accept `zmin`:
// three-pass and single-pass sharing all.
constexpr std::size_t kConfigs = 14;
std::vector<CountConfig> configurations() {
  std::vector<CountConfig> configs;
  for (const unsigned tile : {8U, 4U}) {
    for (const bool culled : {false, true}) {
      CountConfig config;
      config.tile = tile;
      config.cull = culled ? Cull::both : Cull::none;
      config.umbra_cull = culled ? UmbraCull::zmax : UmbraCull::none;
      config.z = ZChoice::pass;
      config.mode = Mode::three_pass;
      configs.push_back(config);
      config.mode = Mode::single_pass;
      config.share = Share::eye;
      configs.push_back(config);
      config.share = Share::all;
      configs.push_back(config);
    }
  }
  for (const std::size_t culled_in_4 : {9U, 11U}) {
    configs.push_back(configs[culled_in_4]);
    configs.back().accept = Accept::zmin;
  }
  return configs;
}

struct Expected {
  std::string_view counter;
  std::array<std::uint64_t, kConfigs> values;
};

// clang-format off
constexpr Expected kExpected[] = {
  {"z_reads",               {191, 159, 119, 191, 159, 119, 191, 159, 119, 155, 124,  98, 154,  97}},
  {"z_reads_whole_tile",    {960, 768, 512, 960, 768, 512, 592, 512, 368, 496, 432, 336, 480, 320}},
  {"li_writes",             { 98,  82,  75,  98,  82,  75,  98,  82,  75,  98,  82,  75,  98,  75}},
  {"stencil_writes",        { 42,   0,   0,  42,   0,   0,  42,   0,   0,  42,   0,   0,  42,   0}},
  {"stencil_reads",         { 42,   0,   0,  42,   0,   0,  42,   0,   0,  42,   0,   0,  42,   0}},
  {"li_reads",              { 56,  82,  75,  56,  82,  75,  56,  82,  75,  56,  82,  75,  56,  75}},
  {"tile_visits",           { 19,  16,  12,  19,  16,  12,  43,  38,  29,  43,  38,  29,  43,  29}},
  {"tile_reads",            {  0,   0,   0,  31,  28,  24,   0,   0,   0,  72,  67,  58,  86,  58}},
  {"tile_build_reads",      {  0,   0,   0, 256, 256, 256,   0,   0,   0, 256, 256, 256, 256, 256}},
  {"tile_words",            {  0,   0,   0,   8,   8,   8,   0,   0,   0,  32,  32,  32,  32,  32}},
  {"visits_culled_zmax",    {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0}},
  {"visits_culled_zrange",  {  0,   0,   0,   0,   0,   0,   0,   0,   0,   2,   2,   2,   2,   2}},
  {"visits_culled_planes",  {  0,   0,   0,   0,   0,   0,   0,   0,   0,   4,   4,   4,   4,   4}},
  {"visits_culled_sat",     {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0}},
  {"umbra_visits_culled",   {  0,   0,   0,   0,   0,   0,   0,   0,   0,   2,   2,   2,   2,   2}},
  {"umbra_visits_accepted", {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   1,   1}},
  {"tiles_inside",          {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0}},
  {"pixels_covered",        {191, 191, 191, 191, 191, 191, 191, 191, 191, 191, 191, 191, 191, 191}},
  {"pixels_inside",         { 56,  56,  56,  56,  56,  56,  56,  56,  56,  56,  56,  56,  56,  56}},
  {"merge_reads",           {278,   0,   0, 278,   0,   0, 278,   0,   0, 278,   0,   0, 278,   0}},
  {"merge_writes",          { 22,   0,   0,  22,   0,   0,  22,   0,   0,  22,   0,   0,  22,   0}},
  {"clear_writes",          {512, 256, 256, 512, 256, 256, 512, 256, 256, 512, 256, 256, 512, 256}},
  {"wedge_bytes", {
    5088, 2544, 2544, 5088, 2544, 2544,
    5088, 2544, 2544, 5088, 2544, 2544, 5088, 2544}},
  {"z_reads_min",           { 88,  88,  88,  88,  88,  88,  88,  88,  88,  71,  71,  71,  71,  71}},
  {"li_writes_min",         { 51,  51,  51,  51,  51,  51,  51,  51,  51,  51,  51,  51,  51,  51}},
  {"z_reads_floor",         { 43,  43,  43,  43,  43,  43,  43,  43,  43,  43,  43,  43,  43,  43}},
  {"li_writes_floor",       { 48,  48,  48,  48,  48,  48,  48,  48,  48,  48,  48,  48,  48,  48}},
  {"li_overflow_pixels",    {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0}},
  {"contributions_max",     {  4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4,   4}},
  {"degenerate_wedges",     {  0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0,   0}},
  {"all_bytes", {
    7272, 4020, 3832, 8420, 5156, 4952,
    7272, 4020, 3832, 8440, 5172, 5004, 8492, 5000}},
};
// clang-format on

TEST(HandWorked, PrismOverAFloor) {
  const functional::Frame frame = functional::make_frame(hand_worked_scene());
  const auto results = count(frame.trace.view(), configurations());
  ASSERT_EQ(results.size(), kConfigs);
  ASSERT_EQ(std::size(kExpected), results[0].counters->counters().size());
  for (std::size_t i = 0; i < kConfigs; ++i) {
    SCOPED_TRACE("configuration " + std::to_string(i));
    EXPECT_EQ(results[i].pixels.mismatched, 0U);
    EXPECT_EQ(results[i].needless_visits, results[i].config.tile == 4 ? 14U : 1U);
    for (std::size_t k = 0; k < std::size(kExpected); ++k) {
      const Counter& counter = *results[i].counters->counters()[k];
      ASSERT_EQ(counter.name(), kExpected[k].counter);
      EXPECT_EQ(counter.value(), kExpected[k].values[i]) << counter.name();
    }
  }
}

}  // namespace
}  // namespace wedgesim::tests

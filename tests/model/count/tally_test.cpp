#include "model/count/tally.h"

#include <gtest/gtest.h>

#include "model/count/pixel_check.h"
#include "tests/model/count/synthetic.h"

namespace wedgesim::model {
namespace {

using test::Facing;
using test::SyntheticTrace;

// 8x8 pixels, one tile. A wedge on all of them and its umbra polygon on the upper half, both from
// depth 0.2 on. Depth 0.5, but `odd` at (3, 2).
SyntheticTrace scene(double odd) {
  SyntheticTrace synthetic(8, 8, 0.5);
  synthetic.set_depth(3, 2, odd);
  const std::uint32_t front = synthetic.add_plane(0, 0, 1, -0.2);
  const auto rectangle = [](double y1) {
    return std::vector<test::Point>{{0, 0, 0.2}, {8, 0, 0.2}, {8, y1, 0.9}, {0, y1, 0.9}};
  };
  synthetic.add_face(rectangle(8), Facing::eye, front);
  const std::uint32_t wedge =
      synthetic.add_wedge(traces::fb::WedgeKind_coverage, {front}, 0.2, 0.9);
  synthetic.add_umbra(rectangle(4), Facing::eye, front, wedge);
  return synthetic;
}

// One configuration on the scene with a pixel at depth 0.1, before everything. The tile tests
// believe in the depths of another scene.
struct Tallied {
  Tallied(double believed, const CountConfig& config)
      : synthetic(scene(0.1)),
        frame(synthetic.trace.view()),
        tiles(ZFrame(scene(believed).trace.view()), config.tile),
        primitive(wedge_primitive(synthetic.trace.view(), ZMethod::pass, 0)),
        run(config, frame, tiles, false),
        image(frame) {
    ConfigRun* const runs[] = {&run};
    tally.emplace(runs, frame, ZMethod::pass, word_one(DatapathKind::exact));
    Footprint footprint;
    footprint.build(primitive, frame, 0, simd_kernel());
    tally->count(primitive, footprint);
    image.add(primitive, footprint, frame, simd_kernel(), word_one(DatapathKind::exact));
  }
  const Counters& counters() { return tally->counters(0); }
  std::vector<std::int64_t> words(bool corrected) {
    return FinishedFrame(frame, image, DatapathKind::exact,
                         corrected ? tally->corrections(0) : std::vector<Correction>{})
        .words();
  }
  /// Pixels whose LI word the block gets wrong.
  std::vector<std::size_t> wrong() {
    const auto right = words(false);
    const auto got = words(true);
    std::vector<std::size_t> pixels;
    for (std::size_t i = 0; i < right.size(); ++i) {
      if (right[i] != got[i]) pixels.push_back(i);
    }
    return pixels;
  }

  SyntheticTrace synthetic;
  ZFrame frame;
  TileDepths tiles;
  Primitive primitive;
  ConfigRun run;
  LightImage image;
  std::optional<TileTally> tally;
};

const CountConfig kUnshared{.mode = Mode::three_pass, .umbra_cull = UmbraCull::none};

TEST(Tally, CountsOneTile) {
  // The face's 64 pixels and the polygon's 32 are read; inside are 63, hit 31.
  Tallied three(0.1, kUnshared);
  EXPECT_EQ(three.counters().z_reads.value(), 96u);
  EXPECT_EQ(three.counters().z_reads_whole_tile.value(), 128u);
  EXPECT_EQ(three.counters().li_writes.value(), 63u + 31u);
  EXPECT_EQ(three.counters().stencil_writes.value(), 31u);
  EXPECT_EQ(three.counters().tile_visits.value(), 2u);
  EXPECT_EQ(three.counters().tile_reads.value(), 2u) << "`both` names two words";
  EXPECT_EQ(three.counters().tiles_inside.value(), 0u);
  EXPECT_EQ(bit_count(three.run.z_touched), 64u);
  EXPECT_EQ(bit_count(three.run.li_touched), 63u);
  EXPECT_TRUE(three.wrong().empty());
  // Shared: the polygon's pixels are among the face's.
  Tallied single(0.1, {.umbra_cull = UmbraCull::none});
  EXPECT_EQ(single.counters().z_reads.value(), 64u);
  EXPECT_EQ(single.counters().li_writes.value(), 63u);
  EXPECT_EQ(single.counters().tile_visits.value(), 1u);
}

TEST(Tally, ATileWronglyTakenForInsideShows) {
  // Told that the nearest depth is 0.5, the block skips the inside tests: it adds the pixel that is
  // not inside.
  Tallied tallied(0.5, kUnshared);
  EXPECT_EQ(tallied.counters().tiles_inside.value(), 1u);
  EXPECT_EQ(tallied.counters().li_writes.value(), 64u + 31u);
  ASSERT_EQ(tallied.tally->corrections(0).size(), 1u);
  const Correction& correction = tallied.tally->corrections(0)[0];
  EXPECT_EQ(correction.position, 8u * 2 + 3);
  // The pixel is before the polygon's begin, so not inner: its coverage would be subtracted.
  EXPECT_EQ(correction.penumbra,
            -to_word(contribution(tallied.primitive.terms, 3.5, 2.5, tallied.frame.z(3, 2)),
                     word_one(DatapathKind::exact)));
  EXPECT_NE(correction.penumbra, 0);
  EXPECT_EQ(correction.umbra, 0);
  EXPECT_EQ(tallied.wrong(), std::vector<std::size_t>{8 * 2 + 3});
}

TEST(Tally, OnlyPlanesTestsLookForTilesInside) {
  Tallied tallied(0.5,
                  {.mode = Mode::three_pass, .cull = Cull::zrange, .umbra_cull = UmbraCull::none});
  EXPECT_EQ(tallied.counters().tiles_inside.value(), 0u) << "zrange does not look for it";
  EXPECT_TRUE(tallied.wrong().empty());
}

TEST(Tally, AWrongAcceptanceShows) {
  CountConfig config = kUnshared;
  config.accept = Accept::zmin;
  Tallied tallied(0.5, config);
  EXPECT_EQ(tallied.counters().umbra_visits_accepted.value(), 1u);
  EXPECT_EQ(tallied.counters().z_reads.value(), 64u);
  EXPECT_EQ(tallied.counters().stencil_writes.value(), 32u);
  ASSERT_EQ(tallied.tally->corrections(0).size(), 2u) << "the face's and the polygon's";
  EXPECT_EQ(tallied.tally->corrections(0)[1].umbra, -1);
}

}  // namespace
}  // namespace wedgesim::model

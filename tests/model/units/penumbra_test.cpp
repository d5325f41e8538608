// Does the datapath take ceil(pixels / lanes) cycles?
#include "model/units/penumbra.h"

#include "tests/model/units/pipeline.h"

namespace wedgesim::model::units::test {
namespace {

struct PenumbraTest : BothTimings {
  // Cycles at work on one tile.
  Cycle taken(int lanes, const BlockWork& block, bool shared = false) {
    const ScopedSimulation simulation;
    Pipeline pipeline;
    const Penumbra unit("penumbra", GetParam(), {lanes, {}}, pipeline.in, pipeline.out);
    PrimitiveWork* const work = wedge_work(0, {walked_tile(0, {block}, shared)});
    pipeline.run(unit, {{Token::Kind::work, 0, work}}, 1);
    return unit.time().busy() - 1;  // the end takes one
  }
};

TEST_P(PenumbraTest, LanesShareThePixels) {
  for (const int lanes : {1, 2, 4, 8, 16}) {
    for (const int pixels : {1, 2, 3, 4, 5, 16, 17, 63, 64}) {
      EXPECT_EQ(taken(lanes, block_work(0, 0, first_pixels(pixels))),
                static_cast<Cycle>((pixels + lanes - 1) / lanes))
          << pixels << " pixels, " << lanes << " lanes";
    }
  }
}

// Faces read the first 10 pixels, the umbra polygon reads 4 of them and accepts 2 others.
TEST_P(PenumbraTest, APixelOfBothPolygonsCountsTwiceUnlessShared) {
  const BlockWork block{0, 0, first_pixels(10), first_pixels(4), 1, std::uint64_t{3} << 20};
  EXPECT_EQ(taken(1, block), 16U);
  EXPECT_EQ(taken(1, block, true), 12U);
}

WEDGESIM_BOTH_TIMINGS(PenumbraTest);

}  // namespace
}  // namespace wedgesim::model::units::test

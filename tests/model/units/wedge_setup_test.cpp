// Does setup take its cycles for planes and edges?
#include "model/units/wedge_setup.h"

#include "tests/model/units/pipeline.h"

namespace wedgesim::model::units::test {
namespace {

struct WedgeSetupTest : BothTimings {
  Cycle taken(int a_plane, int an_edge) {
    const ScopedSimulation simulation;
    Pipeline pipeline;
    const WedgeSetup unit("wedge_setup", GetParam(), {a_plane, an_edge, {}}, pipeline.in,
                          pipeline.out);
    pipeline.run(unit, {{Token::Kind::work, 0, wedge_work(0, {})}}, 1);
    EXPECT_EQ(unit.time().busy(), pipeline.popped.at(0) - 1);  // the end takes one, too
    EXPECT_EQ(statistic(unit, "primitives"), 1U);
    return pipeline.popped.at(0) - 2;  // it came in 1, and was seen a cycle after it left
  }
};

// 4 planes, 8 edges.
TEST_P(WedgeSetupTest, CyclesOfPlanesAndEdgesAddUp) {
  EXPECT_EQ(taken(1, 1), 12U);
  EXPECT_EQ(taken(3, 2), 28U);
  EXPECT_EQ(taken(0, 2), 16U);
  EXPECT_EQ(taken(5, 0), 20U);
  EXPECT_EQ(taken(0, 0), 1U);  // at least one
}

WEDGESIM_BOTH_TIMINGS(WedgeSetupTest);

}  // namespace
}  // namespace wedgesim::model::units::test

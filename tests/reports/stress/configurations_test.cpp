#include "reports/stress/configurations.h"

#include <gtest/gtest.h>

#include "reports/stress/case_name.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/families/random_case.h"
#include "reports/stress/frame.h"

namespace wedgesim::reports::stress {
namespace {

// Frames of both methods. Those by z-fail would do with z-pass, which gives other sums: polygons
// end at the edges of a floor.
TEST(Configurations, AgreeWithTheFramesOwnMethod) {
  for (const char* genes : {"eye_x=1", "z_fail=1 floor_size=-4", "z_fail=1 near=22"}) {
    SCOPED_TRACE(genes);
    const functional::Frame frame = frame_of(case_of(genes_of(genes)));
    for (const auto kind : {model::DatapathKind::exact, model::DatapathKind::fixed}) {
      const model::Datapath datapath(kind);
      auto sums = evaluate(frame.trace.view(), method_of(frame), datapath).sums;
      EXPECT_TRUE(configurations_agree(frame, datapath, sums));
      sums[9] += 1;
      EXPECT_FALSE(configurations_agree(frame, datapath, sums));
    }
  }
}

}  // namespace
}  // namespace wedgesim::reports::stress

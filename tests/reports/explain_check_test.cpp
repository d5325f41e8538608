#include "reports/explain_check.h"

#include <gtest/gtest.h>

#include "tests/traces/sample.h"
#include "traces/depth.h"

namespace wedgesim::reports {
namespace {

struct ExplainCheck : testing::Test {
  traces::Trace trace = traces::sample_trace();
  model::Explanation explanation;

  ExplainCheck() {
    trace.header.expected_z_method = traces::fb::ZMethod_pass;
    trace.expected_li.assign(trace.depth.size(), 0.5);
    trace.li_sensitivity.assign(trace.depth.size(), 0.0F);
    explanation.x = 1;
    explanation.y = 1;
    explanation.word = std::int64_t{1} << 39;
  }
  void be_off_by(double error) {
    explanation.word = static_cast<std::int64_t>((0.5 + error) * 1099511627776.0);
  }
};

TEST_F(ExplainCheck, TheExpectedLightHolds) { EXPECT_TRUE(held(trace.view(), explanation)); }

TEST_F(ExplainCheck, AMillionthIsAllowed) {
  be_off_by(0.9e-6);
  EXPECT_TRUE(held(trace.view(), explanation));
  be_off_by(1.1e-6);
  EXPECT_FALSE(held(trace.view(), explanation));
  be_off_by(-1.1e-6);
  EXPECT_FALSE(held(trace.view(), explanation));
}

TEST_F(ExplainCheck, ItsOwnSensitivityIsAllowed) {
  be_off_by(0.1);
  EXPECT_FALSE(held(trace.view(), explanation));
  trace.li_sensitivity[trace.header.width + 1] = 0.2F;
  EXPECT_TRUE(held(trace.view(), explanation));
}

TEST_F(ExplainCheck, SkyIsComparedUnderTheTracesMethodAlone) {
  be_off_by(1.0);
  std::uint32_t& depth = trace.depth[trace.header.width + 1];
  depth = traces::sky_word(trace.header.depth_format);
  EXPECT_FALSE(held(trace.view(), explanation));
  explanation.method = model::ZMethod::fail;
  EXPECT_TRUE(held(trace.view(), explanation));
  depth = traces::step_depth(trace.header.depth_format, depth, -1);
  EXPECT_FALSE(held(trace.view(), explanation));
}

TEST_F(ExplainCheck, WithoutExpectationNothingIsCompared) {
  be_off_by(1.0);
  trace.expected_li.clear();
  EXPECT_TRUE(held(trace.view(), explanation));
}

}  // namespace
}  // namespace wedgesim::reports

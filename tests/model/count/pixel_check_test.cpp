#include "model/count/pixel_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/model/count/synthetic.h"
#include "traces/depth.h"

namespace wedgesim::model {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 40;

// A frame of 4x2 pixels on which nothing has been drawn: what changes it are the corrections.
struct Frame {
  Frame() : synthetic(4, 2, 0.5), z(synthetic.trace.view()), image(z) {
    synthetic.trace.expected_li.assign(8, 1.0);
    synthetic.trace.li_sensitivity.assign(8, 0.0F);
  }
  FinishedFrame finish(DatapathKind format) const { return {z, image, format, corrections}; }
  FrameSummary summary(DatapathKind format = DatapathKind::exact,
                       ZMethod method = ZMethod::pass) const {
    return finish(format).summarize(synthetic.trace.view(), method);
  }
  void add(int x, int y, std::int64_t penumbra, std::int32_t umbra) {
    corrections.push_back({z.position(x, y), penumbra, umbra});
  }

  test::SyntheticTrace synthetic;
  ZFrame z;
  LightImage image;
  std::vector<Correction> corrections;
};

TEST(PixelCheck, FinishedWordsAreOneAndAllContributions) {
  Frame frame;
  frame.add(2, 1, 0, -1);
  frame.add(1, 0, -kOne / 2, 0);
  frame.add(2, 1, kOne / 4, 0);
  EXPECT_EQ(frame.finish(DatapathKind::exact).words(),
            (std::vector<std::int64_t>{kOne, kOne / 2, kOne, kOne, kOne, kOne, kOne / 4, kOne}));
}

TEST(PixelCheck, ComparesEveryPixel) {
  Frame frame;
  auto& expected = frame.synthetic.trace.expected_li;
  frame.add(1, 0, -kOne / 2, 0);
  expected[1] = 0.5;       // (1, 0): right
  frame.add(2, 1, 0, -1);  // (2, 1): 0, not 0.25, which its sensitivity explains
  expected[6] = 0.25;
  frame.synthetic.trace.li_sensitivity[6] = 0.3F;
  expected[0] = 1.0 + 3e-6;    // (0, 0): beyond the tolerance
  expected[3] = 1.0 - 0.5e-6;  // (3, 0): within
  const FrameSummary summary = frame.summary();
  EXPECT_EQ(summary.pixels.compared, 8u);
  EXPECT_DOUBLE_EQ(summary.pixels.max_error, 0.25);
  EXPECT_EQ(summary.pixels.mismatched, 1u);
  EXPECT_DOUBLE_EQ(summary.pixels.tolerance, 1e-6);
  // Over the 7 pixels that are not sensitive.
  EXPECT_NEAR(summary.pixels.rms_error, std::sqrt((9e-12 + 0.25e-12) / 7), 1e-15);
  ASSERT_EQ(summary.pixels.worst.size(), 3u);
  EXPECT_EQ(summary.pixels.worst[0].x, 2);
  EXPECT_EQ(summary.pixels.worst[0].y, 1);
  EXPECT_DOUBLE_EQ(summary.pixels.worst[0].error, -0.25);
  EXPECT_EQ(summary.pixels.worst[1].x, 0);
  EXPECT_EQ(summary.pixels.worst[2].x, 3);
  EXPECT_EQ(summary.li_writes_floor, 2u);
  EXPECT_EQ(summary.stencil_not_zero, 1u);
  EXPECT_EQ(summary.li_out_of_range, 0u);
  EXPECT_EQ(summary.any_out_of_range, 0u);
}

TEST(PixelCheck, TellsWordsOutOfRange) {
  Frame frame;
  frame.add(0, 0, 0, -17);            // LI 1 - 17 = -16: the least that S5_11 holds
  frame.add(1, 0, 0, -18);            // one less
  frame.add(2, 0, 0, 15);             // 16: one more than the most
  frame.add(3, 0, 128 * kOne, -129);  // LI 0, the stencil alone is out of range
  EXPECT_EQ(frame.summary().li_out_of_range, 2u);
  EXPECT_EQ(frame.summary().any_out_of_range, 3u);
  // 255ths, 16 bits: all but what the last correction's penumbra makes of (3, 0) fits.
  EXPECT_EQ(frame.summary(DatapathKind::paper255).li_out_of_range, 1u);
  EXPECT_DOUBLE_EQ(frame.summary(DatapathKind::paper255).pixels.tolerance, 2.0 / 255.0);
}

TEST(PixelCheck, LeavesOutTheSkyAndTracesWithoutExpectation) {
  Frame frame;
  frame.synthetic.set_depth(2, 0, 1.0);
  EXPECT_EQ(frame.summary(DatapathKind::exact, ZMethod::fail).pixels.compared, 7u);
  EXPECT_EQ(frame.summary(DatapathKind::exact, ZMethod::pass).pixels.compared, 8u);
  frame.synthetic.trace.expected_li.clear();
  EXPECT_EQ(frame.summary().pixels.compared, 0u);
}

}  // namespace
}  // namespace wedgesim::model

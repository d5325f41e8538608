#include "reports/stress/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wedgesim::reports::stress {
namespace {

constexpr int kWidth = 4;
constexpr std::size_t kPixels = 12;

// Dark pixels away from wedges, as the judge sees them.
std::vector<JudgedPixel> dark_frame() {
  std::vector<JudgedPixel> judged;
  for (std::size_t i = 0; i < kPixels; ++i) judged.push_back({i, 0.0, 0.0, false});
  return judged;
}

Errors errors_of(const std::vector<double>& li, const std::vector<JudgedPixel>& judged,
                 Arithmetic arithmetic = Arithmetic::fixed) {
  Errors errors;
  compare(li, judged, kWidth, arithmetic, errors);
  return errors;
}

TEST(Errors, NoneIsFoundInWhatIsRight) {
  Errors errors;
  const std::vector<double> li(kPixels, 0.0);
  EXPECT_TRUE(compare(li, dark_frame(), kWidth, Arithmetic::fixed, errors).empty());
  EXPECT_EQ(errors.max_error, 0.0);
  EXPECT_EQ(errors.off + errors.beyond + errors.specks + errors.leaks, 0U);
  EXPECT_TRUE(holds(errors, Arithmetic::fixed));
}

// Alone, at the frame's corner too; not beside another, and not where the sensitivity allows it.
TEST(Errors, ASpeckIsAloneAndFarOff) {
  std::vector<double> li(kPixels, 0.0);
  std::vector<JudgedPixel> judged = dark_frame();
  for (JudgedPixel& p : judged) p.in_wedge = true;
  li[0] = 1.0;
  li[7] = -0.75;
  EXPECT_EQ(errors_of(li, judged).specks, 2U);
  li[7] = 0.5;
  EXPECT_EQ(errors_of(li, judged).specks, 1U);
  li[5] = 1.0;  // diagonally beside the first
  EXPECT_EQ(errors_of(li, judged).specks, 0U);
  li[5] = 0.0;
  judged[0].sensitivity = 0.6;
  EXPECT_EQ(errors_of(li, judged).specks, 0U);
}

// However little a sum away from penumbrae is off, it is a leak; in a wedge, where LI is no whole
// number, or where a step of depth changes it, it is not.
TEST(Errors, ALeakIsAnyErrorAwayFromPenumbrae) {
  std::vector<double> li(kPixels, 0.0);
  std::vector<JudgedPixel> judged = dark_frame();
  li[6] = 1e-9;
  li[9] = 1e-9;
  const Errors errors = errors_of(li, judged, Arithmetic::double_precision);
  EXPECT_EQ(errors.leaks, 2U);
  EXPECT_EQ(errors.first_leak, 6U);
  EXPECT_EQ(errors.beyond, 0U);
  EXPECT_FALSE(holds(errors, Arithmetic::double_precision));
  judged[6].in_wedge = true;
  judged[9].sensitivity = 1e-12;
  EXPECT_EQ(errors_of(li, judged).leaks, 0U);
  judged[9].sensitivity = 0.0;
  judged[9].li = 0.5;
  EXPECT_EQ(errors_of(li, judged).leaks, 0U);
}

TEST(Errors, RmsIsThatOfQuietPixelsAndOfThoseInWedges) {
  std::vector<double> li(kPixels, 0.0);
  std::vector<JudgedPixel> judged = dark_frame();
  judged[1].in_wedge = judged[2].in_wedge = true;
  judged[2].sensitivity = 0.1;  // not quiet
  li[1] = 0.006;
  li[2] = 0.05;
  const Errors errors = errors_of(li, judged);
  EXPECT_DOUBLE_EQ(errors.rms, 0.006 / std::sqrt(11.0));
  EXPECT_DOUBLE_EQ(errors.rms_penumbra, 0.006);
  EXPECT_EQ(errors.beyond, 0U);
  EXPECT_FALSE(holds(errors, Arithmetic::fixed));
  EXPECT_EQ(errors.off, 2U);
}

// What is no number is off without end, not right.
TEST(Errors, NoNumberIsAnError) {
  std::vector<double> li(kPixels, 0.0);
  li[3] = std::numeric_limits<double>::quiet_NaN();
  const Errors errors = errors_of(li, dark_frame());
  EXPECT_EQ(errors.max_error, std::numeric_limits<double>::infinity());
  EXPECT_EQ(errors.max_excess, std::numeric_limits<double>::infinity());
  EXPECT_EQ(errors.beyond, 1U);
  EXPECT_EQ(errors.specks, 1U);
  EXPECT_FALSE(holds(errors, Arithmetic::fixed));
}

TEST(Errors, AJumpBreaksTheBar) {
  Errors errors = errors_of(std::vector<double>(kPixels, 0.0), dark_frame());
  errors.jump = Jump{largest_jump_of(Arithmetic::fixed), 0, 0};
  EXPECT_TRUE(holds(errors, Arithmetic::fixed));
  errors.jump->excess *= 1.01;
  EXPECT_FALSE(holds(errors, Arithmetic::fixed));
}

}  // namespace
}  // namespace wedgesim::reports::stress

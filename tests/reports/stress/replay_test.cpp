#include "reports/stress/replay.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "reports/stress/stress_picture.h"
#include "tests/reports/stress/sample.h"

namespace wedgesim::reports::stress {
namespace {

TEST(CaseName, IsReadAndWrittenAlike) {
  for (const char* text : {"small-light,0,1e-8", "offset,12,1e4", "touching-light,2,-0.5",
                           "contact,1,0", "distance-ratio,5,1234.5", "short-edge,0,0.001"}) {
    EXPECT_EQ(to_text(parse_case("--replay", text)), text);
  }
  EXPECT_EQ(difficulty_text(1e-3), "0.001");
  EXPECT_EQ(difficulty_text(123456.0), "1.23456e5");
  EXPECT_EQ(difficulty_text(-1e-10), "-1e-10");
}

TEST(Replay, FindsTheWorstPixels) {
  Measurement m = tests::sample_measurement();
  std::vector<double>& li = m.errors[0].li;
  li[3] += 0.5;
  li[7] -= 0.75;
  li[8] += 0.9;
  li[9] = std::nan("");
  m.sensitivities[8] = 0.8;
  EXPECT_EQ(worst_pixels(m, Arithmetic::fixed, 3), (std::vector<std::size_t>{9, 7, 3}));
  EXPECT_NEAR(excess_at(m, Arithmetic::fixed, 8), 0.1, 1e-12);
  EXPECT_TRUE(worst_pixels(m, Arithmetic::renderer, 3).empty());
  m.judge[9] = std::nan("");  // sky
  EXPECT_EQ(worst_pixels(m, Arithmetic::fixed, 1), (std::vector<std::size_t>{7}));
}

TEST(Replay, HoldsUnlessAPixelIsWrongAndUnflagged) {
  const CaseName name{&families().front(), 0, 1.0};
  Measurement m = tests::sample_measurement();
  EXPECT_TRUE(replay_holds(name, m));
  EXPECT_FALSE(first_beyond(m).has_value());
  m.errors[static_cast<std::size_t>(Arithmetic::float32)].beyond = 1;
  EXPECT_EQ(first_beyond(m), Arithmetic::float32);
  EXPECT_TRUE(replay_holds(name, m));
  m.errors[static_cast<std::size_t>(Arithmetic::float32)].unforeseen = 1;  // though it is flagged
  EXPECT_FALSE(replay_holds(name, m));
  m.refused = "why";
  EXPECT_EQ(replay_holds(name, m), name.family->may_refuse);
  EXPECT_NE(replay_text(name, m).find("refused: why"), std::string::npos);
}

TEST(Replay, SaysWhatIsFlagged) {
  const CaseName name{&families().front(), 0, 1.0};
  const auto results = tests::sample_results();
  Measurement m = results[1].levels[2][0];
  m.flagged[static_cast<std::size_t>(Arithmetic::fixed)] = {{10, "too wide", true}};
  const std::string text = replay_text(name, m);
  EXPECT_NE(text.find("double: wedge 7 flagged: too <thin>"), std::string::npos) << text;
  EXPECT_NE(text.find("fixed: umbra polygon 2 foreseen: too wide"), std::string::npos) << text;
  EXPECT_NE(text.find("0.499000000*"), std::string::npos) << text;
}

std::array<float, 3> colour_at(const Image& image, int x, int y) {
  const float* c = image.pixel(x, y);
  return {c[0], c[1], c[2]};
}

TEST(StressPicture, ShowsLightAndMarksWhatIsBeyondTheBar) {
  Measurement m = tests::sample_measurement();
  std::vector<double>& li = m.errors[1].li;
  li[0] += 0.1;   // beyond, too light
  li[1] -= 0.1;   // beyond, too dark
  li[2] += 1e-3;  // within
  li[3] = std::nan("");
  m.judge[4] = std::nan("");
  const Image image = picture_of(m, std::array{Arithmetic::float32}, 10);
  const int panel = 4 * 10 + 4;
  ASSERT_EQ(image.width, 3 * panel - 4);
  ASSERT_EQ(image.height, 30);
  using Colour = std::array<float, 3>;
  EXPECT_EQ(colour_at(image, 5, 5), (Colour{0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(colour_at(image, panel + 5, 5), (Colour{0.6F, 0.6F, 0.6F}));
  EXPECT_EQ(colour_at(image, 2 * panel + 5, 5), (Colour{1.0F, 0.0F, 0.0F}));
  EXPECT_EQ(colour_at(image, 2 * panel, 5), (Colour{0.0F, 0.0F, 0.0F}));  // its box
  EXPECT_EQ(colour_at(image, 2 * panel + 15, 5), (Colour{0.0F, 0.0F, 1.0F}));
  const Colour pale = colour_at(image, 2 * panel + 20, 5);
  EXPECT_EQ(pale[0], 1.0F);
  EXPECT_GT(pale[1], 0.5F);
  EXPECT_LT(pale[1], 1.0F);
  EXPECT_EQ(colour_at(image, 2 * panel + 35, 5), (Colour{1.0F, 0.0F, 1.0F}));
  EXPECT_NE(colour_at(image, 5, 15), colour_at(image, 15, 15));  // sky
}

TEST(StressPicture, LongFramesAreStacked) {
  Measurement m = tests::sample_measurement();
  m.width = 12;
  m.height = 1;
  EXPECT_EQ(picture_of(m, kArithmetics, 1).height, 12 * (1 + 4) - 4);
  std::swap(m.width, m.height);
  EXPECT_EQ(picture_of(m, kArithmetics, 1).width, 12 * (1 + 4) - 4);
}

}  // namespace
}  // namespace wedgesim::reports::stress

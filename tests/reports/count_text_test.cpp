#include "reports/count_text.h"

#include <gtest/gtest.h>

#include <regex>

#include "tests/reports/results.h"

namespace wedgesim::reports {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CountText, AFailureIsNamed) {
  std::vector<model::CountResult> results;
  results.push_back(make_result({}, 5, 3));
  EXPECT_TRUE(held(results));
  EXPECT_FALSE(contains(pixels_text(results), "FAILED"));
  results.push_back(make_result({model::Mode::three_pass, 64}, 5, 3));
  results.back().pixels.mismatched = 2;
  results.back().pixels.worst = {{4, 1, 0.25, 0.75, 0.5, 0.125}};
  EXPECT_FALSE(held(results));
  const std::string text = count_text({"x", 1, 3, 2, 7}, results);
  EXPECT_TRUE(contains(text, "FAILED: three-pass, tile 64, ")) << text;
  EXPECT_TRUE(contains(text, "the 1 worst pixels:")) << text;
}

TEST(CountText, TheWorstOfAllConfigurationsIsTold) {
  std::vector<model::CountResult> results;
  for (const auto& pixels : {model::PixelCheck{6, 0.5, 0.0625, 0.5, 3, 0.125, {}},
                             model::PixelCheck{6, 0.25, 0.03125, 0.5, 2, 0.125, {}}}) {
    results.push_back(make_result({}, 5, 3));
    results.back().pixels = pixels;
    results.back().wrong_contributions = 4;
  }
  const std::string text = pixels_text(results);
  EXPECT_EQ(text.find("pixels: 6 compared in 2 configurations; max error 0.5, RMS 0.062, 5 "
                      "mismatched (tolerance 0.125 plus sensitivity)\n"
                      "tile tests lost 8 contributions\n"),
            0U)
      << text;
}

TEST(CountText, CountersStandWithTheirOwnConfiguration) {
  std::vector<model::CountResult> results;
  results.push_back(make_result({}, 1234, 60));
  results.push_back(make_result({model::Mode::three_pass, 64}, 4321, 70));
  results.back().z = model::ZMethod::fail;
  const std::string text = count_text({"x", 1, 3, 2, 7}, results);
  for (const char* row :
       {"\nmode +single-pass +three-pass +unit\n", "\ntile +8 +64\n", "\nz +pass +fail\n",
        "\nz_reads +1,234 +4,321 +accesses +Depth", "\naccesses +1,294 +4,391 +accesses",
        "\naccesses / floor +8.63 +29.27"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex(row))) << row << " is not in\n" << text;
  }
}

TEST(CountText, LostContributionsFailToo) {
  std::vector<model::CountResult> results;
  results.push_back(make_result({}, 5, 3));
  results.back().wrong_contributions = 1;
  EXPECT_FALSE(held(results));
  EXPECT_TRUE(contains(pixels_text(results), "1 contributions lost"));
}

TEST(CountText, SaysWhenNothingCouldBeCompared) {
  std::vector<model::CountResult> results;
  results.push_back(make_result({}, 5, 3));
  results.back().pixels.compared = 0;
  EXPECT_TRUE(contains(pixels_text(results), "none compared"));
}

}  // namespace
}  // namespace wedgesim::reports

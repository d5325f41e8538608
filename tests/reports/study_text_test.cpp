#include "reports/study_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "reports/count_text.h"
#include "reports/savings.h"
#include "reports/study_files.h"
#include "tests/reports/results.h"

namespace wedgesim::reports {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(StudyText, HasBothModesByTileAndWhatIsSaved) {
  const std::string text = study_text(make_study_results());
  EXPECT_TRUE(contains(text, "somewhere: 3x2 pixels, 7 wedges, z-pass\n")) << text;
  // Ratios to the floor of 150: (1000 + 500) / 150 and (800 + 450) / 150.
  EXPECT_TRUE(contains(text,
                       "      4       1.0        0.5    1.5       0.8        0.5    1.2    20.0  "
                       "  10.0   16.7   10.00    8.33    2.50    2.00\n"))
      << text;
  EXPECT_TRUE(contains(text, "three-pass 4, 4, 4, 8; single-pass 4, 4, 8, 8")) << text;
  EXPECT_TRUE(contains(text, "pixels: 6 compared in 4 configurations;")) << text;
}

TEST(StudyText, AFailedSceneIsOneLine) {
  StudyResults results;
  results.scenes.emplace_back();
  results.scenes.back().scene = "bunny";
  results.scenes.back().failure = "no mesh";
  EXPECT_EQ(study_text(results), "bunny: left out: no mesh\n");
}

TEST(Savings, SpreadsOverScenesAndTiles) {
  const std::string text = savings_text(make_study_results());
  EXPECT_TRUE(contains(text, "neither accepts    20.0    35.0  50.0     0.0     5.0  10.0\n"))
      << text;
  EXPECT_FALSE(contains(text, "both accept zmin")) << "not in the study";
}

TEST(Savings, NothingToSayWithoutBothModes) {
  StudyResults results = make_study_results();
  results.scenes.front().results.resize(1);
  EXPECT_EQ(savings_text(results), "");
}

TEST(StudyFiles, CsvHasALineAResult) {
  const std::string text = study_csv(make_study_results());
  EXPECT_EQ(text.find("trace,checksum,mode,tile,cull,umbra_cull,accept,share,z,tile_build,z_reads"),
            0U);
  EXPECT_TRUE(contains(
      text, "\nsomewhere,0000000000000abc,single-pass,4,both,zmax,none,eye,pass,eager,800,"))
      << text;
}

TEST(StudyFiles, CsvSaysWhatWasWrong) {
  StudyResults results = make_study_results();
  results.scenes.front().results.resize(1);
  model::CountResult& result = results.scenes.front().results.front();
  result.pixels = {6, 0.5, 0.25, 0.75, 3, 0.125, {}};
  result.wrong_contributions = 7;
  const std::string text = study_csv(results);
  EXPECT_TRUE(contains(text,
                       ",compared,max_error,rms_error,mismatched,tolerance,"
                       "wrong_contributions\n"))
      << text;
  EXPECT_TRUE(text.ends_with(",6,0.5,0.25,3,0.125,7\n")) << text;
}

TEST(StudyFiles, CsvQuotesNames) {
  StudyResults results = make_study_results();
  results.scenes.front().trace.name = "a \"b\", c";
  EXPECT_TRUE(contains(study_csv(results), "\n\"a \"\"b\"\", c\",0000000000000abc,"));
}

TEST(StudyFiles, CsvHasAValueForEveryName) {
  const std::string text = study_csv(make_study_results());
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto commas = std::ranges::count(line, ',');
  while (std::getline(lines, line)) EXPECT_EQ(std::ranges::count(line, ','), commas) << line;
}

TEST(StudyFiles, JsonHasTimeUnderTimingAlone) {
  StudyResults results = make_study_results();
  results.scenes.front().seconds = 1.5;
  results.scenes.emplace_back();
  results.scenes.back().scene = "bunny";
  results.scenes.back().failure = "no mesh";
  const Json json = study_json(results);
  EXPECT_EQ(json["schema"], "wedgesim.study/1");
  EXPECT_EQ(json["study"], "sample");
  EXPECT_EQ(json["scenes"][0]["timing"]["seconds"], 1.5);
  EXPECT_EQ(json["scenes"][0]["configs"].size(), 4U);
  EXPECT_EQ(json["scenes"][1].dump(), R"({"scene":"bunny","failure":"no mesh"})");
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

#include "reports/runner/summary.h"

#include <gtest/gtest.h>

#include <sstream>

#include "reports/runner/counted.h"
#include "reports/runner/modes_text.h"
#include "reports/runner/savings.h"
#include "tests/reports/runner/results_sample.h"

namespace wedgesim::reports {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ModesText, HasBothModesByTileAndWhatIsSaved) {
  const std::string text = modes_text(sample_results()).text();
  EXPECT_TRUE(contains(text, "somewhere: 3x2 pixels, 7 wedges, z-pass\n")) << text;
  // Ratios to the floor of 150: (1000 + 500) / 150 and (800 + 450) / 150.
  EXPECT_TRUE(contains(text,
                       "      4       1.0        0.5    1.5       0.8        0.5    1.2    20.0  "
                       "  10.0   16.7   10.00    8.33    2.50    2.00\n"))
      << text;
  EXPECT_TRUE(contains(text, "three-pass 4, 4, 4, 8; single-pass 4, 4, 8, 8")) << text;
  EXPECT_TRUE(contains(text, "pixels: 6 compared in 4 configurations;")) << text;
}

TEST(CountedPoints, TheBestTileDependsOnWhatAVisitCosts) {
  // single-pass: tile 4 costs 1250 + 300 a visit, tile 8 costs 1500 + 80: equal at 1.14 a visit.
  const Results results = sample_results();
  const CountedPoints points(results);
  const model::CountConfig config;
  EXPECT_EQ(points.best_tile("somewhere", config, 1), 4U);
  EXPECT_EQ(points.best_tile("somewhere", config, 2), 8U);
  model::CountConfig unknown;
  unknown.cull = model::Cull::none;
  EXPECT_EQ(points.best_tile("somewhere", unknown, 0), 0U);
  EXPECT_EQ(points.find("elsewhere", config), nullptr);
}

TEST(Savings, SpreadsOverFramesAndTiles) {
  const std::string text = savings_text(sample_results()).text();
  EXPECT_TRUE(contains(text, "neither accepts    20.0    35.0  50.0     0.0     5.0  10.0\n"))
      << text;
  EXPECT_FALSE(contains(text, "both accept zmin")) << "not in the study";
  Results one_mode = sample_results();
  one_mode.points.resize(1);
  EXPECT_EQ(savings_text(one_mode).text(), "");
}

TEST(Summary, ShowsMedianAndPercentilesOverFrames) {
  Results results = sample_results();
  results.points.resize(1);
  for (int i = 1; i <= 10; ++i) {  // z_reads 1000, 1100, ... 2000: one a frame
    FrameRow frame = results.frames.front();
    frame.label += std::to_string(i);
    PointRow point = results.points.front();
    point.frame = frame.label;
    point.metrics["z_reads"] = std::int64_t{1000 + 100 * i};
    results.frames.push_back(frame);
    results.points.push_back(point);
  }
  const std::string text = summary(results).text();
  EXPECT_TRUE(contains(text, "three-pass  4            1,050   1,500  1,950\n")) << text;
  EXPECT_TRUE(contains(summary(results).markdown(), "| three-pass | 4 | 1,050 | 1,500 | 1,950 |"));
}

TEST(Summary, FramesAreToldApartByWhatTheStudySays) {
  Results results = sample_results();
  FrameRow other = results.frames.front();
  other.label = other.scene = "elsewhere";
  results.frames.push_back(other);
  PointRow point = results.points.front();
  point.frame = "elsewhere";
  point.metrics["z_reads"] = std::int64_t{7};
  results.points.push_back(point);
  results.study.by = {"scene"};
  const std::string text = summary(results).text();
  EXPECT_TRUE(contains(text, "somewhere  three-pass   4             1,000\n")) << text;
  EXPECT_TRUE(contains(text, "elsewhere  three-pass   4                 7\n")) << text;
}

TEST(Summary, SaysWhichPointsFailed) {
  Results results = sample_results();
  EXPECT_TRUE(held(results));
  results.points[1].state = PointState::crashed;
  results.points[1].message = "the worker ended by signal 11";
  EXPECT_FALSE(held(results));
  const std::string text = summary(results).text();
  EXPECT_TRUE(contains(text, "1 of 4 points could not be measured")) << text;
  EXPECT_TRUE(contains(text,
                       "crashed: somewhere count block.mode=single-pass block.tile=4: the "
                       "worker ended by signal 11"))
      << text;
}

TEST(Summary, AWrongPixelFailsUnlessErrorsAreTheResult) {
  Results results = sample_results();
  results.points[1].metrics["mismatched"] = std::int64_t{2};
  EXPECT_FALSE(held(results));
  EXPECT_TRUE(contains(summary(results).text(), "FAILED: somewhere: single-pass 4 both"));
  results.study.check_pixels = false;
  EXPECT_TRUE(held(results));
  EXPECT_FALSE(contains(summary(results).text(), "FAILED"));
}

TEST(Csv, HasAValueForEveryName) {
  Results results = sample_results();
  results.frames.front().scene = "a \"b\", c";
  results.points[2].message = "x, y";
  const std::string text = results_csv(results);
  EXPECT_EQ(text.find("label,scene,checksum,height,width,measure,block.accept,block.cull,"), 0U);
  EXPECT_TRUE(contains(text,
                       "\nsomewhere,\"a \"\"b\"\", c\",0000000000000abc,2,3,count,none,both,"
                       "single-pass,eye,4,zmax,done,,2000000,6,"))
      << text;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const auto commas = std::ranges::count(line, ',');
  while (std::getline(lines, line)) {
    EXPECT_EQ(std::ranges::count(line, ',') - (contains(line, "\"x, y\"") ? 2 : 1), commas) << line;
  }
}

TEST(Json, HasTimeUnderTimingAlone) {
  Results results = sample_results();
  Json first = results_json(results);
  EXPECT_EQ(first["schema"], "wedgesim.study/1");
  EXPECT_EQ(first["study"], "sample");
  EXPECT_EQ(first["points"][0]["timing"]["seconds"], 0.25);
  EXPECT_EQ(first["frames"][0]["trace"]["checksum"], "0000000000000abc");
  for (PointRow& point : results.points) point.seconds = 1.5;
  results.frames.front().seconds = 3.0;
  Json second = results_json(results);
  EXPECT_NE(first, second);
  for (Json* json : {&first, &second}) {
    for (const char* list : {"frames", "points"}) {
      for (Json& entry : (*json)[list]) entry.erase("timing");
    }
  }
  EXPECT_EQ(first, second);
}

}  // namespace
}  // namespace wedgesim::reports

// Do charts draw the points that they say, and leave out what a study does not have?
#include "reports/page/chart.h"

#include <gtest/gtest.h>

#include "reports/page/chart_spec.h"
#include "reports/page/names.h"
#include "tests/reports/page/sample.h"

namespace wedgesim::reports::page {
namespace {

std::vector<std::string> ids_of(const std::vector<Chart>& charts) {
  std::vector<std::string> ids;
  for (const Chart& chart : charts) ids.push_back(chart.id);
  return ids;
}

bool has(const std::vector<Chart>& charts, const std::string& id) {
  return std::ranges::find(charts, id, &Chart::id) != charts.end();
}

TEST(Charts, OfACountedStudy) {
  const Results results = tests::counted_results();
  const Columns columns(results);
  const std::vector<std::string> expected{"tile-z_reads",   "tile-li_writes",  "tile-accesses",
                                          "tile-all_bytes", "tile-over_floor", "cull-efficiency",
                                          "own-6"};
  EXPECT_EQ(ids_of(make_charts(columns)), expected);
}

TEST(Charts, OfAStudyInTime) {
  const Results results = tests::timed_results();
  const Columns columns(results);
  const std::vector<Chart> charts = make_charts(columns);
  for (const char* id :
       {"tile-frames_per_second", "hits-z_read.cache_bytes", "traffic-memory.dram.preset",
        "scaling-pixels", "unit-states", "bottleneck-memory.dram.preset"}) {
    EXPECT_TRUE(has(charts, id)) << id;
  }
  EXPECT_FALSE(has(charts, "tile-z_reads"));
  EXPECT_FALSE(has(charts, "cull-efficiency"));
}

TEST(Charts, OfAStudyOfWidths) {
  const Results results = tests::precision_results();
  const Columns columns(results);
  const std::vector<Chart> charts = make_charts(columns);
  EXPECT_TRUE(has(charts, "max_error-formats.plane"));
  EXPECT_TRUE(has(charts, "error-bits"));
  EXPECT_FALSE(has(charts, "unit-states"));
}

TEST(Charts, HoldOtherSettingsAtUsualValues) {
  const Results results = tests::counted_results();
  const Columns columns(results);
  const std::vector<Chart> charts = make_charts(columns);
  const Chart& reads = charts.front();
  ASSERT_EQ(reads.held.size(), 1U);
  EXPECT_EQ(reads.held.front().first->key, "block.cull");
  EXPECT_EQ(value_text(reads.held.front().second), "both");
  const std::vector<Line> lines = lines_of(columns, reads);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].series, "single-pass");
  ASSERT_EQ(lines[0].at.size(), 8U);
  EXPECT_EQ(lines[0].at[0].second.count, 6U);
  EXPECT_DOUBLE_EQ(lines[0].at[0].second.median, 11250.0);  // 1000 (10 to 15) 18 / 20
  EXPECT_EQ(lines[0].at[7].second.count, 5U);               // a point crashed
}

TEST(Charts, SayWhereTheLowestAndTheHighestAre) {
  const Results results = tests::counted_results();
  const Columns columns(results);
  const std::vector<Chart> charts = make_charts(columns);
  EXPECT_NE(charts.front().caption.find("Lowest: single-pass at tile 2, 11,250 words."),
            std::string::npos)
      << charts.front().caption;
  EXPECT_NE(charts.front().caption.find("three-pass 15.1-fold"), std::string::npos)
      << charts.front().caption;
  EXPECT_NE(charts[5].caption.find("80 % of a perfect cull"), std::string::npos)
      << charts[5].caption;
}

TEST(Charts, StateTheFittedSlope) {
  const Results results = tests::timed_results();
  const Columns columns(results);
  const std::vector<Chart> charts = make_charts(columns);
  const auto scaling = std::ranges::find(charts, "scaling-pixels", &Chart::id);
  EXPECT_NE(scaling->caption.find("single-pass 1.00 and three-pass 1.00"), std::string::npos)
      << scaling->caption;
}

// A chart over edges draws frames of one size, one over sizes those of one scene.
TEST(Charts, DoNotMixFramesThatDifferInMoreThanTheirX) {
  Results results = tests::timed_results();
  EXPECT_FALSE(has(make_charts(Columns(results)), "scaling-wedges"));
  for (FrameRow& frame : results.frames) {
    frame.parameters["width"] = std::int64_t{640};
    frame.parameters["height"] = std::int64_t{480};
  }
  const Columns of_one_size(results);
  EXPECT_TRUE(has(make_charts(of_one_size), "scaling-wedges"));
  EXPECT_FALSE(has(make_charts(of_one_size), "scaling-pixels"));

  Results two_scenes = tests::timed_results();
  two_scenes.frames[0].scene = "bunny";
  const Columns columns(two_scenes);
  const auto chart = scaling_chart(columns, "pixels");
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->held.back().first->key, "scene");
  EXPECT_EQ(value_text(chart->held.back().second), "fractal");
}

TEST(Charts, WithoutPointsThereAreNone) {
  Results results = tests::counted_results();
  for (PointRow& point : results.points) point.state = PointState::failed;
  EXPECT_TRUE(make_charts(Columns(results)).empty());
  results.points.clear();
  EXPECT_TRUE(make_charts(Columns(results)).empty());
}

TEST(Chart, SeriesDifferInColourOrShape) {
  std::vector<std::string> series;
  for (int i = 0; i < 64; ++i) series.push_back(std::to_string(i));
  const Json colours = colour_channel(series)["scale"]["range"];
  const Json shapes = shape_channel(series)["scale"]["range"];
  std::set<std::string> pairs;
  for (std::size_t i = 0; i < series.size(); ++i) {
    pairs.insert(colours[i].get<std::string>() + shapes[i].get<std::string>());
  }
  EXPECT_EQ(pairs.size(), series.size());
}

}  // namespace
}  // namespace wedgesim::reports::page

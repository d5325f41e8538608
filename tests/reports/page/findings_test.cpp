// Do findings say what the data say, with the data's numbers?
#include "reports/page/findings.h"

#include <gtest/gtest.h>

#include "tests/reports/page/sample.h"

namespace wedgesim::reports::page {
namespace {

bool says(const std::vector<std::string>& findings, const std::string& words) {
  return std::ranges::any_of(findings, [&words](const std::string& finding) {
    return finding.find(words) != std::string::npos;
  });
}

TEST(Findings, OfACountedStudy) {
  const Results results = tests::counted_results();
  const std::vector<std::string> findings = find_findings(Columns(results));
  ASSERT_EQ(findings.size(), 3U);
  const std::string all = findings[0] + '\n' + findings[1] + '\n' + findings[2];
  EXPECT_TRUE(says(findings, "z reads 10.0 % less")) << all;
  EXPECT_TRUE(says(findings, "143 pairs")) << all;  // of 144: one point crashed
  EXPECT_TRUE(says(findings, "At tile 8, culling by both leaves 25.0 % of the z reads")) << all;
  EXPECT_TRUE(says(findings, "skips 80.0 % of the visits that a perfect cull would")) << all;
  EXPECT_TRUE(says(findings, "tile 8 is best in 36 of 36")) << all;
}

TEST(Findings, FollowTheData) {
  Results results = tests::counted_results();
  for (PointRow& point : results.points) {
    Value& reads = point.metrics["z_reads"];
    const bool single = std::get<std::string>(point.configuration["block.mode"]) == "single-pass";
    if (single && point.state == PointState::done) reads = 2 * std::get<std::int64_t>(reads);
  }
  EXPECT_TRUE(says(find_findings(Columns(results)), "z reads 80.0 % more"));
}

TEST(Findings, OfAStudyInTime) {
  const Results results = tests::timed_results();
  const std::vector<std::string> findings = find_findings(Columns(results), 9);
  EXPECT_TRUE(says(findings,
                   "Cycles grow with the pixels of the frame, from 76,800 to 1,228,800, to the "
                   "power 1.00 in single-pass"));
  EXPECT_TRUE(says(findings, "z_read in 72 of 144 points"));
  EXPECT_TRUE(says(findings, "cycles 16.7 % less"));
}

TEST(Findings, OfWidths) {
  const Results results = tests::precision_results();
  EXPECT_TRUE(says(find_findings(Columns(results)),
                   "lane: 14 are enough, with 12 pixels go wrong, up to 600 in a frame"));
}

TEST(Findings, NoneWithoutPoints) {
  Results results = tests::counted_results();
  results.points.clear();
  EXPECT_TRUE(find_findings(Columns(results)).empty());
}

}  // namespace
}  // namespace wedgesim::reports::page

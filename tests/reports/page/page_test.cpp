// Is the page one file that says what was studied? The browser test looks at the rest.
#include "reports/page/page.h"

#include <gtest/gtest.h>

#include "tests/reports/page/sample.h"

namespace wedgesim::reports::page {
namespace {

TEST(Page, SaysWhatWasStudied) {
  Results results = tests::counted_results();
  results.points_planned = 300;
  const std::string html = page_html({results, {}, {}, {}, {}});
  for (const char* words : {"<h1>Tiles and culling, made up</h1>", "<strong>3</strong> scenes",
                            "<strong>6</strong> frames", "<strong>288</strong> points measured",
                            "<strong>1</strong> point failed", "ended by signal 11",
                            "Unfinished: 288 of 300 points."}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
  }
}

TEST(Page, NeedsNoOtherFile) {
  const Results results = tests::counted_results();
  const std::string html = page_html({results, {}, {}, {}, {}});
  EXPECT_EQ(html.find("<script src"), std::string::npos);
  EXPECT_EQ(html.find("<link rel=\"stylesheet\""), std::string::npos);
  EXPECT_NE(html.find("Copyright"), std::string::npos);  // licences of what is inside
}

TEST(Page, TheSameTwice) {
  const Results results = tests::timed_results();
  EXPECT_EQ(page_html({results, {}, {}, {}, {}}), page_html({results, {}, {}, {}, {}}));
}

TEST(Page, LeavesOutWhatIsNotThere) {
  Results results;
  results.study.name = "nothing";
  const std::string html = page_html({results, {}, {}, {}, {}});
  EXPECT_NE(html.find("<h1>nothing</h1>"), std::string::npos);
  for (const char* id : {"id=\"charts\"", "id=\"maps\"", "id=\"downloads\"", "<h3>Findings"}) {
    EXPECT_EQ(html.find(id), std::string::npos) << id;
  }
}

TEST(Page, ShowsTablesOfOthers) {
  const Results results = tests::counted_results();
  const Section section{
      "claims", "Claims <1>", "Held against us", {"Claim", "Verdict"}, {{"5 % & more", "depends"}}};
  const std::string html = page_html({results, {}, {}, {section}, {{"results.csv", "all"}}});
  EXPECT_NE(html.find("Claims &lt;1&gt;</h2>"), std::string::npos);
  EXPECT_NE(html.find("<td>5 % &amp; more</td><td>depends</td>"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"results.csv\" download>"), std::string::npos);
}

}  // namespace
}  // namespace wedgesim::reports::page

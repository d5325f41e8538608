// Does the page say what was measured? The browser test looks at the rest.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "reports/page/html.h"
#include "reports/stress/stress_charts.h"
#include "reports/stress/stress_page.h"
#include "reports/stress/stress_words.h"
#include "tests/base/temporary_folder.h"
#include "tests/reports/stress/sample.h"

namespace wedgesim::reports::stress {
namespace {

TEST(StressPage, SaysHowFarEachFamilyHolds) {
  const auto results = tests::sample_results();
  const std::string html =
      stress_page({{}, 2}, results, {{results[1].family, Arithmetic::float32, "bytes", 8, 6}});
  for (const char* words :
       {"<strong>2</strong> families", "<strong>1</strong> as they must be",
        "<strong>16</strong> cases", "<strong>2</strong> refused with a reason",
        "<td class=\"number short\">0.001</td>", "<td class=\"short\">not held</td>",
        "a &lt;b&gt;number&lt;/b&gt; &amp; more (rad)", "&lt;i&gt;no room&lt;/i&gt;",
        "float32 first breaks at 0.001: 1 pixel beyond the bar, the worst 0.25 beyond its "
        "sensitivity.",
        "wedgesim stress --replay brittle,1,0.001", "data:image/png;base64,Ynl0ZXM="}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
  }
  for (const char* words : {"<script src", "<i>no room", "<script>window.broken", "{{"}) {
    EXPECT_EQ(html.find(words), std::string::npos) << words;
  }
}

TEST(StressPage, HasAChartOfEachKind) {
  const auto results = tests::sample_results();
  const page::RowChart excess = excess_chart(results[1]);
  EXPECT_EQ(excess.id, "brittle-excess");
  EXPECT_EQ(excess.rows.size(), 3U * kArithmetics.size());       // a level is refused
  const Json domain = Json::array({"1", "0.001", "1e-4", "0"});  // from harmless to hard
  EXPECT_NE(excess.spec.dump().find(domain.dump()), std::string::npos);
  EXPECT_EQ(excess.rows[0]["y"], 1e-12);  // 0, where the scale begins
  EXPECT_EQ(excess.rows[0]["y_text"], "0");
  EXPECT_NE(excess.caption.find("float32 from 0 to 0.25"), std::string::npos) << excess.caption;
  EXPECT_EQ(time_chart(results).rows.size(), 6U);
  EXPECT_NE(time_chart(results).caption.find("fixed 20 ns"), std::string::npos);
  EXPECT_EQ(condition_chart(results).rows.size(), 8U * kArithmetics.size());
}

TEST(StressWords, AreMadeFromTheResults) {
  const auto results = tests::sample_results();
  EXPECT_EQ(bounds_words(results[0]),
            "Fixed holds throughout, float32 holds throughout, double holds throughout and "
            "renderer holds throughout.");
  // Of a level at which nothing can be wrong no arithmetic is said to hold to it.
  auto asking_less = results;
  for (Measurement& m : asking_less[0].levels.back()) m.in_penumbra = 0;
  EXPECT_EQ(bounds_words(asking_less[0]).substr(0, 38), "Fixed holds to 1e-4 (must to 1e-4), fl");
  EXPECT_EQ(bounds_words(results[1]),
            "Fixed holds throughout, float32 holds to 1, double holds to 0.001 (but must to 1e-4) "
            "and renderer holds throughout.");
  EXPECT_EQ(refused_words(results[0]), "");
  EXPECT_EQ(refused_words(results[1]), "Refused: 2 cases, first at 0: <i>no room</i>.");
  EXPECT_EQ(finding_words(results)[0],
            "Of 2 families, the bar holds at every difficulty for fixed in 2, float32 in 1, double "
            "in 1 and renderer in 2.");
  Errors rms;
  rms.rms = 0.002;
  EXPECT_EQ(broken_words(rms),
            "an RMS error of 2.0e-3, in penumbrae of 0, where 9.8e-4 is the bar");
  EXPECT_NE(finding_words(results)[1].find("double 2 (1 of them at no foreseen wedge)"),
            std::string::npos);
}

TEST(StressPage, IsWrittenWithItsFiles) {
  const TemporaryFolder folder;
  write_file(folder / "pictures/offset_fixed.png", "of an earlier run");
  write_file(folder / "pictures/mine.png", "no business of ours");
  write_stress(folder.path(), {{}, 2}, tests::sample_results());
  for (const char* file : {"stress.html", "stress.json", "pictures/brittle_float32.png",
                           "pictures/brittle_double.png"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / file)) << file;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "pictures/steady_fixed.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "pictures/offset_fixed.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "pictures/mine.png"));
}

TEST(StressPage, ItsFolderIsCheckedBeforehand) {
  const TemporaryFolder folder;
  require_stress_writable(folder / "out");
  EXPECT_EQ(folder.entries(), 0U);
  write_file(folder / "pictures", "a file");
  EXPECT_THROW(require_stress_writable(folder.path()), InputError);
}

}  // namespace
}  // namespace wedgesim::reports::stress

// Does the page say what was measured? The browser test looks at the rest.
#include "reports/accuracy/accuracy_page.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "base/image.h"
#include "reports/accuracy/accuracy_charts.h"
#include "reports/accuracy/accuracy_words.h"
#include "reports/accuracy/chart_labels.h"
#include "tests/base/temporary_folder.h"
#include "tests/reports/accuracy/sample.h"

namespace wedgesim::reports::accuracy {
namespace {

struct AccuracyPage : testing::Test {
  std::vector<SceneResult> scenes = tests::sample_scenes(3, 7);
  std::vector<std::string> methods = method_names(scenes);
  std::string choice(std::size_t i) const { return scenes[0].methods[i].choice.text; }
};

TEST_F(AccuracyPage, SaysWhatWasMeasuredAsText) {
  const TemporaryFolder folder;
  tests::write_sample(folder.path(), scenes);
  const std::string html(MappedFile(folder / "accuracy.html").text());
  for (const std::string& words :
       {std::string("<strong>3</strong> scenes"), std::string("<strong>18</strong> choices"),
        std::string("<strong>3</strong> refused"), std::string("id=\"scene-round-shadow-2\""),
        "<strong>" + choice(6) + "</strong>: &lt;i&gt;not&lt;/i&gt; a plane",
        std::string("A &lt;b&gt;round&lt;/b&gt; shadow. Frame 0: 60x40, 1,234 triangles cast"),
        "<td>*</td><td>" + choice(0) + "</td><td class=\"number\">0.2000</td>",
        "<td></td><td>" + choice(2) + "</td>", choice(1) + "</a>, RMSE 0.1400 in 1.5 ms",
        std::string("id=\"artifact-hard-no-penumbra\""),
        std::string("It shows: RMSE at least 0.15 in the crop")}) {
    EXPECT_NE(html.find(words), std::string::npos) << words;
  }
  for (const char* words : {"<script src", "<b>round", "<i>not", "<script>window.broken", "{{"}) {
    EXPECT_EQ(html.find(words), std::string::npos) << words;
  }
}

TEST_F(AccuracyPage, PicturesShowMethodReferenceAndDifference) {
  const TemporaryFolder folder;
  tests::write_sample(folder.path(), scenes);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "pictures")) {
    files += entry.path().filename().string().starts_with("artifact_") ? 0 : 1;
  }
  EXPECT_EQ(files, 3U * 6U);  // none of what was refused, nothing left over
  Image strip = read_image(folder / "pictures" / ("round-shadow-2_" + choice(0) + ".png"));
  ASSERT_EQ(strip.width, 3 * 60 + 2 * 4);
  ASSERT_EQ(strip.height, 40);
  // A pixel in the umbra at the left, lighter by 0.2; one at the right, where dark stays dark.
  const auto value = [&](int panel, int x, int channel) {
    return strip.pixel(panel * 64 + x, 24)[channel];
  };
  EXPECT_NEAR(value(0, 27, 0), 0.2, 0.003);
  EXPECT_EQ(value(1, 27, 0), 0.0F);
  EXPECT_EQ(value(2, 27, 0), 1.0F);  // red
  EXPECT_NEAR(value(2, 27, 2), 1.0 - std::sqrt(0.2 / 0.25), 0.003);
  EXPECT_EQ(value(2, 33, 0), 1.0F);  // white
  EXPECT_EQ(value(2, 33, 2), 1.0F);
  EXPECT_LT(value(2, 58, 0), 0.2F);  // blue
  EXPECT_EQ(value(2, 58, 2), 1.0F);
}

TEST_F(AccuracyPage, ScattersDrawEachChoiceAndTheFront) {
  const page::RowChart chart = time_chart(scenes[0], "s", methods);
  ASSERT_EQ(chart.rows.size(), 6U);
  std::vector<std::string> front;
  for (const Json& row : chart.rows) {
    if (row["front"].get<bool>()) front.push_back(row["case"]);
  }
  EXPECT_EQ(front, (std::vector<std::string>{choice(0), choice(1), choice(3), choice(4)}));
  EXPECT_EQ(chart.rows[1]["x"], 1.5);
  EXPECT_EQ(chart.rows[1]["x_text"], "1.5 ms");
  EXPECT_EQ(chart.rows[1]["y_text"], "0.1400");
  EXPECT_NE(chart.caption.find("4 of 6 choices are on the front"), std::string::npos);
  EXPECT_EQ(bytes_chart(scenes[0], "s", methods).rows[1]["x_text"], "2 MB");
}

TEST_F(AccuracyPage, WordsAreMadeFromTheResults) {
  const std::vector<std::string> words = finding_words(scenes[0]);
  ASSERT_EQ(words.size(), 2U);
  EXPECT_EQ(words[0], "No choice has an RMSE of at most 0.01.");
  EXPECT_EQ(words[1], "Fastest of all is " + choice(0) + " (0.2000 in 1 ms), most exact " +
                          choice(4) + " (0.0480 in 5.06 ms); 2 more between them on the front.");
  EXPECT_EQ(error_text(0.0), "0.0000");
  EXPECT_EQ(error_text(4.2e-5), "4.2e-05");
}

TEST(AccuracyWords, SayHowMuchLongerRayTracingTakes) {
  SceneResult result;
  for (const auto& [choice, error, seconds] :
       {std::tuple("raytraced-16", 0.01, 0.1),
        {"raytraced-64", 0.001, 10.0},
        {"ssv", 0.005, 1e-4},
        {"hard", 0.05, 1e-9}}) {  // too wrong to be spoken of
    Measured& measured = result.methods.emplace_back();
    measured.choice = functional::choose_method("", choice);
    measured.errors[static_cast<std::size_t>(Region::receivers)] = {.values = 1, .rmse = error};
    measured.timing.all_threads = seconds;
  }
  EXPECT_EQ(finding_words(result)[1],
            "For the error of ssv ray tracing takes 400 ms, 4,000 times as long.");
}

TEST(ChartLabels, CoverNeitherMarksNorEachOther) {
  const std::vector<LabelledMark> marks{{100, 50, "first"},
                                        {130, 50, "in the way at the right"},
                                        {280, 90, "at the edge"},
                                        {150, 90, "before it"}};
  const auto sides = place_labels(marks, 300, 100);
  EXPECT_EQ(sides[0], Side::above);
  EXPECT_EQ(sides[1], Side::right);
  EXPECT_EQ(sides[2], Side::left);
  EXPECT_EQ(sides[3], Side::above);
  EXPECT_FALSE(place_labels({{50, 50, std::string(40, 'x')}}, 100, 100)[0].has_value());
}

TEST(ChartLabels, KeepOffTheFront) {
  // A stair from (40, 20) to the right, down to (150, 80); two marks beside it.
  const std::vector<LabelledMark> marks{{40, 20, "hard", true},
                                        {150, 80, "ssv", true},
                                        {120, 50, "left of the stair"},
                                        {100, 27, "x"}};
  const auto sides = place_labels(marks, 300, 110);
  EXPECT_EQ(sides[0], Side::below);
  EXPECT_EQ(sides[1], Side::below);
  EXPECT_EQ(sides[2], Side::left);
  EXPECT_EQ(sides[3], Side::right) << "above is the line";
}

}  // namespace
}  // namespace wedgesim::reports::accuracy

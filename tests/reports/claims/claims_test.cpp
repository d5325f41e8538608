// Does a verdict follow from the numbers?
#include "reports/claims/claims.h"

#include <gtest/gtest.h>

#include "reports/runner/study_file.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::reports {
namespace {

constexpr const char* kHead = R"([defaults]
block.mode = "three-pass"
block.tile = 8
[[claim]]
id = "reads"
paper = "II"
section = "7"
says = "fewer reads"
unit = "%"
)";

// A frame each with reads of both modes; single-pass at tile 16 reads a tenth more.
Results results(std::initializer_list<std::pair<int, int>> reads, const char* kind = "linear") {
  Results results;
  int frame = 0;
  for (const auto& [three, single] : reads) {
    FrameRow row;
    row.label = "f" + std::to_string(frame);
    row.scene = frame++ % 2 == 0 ? "even" : "odd";
    row.parameters = {{"kind", std::string(kind)}};
    const auto add = [&](const char* mode, std::int64_t tile, std::int64_t z) {
      PointRow point;
      point.frame = row.label;
      point.measure = "count";
      point.configuration = {{"block.mode", std::string(mode)}, {"block.tile", tile}};
      point.metrics = {{"z_reads", z}, {"visits", std::int64_t{10} * tile}};
      results.points.push_back(point);
    };
    add("three-pass", 8, three);
    add("single-pass", 8, single);
    add("three-pass", 16, three);
    add("single-pass", 16, single + three / 10);
    results.frames.push_back(row);
  }
  return results;
}

ClaimResult judged(const std::string& claim, const Results& results) {
  static ClaimFile file;
  file = parse_claims(kHead + claim, "c.toml");
  return judge_claims(file, results).front();
}

const std::string kSaved = R"([[claim.measured]]
definition = "literal"
kind = "saved"
metric = "z_reads"
to.block.mode = "single-pass"
)";
const std::string kSaved16 = R"([[claim.measured]]
definition = "at 16"
kind = "saved"
metric = "z_reads"
where.block.tile = 16
to.block.mode = "single-pass"
)";

TEST(Claims, TheMedianOverFramesDecides) {
  const Results three = results({{100, 60}, {100, 70}, {100, 99}});
  const ClaimResult held = judged("band = [25, 35]\n" + kSaved, three);
  EXPECT_EQ(held.verdict, Verdict::reproduced);
  EXPECT_DOUBLE_EQ(held.literal().spread.median, 30.0);
  EXPECT_DOUBLE_EQ(held.literal().most, 40.0);
  EXPECT_NEAR(held.literal().within, 1.0 / 3.0, 1e-12);
  EXPECT_EQ(judged("band = [38, 45]\nstatistic = \"most\"\n" + kSaved, three).verdict,
            Verdict::reproduced);
  EXPECT_EQ(judged("band = [50, 60]\n" + kSaved, three).verdict, Verdict::not_reproduced);
}

TEST(Claims, AConventionThatHoldsIsNamed) {
  const Results three = results({{100, 60}, {100, 60}});
  const ClaimResult other = judged("band = [29, 31]\n" + kSaved + kSaved16, three);
  EXPECT_EQ(other.verdict, Verdict::depends);
  EXPECT_NE(other.because.find("at 16"), std::string::npos) << other.because;
  const ClaimResult view = judged("band = [0, 10]\n" + kSaved, results({{100, 60}, {100, 95}}));
  EXPECT_EQ(view.verdict, Verdict::depends);
  EXPECT_EQ(view.because, "holds for many values of: literal (linear wedges)");
  const Results rarely =
      results({{100, 60}, {100, 95}, {100, 60}, {100, 60}, {100, 60}, {100, 60}});
  EXPECT_EQ(judged("band = [0, 15]\n" + kSaved, rarely).because, "scene and view");
  const ClaimResult kind = judged("band = [39, 41]\n" + kSaved, results({{100, 60}}, "coverage"));
  EXPECT_EQ(kind.verdict, Verdict::not_measured);
}

TEST(Claims, SumsSharesAndScenes) {
  const Results two = results({{100, 50}, {200, 50}});
  const std::string share =
      "[[claim.measured]]\ndefinition = \"d\"\nkind = \"share\"\n"
      "metric = \"2 z_reads + visits\"\nof = \"z_reads\"\nto.block.mode = \"single-pass\"\n";
  const ClaimResult odd = judged("band = [0, 100]\nscenes = [\"odd\"]\n" + share, two);
  ASSERT_EQ(odd.literal().count, 1U);
  EXPECT_DOUBLE_EQ(odd.literal().spread.median, 90.0);  // (2 * 50 + 80) / 200
}

TEST(Claims, TheBestTileIsThatWithLeast) {
  const std::string best =
      "[[claim.measured]]\ndefinition = \"d\"\nkind = \"best\"\n"
      "over = \"block.tile\"\nmetric = \"z_reads + visits\"\nto.block.mode = \"single-pass\"\n";
  const ClaimResult result = judged("band = [8, 8]\n" + best, results({{100, 50}}));
  EXPECT_EQ(result.verdict, Verdict::reproduced);
  const std::string weighted =
      "[[claim.measured]]\ndefinition = \"d\"\nkind = \"best\"\n"
      "over = \"block.tile\"\nmetric = \"z_reads + -1 visits\"\n";
  EXPECT_DOUBLE_EQ(
      judged("band = [8, 8]\n" + weighted, results({{100, 50}})).literal().spread.median, 16.0);
}

TEST(Claims, WithoutPointsNothingIsSaid) {
  EXPECT_EQ(judged("band = [0, 100]\n" + kSaved, Results{}).verdict, Verdict::not_measured);
  EXPECT_EQ(judged("band = [0, 100]\nneeds = \"a method\"\n", results({{1, 1}})).because,
            "needs a method");
}

TEST(Claims, MistakesAreNamed) {
  const auto error = [](const std::string& text) {
    return input_error_of([&] { parse_claims(kHead + text, "c.toml"); });
  };
  EXPECT_NE(error("band = [2, 1]\n" + kSaved).find("c.toml:10: 'band'"), std::string::npos);
  EXPECT_NE(error("band = [1, 2]\n").find("c.toml:5"), std::string::npos)
      << error("band = [1, 2]\n");
  EXPECT_NE(
      error("band = [1, 2]\n[[claim.measured]]\ndefinition = \"d\"\nkind = \"more or less\"\n")
          .find("ratio"),
      std::string::npos);
}

// Every claim of the tool can be measured by its own study.
TEST(BuiltInClaims, HaveTheirPointsInTheStudy) {
  const Study study = read_study("claims");
  Results all;
  for (const FrameSpec& frame : study.frames) all.frames.push_back(frame.row);
  for (const FrameSpec& frame : study.frames) {
    for (const Configuration& configuration : study.configurations) {
      PointRow point;
      point.frame = frame.row.label;
      point.measure = configuration.measure_name();
      point.configuration = configuration.values;
      for (const Claim& claim : study_claims().claims) {
        for (const Measurement& measurement : claim.measured) {
          for (const Sum& sum : {measurement.metric, measurement.of}) {
            for (const Sum::Term& term : sum.terms) point.metrics[term.metric] = 1.0;
          }
        }
      }
      all.points.push_back(std::move(point));
    }
  }
  for (const ClaimResult& result : judge_claims(study_claims(), all)) {
    for (std::size_t i = 0; i < result.measured.size(); ++i) {
      EXPECT_EQ(result.measured[i].size(), 2U)
          << result.claim->id << ": " << result.claim->measured[i].definition;
    }
  }
}

}  // namespace
}  // namespace wedgesim::reports

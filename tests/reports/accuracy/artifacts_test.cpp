// Does each artifact of the papers show where the catalogue says, and less with its remedy?
#include "reports/accuracy/artifacts.h"

#include <gtest/gtest.h>

#include <set>

namespace wedgesim::reports::accuracy {
namespace {

TEST(Artifacts, EveryOneThatAMethodNamesIsInTheCatalogue) {
  std::set<std::pair<std::string_view, std::string_view>> known;
  for (const Artifact& artifact : artifacts()) {
    const auto choice = functional::choose_method("", artifact.choice);
    EXPECT_TRUE(known.emplace(choice.method->name, artifact.name).second)
        << artifact.name << " stands twice";
    EXPECT_NE(std::ranges::find(choice.method->artifacts, artifact.name),
              choice.method->artifacts.end())
        << choice.method->name << " does not name " << artifact.name;
  }
  for (const functional::Method& method : functional::methods()) {
    for (const std::string_view name : method.artifacts) {
      EXPECT_TRUE(known.contains({method.name, name})) << method.name << ": " << name;
    }
  }
}

struct ArtifactShows : testing::TestWithParam<Artifact> {};
INSTANTIATE_TEST_SUITE_P(Catalogue, ArtifactShows, testing::ValuesIn(artifacts()),
                         [](const auto& parameter) {
                           std::string name = std::string(parameter.param.choice) + "_" +
                                              std::string(parameter.param.name);
                           for (char& c : name) c = std::isalnum(c) != 0 ? c : '_';
                           return name;
                         });

TEST_P(ArtifactShows, WhereItsPaperSays) {
  const ShownArtifact shown = show(GetParam(), 256);
  EXPECT_TRUE(shown.shows()) << GetParam().criterion.text() << ", but mean "
                             << shown.wrong.errors.mean << ", RMSE " << shown.wrong.errors.rmse
                             << ", step " << shown.wrong.errors.step << ", bend "
                             << shown.wrong.errors.bend;
  EXPECT_EQ(shown.reference.size(),
            static_cast<std::size_t>(GetParam().crop.width * GetParam().crop.height));
  if (!shown.remedy) return;
  EXPECT_LT(shown.remedy->errors.rmse, shown.wrong.errors.rmse);
  EXPECT_FALSE(GetParam().criterion.holds(shown.remedy->errors)) << GetParam().remedy;
}

TEST(Criterion, HoldsFromItsBarOn) {
  using Kind = Criterion::Kind;
  CropErrors errors;
  errors.mean = -0.1;
  errors.rmse = 0.2;
  errors.step = 0.3;
  errors.reference_step = 0.1;
  errors.bend = 0.4;
  errors.reference_bend = 0.21;
  EXPECT_TRUE((Criterion{Kind::too_dark, 0.1}).holds(errors));
  EXPECT_FALSE((Criterion{Kind::too_dark, 0.11}).holds(errors));
  EXPECT_FALSE((Criterion{Kind::too_light, 0.01}).holds(errors));
  EXPECT_TRUE((Criterion{Kind::wrong, 0.2}).holds(errors));
  EXPECT_FALSE((Criterion{Kind::wrong, 0.21}).holds(errors));
  EXPECT_TRUE((Criterion{Kind::steps, 0.3}).holds(errors));
  EXPECT_FALSE((Criterion{Kind::steps, 0.31}).holds(errors));
  EXPECT_FALSE((Criterion{Kind::bends, 0.1}).holds(errors)) << "less than twice the reference's";
  EXPECT_EQ((Criterion{Kind::too_dark, 0.1}).text(), "mean error at most -0.1");
}

TEST(Artifacts, OnlyThoseOfTheMethodsThatAreAsked) {
  const std::vector<std::string> methods{"hard"};
  std::vector<std::string> told;
  const auto shown =
      show_artifacts(methods, 64, [&](std::string_view name) { told.emplace_back(name); });
  ASSERT_EQ(shown.size(), 1U);
  EXPECT_EQ(told, std::vector<std::string>{"no-penumbra"});
  const Json json = artifacts_json(shown);
  EXPECT_EQ(json[0]["name"], "no-penumbra");
  EXPECT_EQ(json[0]["method"], "hard");
  EXPECT_EQ(json[0]["shows"], true);
  EXPECT_GT(json[0]["rmse_in_crop"], 0.15);
  EXPECT_EQ(json[0]["remedy"]["choice"], "sampled-64");
}

}  // namespace
}  // namespace wedgesim::reports::accuracy

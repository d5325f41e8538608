#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

struct Accuracy : testing::Test {
  TemporaryFolder folder;
  std::string file(const std::string& name) const { return (folder / name).string(); }
};

// Small and quick.
Outcome accuracy(std::vector<std::string> options) {
  options.insert(options.begin(), "accuracy");
  for (const char* option : {"--size", "48x32", "--rays", "64", "--repetitions", "1"}) {
    options.emplace_back(option);
  }
  return run_command(options);
}

bool has(const Outcome& outcome, const std::string& words) {
  return outcome.out.find(words) != std::string::npos;
}

TEST_F(Accuracy, MeasuresEveryMethodOnEveryScene) {
  const Outcome good = accuracy({"plain-columns", "ground-polygon", "--json", file("a.json")});
  expect_good(good);
  EXPECT_TRUE(has(good, "plain-columns, frame 0: 48x32")) << good.out;
  EXPECT_TRUE(has(good, "ground-polygon, frame 0: 48x32")) << good.out;
  EXPECT_TRUE(has(good, "raytraced-16")) << good.out;
  std::ifstream in(file("a.json"));
  const auto json = nlohmann::json::parse(in);
  EXPECT_EQ(json["schema"], "wedgesim.accuracy/1");
  ASSERT_EQ(json["scenes"].size(), 2U);
  for (const auto& method : json["scenes"][0]["methods"]) {
    if (method["refused"].is_null()) {
      EXPECT_GT(method["errors"]["receivers"]["values"], 100) << method["choice"];
    } else {
      EXPECT_FALSE(method["refused"].get<std::string>().empty()) << method["choice"];
    }
  }
}

TEST_F(Accuracy, WritesThePageItsDataAndPictures) {
  expect_good(accuracy({"plain-columns", "--method", "raytraced-4", "-o", file("out")}));
  for (const char* name :
       {"accuracy.html", "accuracy.json", "pictures/plain-columns_raytraced-4.png"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / "out" / name)) << name;
  }
}

TEST_F(Accuracy, RecommendsTheFastestMethodWithinAnError) {
  const std::vector<std::string> options{"plain-columns", "--method", "hard",
                                         "--method",      "coverage", "--max-error"};
  const auto within = [&](const std::string& error) {
    std::vector<std::string> all = options;
    all.push_back(error);
    return accuracy(all);
  };
  const Outcome loose = within("1");
  expect_good(loose);
  EXPECT_TRUE(has(loose, "recommended: ")) << loose.out;
  const Outcome good = within("0.03");
  expect_good(good);
  EXPECT_TRUE(has(good, "recommended: coverage (RMSE")) << good.out;
  const Outcome none = within("0");
  EXPECT_EQ(none.code, 1);
  EXPECT_TRUE(has(none, "none: no method reaches RMSE up to 0; the most exact is")) << none.out;
}

TEST_F(Accuracy, BadInputIsOneClearLine) {
  for (const auto& [options, words] :
       std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>>{
           {{}, {"nothing to measure", "--published"}},
           {{"plain-columns", "--published"}, {"several things"}},
           {{"--claims", file("c.md"), "--method", "hard"}, {"--method", "--claims"}},
           {{"nowhere"}, {"nowhere"}},
           {{"--published"}, {"--published", "no option that changes"}},
           {{"--claims", file("c.md"), "--frame", "1"}, {"--claims", "no option that changes"}},
           {{"torus-224 300x300", "--light", "sphere"}, {"torus-224", "is a view"}},
           {{"fire", "--light", "sphere"}, {"--light", "texture"}},
           {{"plain-columns", "--method", "hard", "-o", file("d"), "nowhere"}, {"nowhere"}},
           {{"plain-columns", "--method", "guess"}, {"--method", "unknown method 'guess'"}},
           {{"plain-columns", "--method", "hard:no=1"}, {"hard:no=1", "unknown option 'no'"}},
           {{"plain-columns", "--max-error", "2"}, {"--max-error", "'2'"}},
           {{"plain-columns", "--budget", "x"}, {"--budget", "'x'"}},
           {{"plain-columns", "-o", "/dev/null/a"}, {"/dev/null"}},
           {{"plain-columns", "--json", "/dev/null/a.json"}, {"/dev/null"}}}) {
    expect_bad_input(accuracy(options), words);
  }
  EXPECT_FALSE(std::filesystem::exists(file("d"))) << "nothing is measured before all is read";
}

}  // namespace
}  // namespace wedgesim::cli

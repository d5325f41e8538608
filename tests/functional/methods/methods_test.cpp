#include <gtest/gtest.h>

#include <functional>
#include <regex>
#include <set>

#include "base/error.h"
#include "functional/methods/method.h"
#include "functional/methods/render.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Methods, HaveDifferentNamesASummaryAndASource) {
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_FALSE(method.summary.empty()) << method.name;
    EXPECT_FALSE(method.source.empty()) << method.name;
  }
}

TEST(Methods, EveryComparedChoiceIsOneOfItsOwnMethod) {
  for (const Method& method : methods()) {
    for (const std::string_view text : method.compared) {
      EXPECT_EQ(choose_method("--method", text).method, &method) << text;
    }
  }
}

TEST(ChooseMethod, TakesANumberOfSamplesBehindTheName) {
  const MethodChoice choice = choose_method("--method", "raytraced-64");
  EXPECT_EQ(choice.method->name, "raytraced");
  EXPECT_EQ(choice.options.integer("samples", 1, 1, 100), 64);
}

TEST(ChooseMethod, TakesOptionsBehindAColon) {
  const MethodChoice choice = choose_method("--method", "raytraced:samples=9,other=0.5");
  EXPECT_EQ(choice.options.integer("samples", 1, 1, 100), 9);
  EXPECT_EQ(choice.options.number("other", 1.0, 0.0, 1.0), 0.5);
}

TEST(ChooseMethod, SaysWhatIsWrong) {
  const auto choosing = [](const std::string& text) {
    return error_of([&] { choose_method("--method", text); });
  };
  EXPECT_NE(choosing("guess").find("unknown method 'guess'"), std::string::npos);
  EXPECT_NE(choosing("guess").find("hard, "), std::string::npos);
  EXPECT_NE(choosing("hard:").find("KEY=VALUE"), std::string::npos);
  EXPECT_NE(choosing("hard:a").find("KEY=VALUE"), std::string::npos);
  EXPECT_NE(choosing("hard:a=1,").find("KEY=VALUE"), std::string::npos);
  EXPECT_NE(choosing("raytraced-4:samples=4").find("given twice"), std::string::npos);
}

TEST(MethodOptions, NamesTheOptionAndWhatIsExpected) {
  const MethodOptions options = choose_method("--method", "hard:n=70,mode=fast").options;
  EXPECT_NE(error_of([&] {
              (void)options.integer("n", 8, 8, 64);
            }).find("n = '70'; expected a whole number from 8 to 64"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              (void)options.choice<int>("mode", {{"near", 0}, {"far", 1}});
            }).find("one of near, far"),
            std::string::npos);
}

TEST(RenderMethod, RefusesAnOptionThatTheMethodDoesNotKnow) {
  SceneOptions scene_options;
  scene_options.size = {8, 8};
  const Scene scene = load_scene("plain-columns", scene_options);
  EXPECT_NE(error_of([&] {
              render_view(scene, choose_method("--method", "raytraced:rays=4"));
            }).find("unknown option 'rays'; expected one of samples"),
            std::string::npos);
}

// Else a comparison would show the same method twice.
TEST(RenderMethod, RefusesOptionsWithoutEffect) {
  SceneOptions scene_options;
  scene_options.size = {8, 8};
  const Scene scene = load_scene("plain-columns", scene_options);
  const auto rendering = [&](const char* choice) {
    return error_of([&] { render_view(scene, choose_method("--method", choice)); });
  };
  EXPECT_NE(rendering("ssv:filter=nearest")
                .find("filter = 'nearest' has no effect; expected texture=8…64 with it"),
            std::string::npos);
  for (const char* choice : {"ssv:words=float", "ssv:texture=none,filter=quadlinear",
                             "silhouette-rings-1:pattern=grid", "silhouette-rings-1:fill=flat"}) {
    EXPECT_NE(rendering(choice).find("has no effect"), std::string::npos) << choice;
  }
  for (const char* choice : {"ssv:texture=8,filter=quadlinear,words=float",
                             "silhouette-rings-2:pattern=grid,fill=flat"}) {
    EXPECT_EQ(rendering(choice), "") << choice;
  }
}

// The line of a method's options, which help and errors show, against what the method asks for.
TEST(RenderMethod, EveryMethodSaysItsOptions) {
  SceneOptions scene_options;
  scene_options.size = {8, 8};
  const Scene scene = load_scene("plain-columns", scene_options);
  for (const Method& method : methods()) {
    const std::string error = error_of([&] {
      render_view(scene, choose_method("--method", std::string(method.name) + ":unknown=1"));
    });
    const std::regex key("[a-z]+(?==|, |$)");
    std::set<std::string> asked;
    const std::size_t list = error.find("expected one of ");
    const std::string names = list == std::string::npos ? "" : error.substr(list + 16);
    for (std::sregex_iterator i(names.begin(), names.end(), key), end; i != end; ++i) {
      asked.insert(i->str());
    }
    const std::regex named("[a-z]+(?==)");
    const std::string line(method.options);
    std::set<std::string> said;
    for (std::sregex_iterator i(line.begin(), line.end(), named), end; i != end; ++i) {
      said.insert(i->str());
    }
    EXPECT_EQ(said, asked) << method.name << ": " << line << "; " << error;
  }
}

TEST(RenderMethod, RefusesATextureThatTheMethodDoesNotKnow) {
  SceneOptions scene_options;
  scene_options.size = {8, 8};
  const Scene scene = load_scene("fire", scene_options);
  for (const Method& method : methods()) {
    const auto rendering = [&] {
      const View view = render_view(scene, choose_method("--method", method.name));
      EXPECT_EQ(view.visibility.channels, 3) << method.name;
      EXPECT_EQ(view.visibility.values.size(), 3U * 64U) << method.name;
    };
    const std::string error = error_of(rendering);
    EXPECT_EQ(error.empty(), method.takes_textures) << method.name;
    if (error.empty()) continue;
    EXPECT_NE(error.find("fire.toml: the light has a texture"), std::string::npos) << error;
    EXPECT_NE(error.find("expected one of --method raytraced, --method ssv"), std::string::npos)
        << error;
  }
}

}  // namespace
}  // namespace wedgesim::functional

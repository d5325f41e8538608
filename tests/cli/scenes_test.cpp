#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

TEST(Scenes, ListsOneSceneALine) {
  const Outcome outcome = run_command({"scenes"});
  expect_good(outcome);
  for (const char* scene :
       {"plain-columns", "columns", "fractal", "text2002", "spheres27", "big-light-box", "overlap",
        "cylinder", "ground-polygon", "bunny", "eye-in-shadow", "two-lights", "fire"}) {
    EXPECT_NE(("\n" + outcome.out).find(std::string("\n") + scene + "  "), std::string::npos)
        << scene;
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.ends_with(" frames)") || line.ends_with(" frame)")) << line;
  }
}

TEST(Scenes, TakesNoArgument) {
  expect_bad_input(run_command({"scenes", "columns"}), {"columns", "too many"});
}

}  // namespace
}  // namespace wedgesim::cli

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/command.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

struct Explain : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path trace = make_trace(folder);

  Outcome explain(const std::string& pixel, const std::vector<std::string>& options = {}) const {
    std::vector<std::string> arguments{"explain", trace.string(), "--pixel", pixel};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
  // The first pixel in a penumbra.
  std::size_t penumbra_pixel() const {
    const traces::TraceFile file(trace);
    const auto li = file.view().expected_li;
    std::size_t pixel = 0;
    while (pixel < li.size() && !(li[pixel] > 0.2 && li[pixel] < 0.8)) ++pixel;
    EXPECT_LT(pixel, li.size());
    return pixel;
  }
  static std::string place(std::size_t pixel) {
    return std::to_string(pixel % 96) + ',' + std::to_string(pixel / 96);
  }
};

TEST_F(Explain, AddsUpToTheExpectedLight) {
  const Outcome outcome = explain(place(penumbra_pixel()));
  expect_good(outcome);
  for (const char* word : {"wedge", "plane", "inside", "z reads", "LI = 1", "expected"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST_F(Explain, SinglePassIsTheDefault) {
  const std::string pixel = place(penumbra_pixel());
  EXPECT_EQ(explain(pixel).out, explain(pixel, {"--mode", "single-pass"}).out);
  EXPECT_NE(explain(pixel).out, explain(pixel, {"--mode", "three-pass"}).out);
}

TEST_F(Explain, TakesTheOptionsOfCount) {
  const Outcome outcome =
      explain(place(penumbra_pixel()), {"--mode", "three-pass", "--tile", "32", "--cull", "none"});
  expect_good(outcome);
  EXPECT_NE(outcome.out.find("three-pass"), std::string::npos);
  EXPECT_NE(outcome.out.find("tile of 32"), std::string::npos);
}

TEST_F(Explain, AnotherSumThanExpectedEndsWithOne) {
  const std::size_t pixel = penumbra_pixel();
  const std::filesystem::path wrong = folder / "wrong.wtrace";
  {
    const traces::TraceFile file(trace);
    traces::TraceView view = file.view();
    std::vector<double> li(view.expected_li.begin(), view.expected_li.end());
    li[pixel] += 2.0;
    view.expected_li = li;
    traces::write_trace(wrong, view);
  }
  trace = wrong;
  EXPECT_EQ(explain(place(pixel)).code, 1);
  expect_good(explain(place(pixel + 1)));
  const Outcome counted = run_command({"count", wrong.string()});
  EXPECT_EQ(counted.code, 1);
  EXPECT_NE(counted.out.find("FAILED: single-pass, tile 8"), std::string::npos) << counted.out;
}

TEST_F(Explain, BadPixelsAndOptionsAreRefused) {
  for (const char* pixel : {"9999,0", "0,64", "96,0"}) {
    expect_bad_input(explain(pixel), {"--pixel", pixel, "0,0 to 95,63"});
  }
  for (const char* pixel : {"", "3", "a,b", "-1,2", "1,2,3", "1.5,2", "99999999999,0"}) {
    expect_bad_input(explain(pixel), {"--pixel", pixel});
  }
  expect_bad_input(explain("1,1", {"--tile", "2,4"}), {"--tile", "'2,4'", "expected one value"});
  expect_bad_input(explain("1,1", {"--tile", "all"}), {"--tile", "'all'", "expected one value"});
  expect_bad_input(explain("1,1", {"--tile", "all", "--cull", "none,both"}),
                   {"--cull", "'none,both'", "expected one value"});
  expect_bad_input(explain("1,1", {"--mode", "single-pass,three-pass"}),
                   {"--mode", "expected one value"});
  expect_bad_input(explain("1,1", {"--tile", "3"}), {"--tile", "'3'"});
  trace = folder / "missing.wtrace";
  expect_bad_input(explain("1,1"), {"missing.wtrace"});
}

}  // namespace
}  // namespace wedgesim::cli

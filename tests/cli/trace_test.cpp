#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>

#include "tests/cli/command.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

namespace fb = traces::fb;

struct Trace : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "x.wtrace";
  Outcome trace(const std::vector<std::string>& options,
                const std::string& scene = "plain-columns") const {
    std::vector<std::string> arguments{"trace", scene, "-o", file.string(), "--size", "48x32"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
};

TEST_F(Trace, WritesASoundTraceAndSaysWhatIsInIt) {
  const Outcome outcome = trace({});
  expect_good(outcome);
  const traces::TraceFile written(file);
  EXPECT_EQ(written.view().header.name, "plain-columns");
  EXPECT_EQ(written.view().header.width, 48U);
  EXPECT_EQ(written.view().header.height, 32U);
  EXPECT_EQ(written.view().expected_li.size(), 48U * 32U);
  EXPECT_FALSE(written.view().wedges.empty());
  EXPECT_NE(outcome.out.find("48x32"), std::string::npos);
  const std::string checksum = fmt::format("{:016x}", written.view().header.checksum);
  EXPECT_NE(outcome.out.find(checksum), std::string::npos) << outcome.out;
  EXPECT_EQ(folder.entries(), 1U);
}

TEST_F(Trace, OptionsReachTheTrace) {
  expect_good(trace({"--kind", "linear", "--depth", "float32", "--light", "sphere"}));
  const traces::TraceFile written(file);
  EXPECT_EQ(written.view().wedges.front().kind(), fb::WedgeKind_linear);
  EXPECT_EQ(written.view().header.depth_format, fb::DepthFormat_float32);
  EXPECT_EQ(written.view().header.lights.front().shape, fb::LightShape_sphere);
}

TEST_F(Trace, EveryDepthFormatIsTaken) {
  for (const std::string format : {"unorm24", "unorm16", "float32", "float32_reversed"}) {
    expect_good(trace({"--depth", format}));
    EXPECT_EQ(fb::EnumNameDepthFormat(traces::TraceFile(file).view().header.depth_format), format);
  }
}

TEST_F(Trace, AFixedLengthShortensTheVolumes) {
  expect_good(trace({"--length", "0.5"}));
  const std::string fixed = read_text(file);
  expect_good(trace({"--length", "auto"}));
  EXPECT_NE(read_text(file), fixed);
}

TEST_F(Trace, AnotherFrameIsAnotherTrace) {
  expect_good(trace({}));
  const std::string first = read_text(file);
  expect_good(trace({"--frame", "5"}));
  EXPECT_NE(read_text(file), first);
}

TEST_F(Trace, TheSameSceneGivesTheSameBytes) {
  expect_good(trace({}));
  const std::string first = read_text(file);
  expect_good(trace({}));
  EXPECT_EQ(read_text(file), first);
}

TEST_F(Trace, ALightIsChosenByItsNumber) {
  const auto written_light = [&](const std::vector<std::string>& options) {
    expect_good(trace(options, "two-lights"));
    const traces::TraceFile written(file);
    EXPECT_EQ(written.view().header.lights.size(), 1U);
    return written.view().header.lights.front().centre.x();
  };
  EXPECT_EQ(written_light({}), -6.0);
  EXPECT_EQ(written_light({"--light-number", "1"}), -6.0);
  EXPECT_EQ(written_light({"--light-number", "2"}), 5.5);
  expect_bad_input(trace({"--light-number", "3"}, "two-lights"),
                   {"--light-number", "'3'", "from 1 to 2"});
  expect_bad_input(trace({"--light-number", "0"}), {"--light-number", "'0'"});
}

TEST_F(Trace, ATextureIsLeftOutAndThatIsSaid) {
  const Outcome outcome = trace({}, "fire");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("without its texture"), std::string::npos) << outcome.err;
  EXPECT_FALSE(traces::TraceFile(file).view().wedges.empty());
}

TEST_F(Trace, BadOptionsAreRefusedAndNothingIsWritten) {
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> bad{
      {{"--kind", "round"}, {"--kind", "round", "coverage, linear"}},
      {{"--depth", "unorm8"}, {"--depth", "unorm8", "unorm24"}},
      {{"--length", "0"}, {"--length", "a number from 1e-12 to 1e+12"}},
      {{"--length", "1e308"}, {"--length", "'1e308'", "a number from 1e-12 to 1e+12"}},
      {{"--length", "1e999"}, {"--length", "'1e999'"}},
      {{"--length", "-3"}, {"--length", "-3"}},
      {{"--length", "nan"}, {"--length", "nan"}},
      {{"--length", "inf"}, {"--length", "inf"}},
      {{"--length", "long"}, {"--length", "long"}},
  };
  for (const auto& [options, words] : bad) {
    expect_bad_input(trace(options), words);
    EXPECT_EQ(folder.entries(), 0U) << options.back();
  }
  expect_bad_input(trace({}, "nowhere"), {"nowhere", "no such scene"});
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_F(Trace, WhatCannotFitIsKnownBeforeItIsRendered) {
  const auto start = std::chrono::steady_clock::now();
  expect_bad_input(run_command({"trace", "cylinder", "-o", file.string(), "--size", "16384x16384"}),
                   {"cylinder.toml", "16384x16384", "at most 134217727 pixels"});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(folder.entries(), 0U);
}

TEST_F(Trace, WhatCannotBeShadowedNamesTheScene) {
  write_text(folder / "wide.toml",
             "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
             "[light]\ncentre = [20.0, 1.2, 0.0]\ntarget = [20.0, 0.0, 0.0]\nsize = [90.0, 90.0]\n"
             "[[object]]\nshape = \"box\"\nsize = [1.0, 1.0, 1.0]\ncasts = true\n");
  const std::string scene = (folder / "wide.toml").string();
  const Outcome outcome = trace({"--length", "0.001"}, scene);
  expect_bad_input(outcome, {"box", "never reaches"});
  EXPECT_EQ(outcome.err.find(scene + ": "), 0U) << outcome.err;
}

TEST_F(Trace, AFailedRunLeavesTheOldFile) {
  write_text(file, "old");
  expect_bad_input(trace({}, "nowhere"), {"nowhere"});
  EXPECT_EQ(read_text(file), "old");
}

TEST_F(Trace, MissingFoldersAreMade) {
  file = folder / "a/b/x.wtrace";
  expect_good(trace({}));
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(Trace, BadPlacesAreRefused) {
  write_text(folder / "file", "");
  file = folder / "file/x.wtrace";
  expect_bad_input(trace({}), {"file/x.wtrace"});
  file = "/proc/x.wtrace";
  expect_bad_input(trace({}), {"/proc/x.wtrace"});
  file = folder / "new/";
  expect_bad_input(trace({}), {"new/", "is no file name"});
  EXPECT_EQ(folder.entries(), 1U);
}

}  // namespace
}  // namespace wedgesim::cli

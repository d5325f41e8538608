#include "reports/runner/runner.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "reports/runner/store.h"
#include "reports/runner/value.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::reports {
namespace {

// Two frames of six counted points and two runs of the block each.
constexpr const char* kStudy =
    "time_limit_seconds = 30\n"
    "[frames]\nscene = \"cylinder\"\nframe = [0, 9]\nsize = \"24x16\"\n"
    "[[grid]]\nblock.tile = [4, 8, 16]\nblock.mode = [\"three-pass\", \"single-pass\"]\n"
    "[[grid]]\nmeasure = \"cycles\"\npenumbra.lanes = [1, 2]\n";

struct RunnerTest : testing::Test {
  TemporaryFolder folder;
  Study study = parse_study(kStudy, "sample", "sample.toml");
  RunOptions options;

  RunnerTest() {
    options.folder = folder / "out";
    options.jobs = 2;
  }
  RunCounts run() const { return run_study(study, options); }
  Results results() const { return read_results(options.folder); }
  std::vector<std::string> states() const {
    std::vector<std::string> states;
    for (const PointRow& point : results().points) states.emplace_back(spelling(point.state));
    return states;
  }
  static bool is_tile_8_single(const Configuration& configuration) {
    return configuration.measure == Measure::count && configuration.block.rasterizer.tile == 8 &&
           configuration.block.rasterizer.mode == model::Mode::single_pass;
  }
};

TEST_F(RunnerTest, MeasuresEveryPointOnce) {
  const RunCounts first = run();
  EXPECT_EQ(first.points, 16U);
  EXPECT_EQ(first.measured, 16U);
  EXPECT_EQ(first.rendered, 2U);
  const Results found = results();
  ASSERT_EQ(found.points.size(), 16U);
  EXPECT_EQ(found.frames[1].label, "cylinder-f9");
  EXPECT_EQ(found.points[8].frame, "cylinder-f9");
  EXPECT_EQ(to_text(find_value(found.points[3].configuration, "block.tile")), "8");
  EXPECT_EQ(found.points[6].measure, "cycles");
  for (const PointRow& point : found.points) {
    EXPECT_EQ(to_text(find_value(point.metrics, "mismatched")), "0");
  }
  const RunCounts second = run();
  EXPECT_EQ(second.kept, 16U);
  EXPECT_EQ(second.measured, 0U);
  EXPECT_EQ(second.rendered, 0U);
}

TEST_F(RunnerTest, ACrashIsAPointsOwn) {
  options.before = [](const Configuration& configuration) {
    if (is_tile_8_single(configuration)) std::raise(SIGKILL);
  };
  EXPECT_EQ(run().measured, 16U);
  std::vector<std::string> expected(16, "done");
  expected[3] = expected[11] = "crashed";
  EXPECT_EQ(states(), expected);
  EXPECT_EQ(results().points[3].message, "the worker ended by signal 9 (Killed)");
  EXPECT_EQ(run().measured, 0U) << "kept, too";
  options.before = [](const Configuration&) {};
  options.retry = true;
  EXPECT_EQ(run().measured, 2U);
  EXPECT_EQ(states(), std::vector<std::string>(16, "done"));
}

TEST_F(RunnerTest, ACrashOfARunLosesNoOtherRun) {
  options.before = [](const Configuration& configuration) {
    if (configuration.block.penumbra.lanes == 1) _exit(7);
  };
  run();
  std::vector<std::string> expected(16, "done");
  expected[6] = expected[14] = "crashed";
  EXPECT_EQ(states(), expected);
  EXPECT_EQ(results().points[6].message, "the worker ended by exit code 7");
}

TEST_F(RunnerTest, APointThatTakesTooLongIsGivenUp) {
  study.time_limit_seconds = 0.3;
  options.before = [](const Configuration& configuration) {
    if (is_tile_8_single(configuration)) sleep(60);
  };
  run();
  std::vector<std::string> expected(16, "done");
  expected[3] = expected[11] = "overtime";
  EXPECT_EQ(states(), expected);
  EXPECT_EQ(results().points[3].message, "took longer than 0.3 s");
}

TEST_F(RunnerTest, ARenderThatCrashesOrTakesTooLongMarksItsPointsSo) {
  study.time_limit_seconds = 0.5;
  options.before_render = [](const FrameSpec& frame) {
    if (frame.row.label == "cylinder-f0") std::raise(SIGKILL);
    sleep(60);
  };
  run();
  std::vector<std::string> expected(16, "overtime");
  std::fill_n(expected.begin(), 8, "crashed");
  EXPECT_EQ(states(), expected);
  EXPECT_EQ(results().points[0].message, "the worker ended by signal 9 (Killed)");
  std::string text = kStudy;
  text.replace(text.find("[4, 8, 16]"), 10, "[2, 4, 16]");
  study = parse_study(text, "sample", "sample.toml");
  EXPECT_EQ(run().rendered, 0U) << "kept, too";
  EXPECT_EQ(states(), expected) << "of new points, too";
}

TEST_F(RunnerTest, AnErrorIsAPointsOwn) {
  options.before = [](const Configuration& configuration) {
    if (is_tile_8_single(configuration)) throw InputError("here", "is wrong");
  };
  run();
  std::vector<std::string> expected(16, "done");
  expected[3] = expected[11] = "failed";
  EXPECT_EQ(states(), expected);
  EXPECT_EQ(results().points[3].message, "here: is wrong");
}

TEST_F(RunnerTest, ALargerStudyMeasuresWhatIsNew) {
  run();
  std::string text = kStudy;
  text.replace(text.find("[4, 8, 16]"), 10, "[2, 4, 16]");
  study = parse_study(text, "sample", "sample.toml");
  EXPECT_EQ(run().measured, 4U);
  EXPECT_EQ(results().points.size(), 16U);
  EXPECT_EQ(to_text(find_value(results().points[0].configuration, "block.tile")), "2");
  study = parse_study(kStudy, "sample", "sample.toml");
  EXPECT_EQ(run().measured, 0U) << "what was left out is still there";
}

TEST_F(RunnerTest, OtherSourcesMeasureAnew) {
  run();
  options.sources = "other";
  const RunCounts counts = run();
  EXPECT_EQ(counts.measured, 16U);
  EXPECT_EQ(counts.rendered, 2U);
  EXPECT_EQ(read_stored(options.folder).sources, "other");
}

TEST_F(RunnerTest, WhatAKilledRunLeftHalfWrittenIsRemoved) {
  run();
  std::ofstream(options.folder / ".cylinder-f0.1596.wtrace") << "half";
  std::filesystem::create_directory(options.folder / "maps");
  std::ofstream(options.folder / "maps/.cylinder_t4.1596.png") << "half";
  std::ofstream(options.folder / ".report.1596.html") << "half";
  std::ofstream(options.folder / ".notes.txt") << "the user's own";
  run();
  EXPECT_FALSE(std::filesystem::exists(options.folder / "maps/.cylinder_t4.1596.png"));
  EXPECT_FALSE(std::filesystem::exists(options.folder / ".report.1596.html"));
  EXPECT_FALSE(std::filesystem::exists(options.folder / ".cylinder-f0.1596.wtrace"));
  EXPECT_TRUE(std::filesystem::exists(options.folder / ".notes.txt"));
}

TEST_F(RunnerTest, ATraceThatIsGoneIsRenderedAgain) {
  run();
  std::filesystem::remove(options.folder / "cylinder-f9.wtrace");
  std::ofstream(options.folder / "cylinder-f0.wtrace", std::ios::binary) << "cut off";
  const RunCounts counts = run();
  EXPECT_EQ(counts.rendered, 2U);
  EXPECT_EQ(counts.measured, 0U);
}

TEST_F(RunnerTest, ADamagedTraceIsRenderedAgain) {
  run();
  const std::filesystem::path path = options.folder / "cylinder-f9.wtrace";
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(path) / 2));
  file << "oops" << std::flush;
  std::string text = kStudy;
  text.replace(text.find("[4, 8, 16]"), 10, "[2, 4, 16]");
  study = parse_study(text, "sample", "sample.toml");
  const RunCounts counts = run();
  EXPECT_EQ(counts.rendered, 1U);
  EXPECT_EQ(counts.measured, 4U);
  EXPECT_EQ(states(), std::vector<std::string>(16, "done"));
}

TEST_F(RunnerTest, ASceneThatCannotBeRenderedFailsItsPoints) {
  std::ofstream(folder / "bad.toml")
      << "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
         "[light]\nshape = \"point\"\ncentre = [0.0, 9.0, 0.0]\n"
         "[[object]]\nshape = \"mesh\"\nfile = \"nowhere.obj\"\n";
  study = parse_study("[frames]\nscene = [\"bad.toml\", \"cylinder\"]\nsize = \"24x16\"\n", "s",
                      (folder / "s.toml").string());
  run();
  EXPECT_EQ(states(), (std::vector<std::string>{"failed", "done"}));
  EXPECT_NE(results().points[0].message.find("nowhere.obj"), std::string::npos);
  EXPECT_EQ(results().frames[0].failure, results().points[0].message);
  const RunCounts counts = run();
  EXPECT_EQ(counts.measured + counts.rendered, 0U);
}

TEST_F(RunnerTest, TracesAreFramesToo) {
  run();
  const std::filesystem::path trace = options.folder / "cylinder-f0.wtrace";
  study = parse_study("[frames]\ntrace = \"" + trace.string() + "\"\n", "s", "s.toml");
  options.folder = folder / "other";
  run();
  const Results found = results();
  ASSERT_EQ(found.points.size(), 1U);
  EXPECT_EQ(found.points[0].state, PointState::done);
  EXPECT_EQ(to_text(find_value(found.frames[0].parameters, "width")), "24");
  options.folder = folder / "out";
  EXPECT_NE(input_error_of([this] { run(); }).find("is read, too"), std::string::npos);
}

TEST_F(RunnerTest, NothingThatIsReadIsWritten) {
  std::filesystem::create_directories(options.folder / "maps");
  for (const char* name : {"report.html", "claims.md", "timeline.json", "maps/a.png"}) {
    std::ofstream(options.folder / name) << "the user's own";
    study.frames[0].files = {options.folder / name};
    EXPECT_NE(input_error_of([this] { run(); }).find("is read, too"), std::string::npos) << name;
  }
}

TEST_F(RunnerTest, TwoRunsDoNotShareAFolder) {
  run();
  const Store other(options.folder, options.sources);
  EXPECT_NE(input_error_of([this] { run(); }).find("another run works on it"), std::string::npos);
}

TEST_F(RunnerTest, ShardsArePartsOfTheWhole) {
  std::size_t points = 0;
  for (std::int64_t number = 1; number <= 3; ++number) {
    options.shard = {number, 3};
    options.folder = folder / options.shard.name();
    points += run().points;
  }
  EXPECT_EQ(points, 16U);
  EXPECT_EQ(results().points.size(), 6U);
  EXPECT_EQ(results().points_planned, 16);
}

}  // namespace
}  // namespace wedgesim::reports

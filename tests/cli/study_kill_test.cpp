#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <iostream>
#include <random>
#include <set>

#include "reports/runner/sqlite.h"
#include "reports/runner/store.h"
#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

constexpr int kKills = 20;
constexpr unsigned kSeed = 20031;

// Some 2 seconds of work of one processor: frames, counted points, runs of the block.
constexpr const char* kStudy =
    "[frames]\nscene = [\"cylinder\", \"plain-columns\"]\nframe = \"0-15:5\"\nsize = \"96x64\"\n"
    "[[grid]]\nblock.tile = [2, 4, 8, 16, 32, 64, 128, 256]\n"
    "block.mode = [\"three-pass\", \"single-pass\"]\nblock.cull = [\"none\", \"both\", \"sat\"]\n"
    "[[grid]]\nmeasure = \"cycles\"\nblock.tile = [4, 8]\npenumbra.lanes = [1, 4, 16]\n";

constexpr std::size_t kRows = 4 + 8 + 8 * 54;  // study, frames, points

// Every row of every table, without what is timing.
std::vector<std::string> rows_of(const std::filesystem::path& folder) {
  reports::Database database(reports::results_path(folder), reports::Database::Access::read);
  std::vector<std::string> rows;
  const auto add = [&](const char* sql, int columns) {
    reports::Statement statement(database, sql);
    while (statement.step()) {
      std::string row;
      for (int i = 0; i < columns; ++i) row += statement.text(i) + '|';
      rows.push_back(row);
    }
  };
  add("SELECT key, value FROM study ORDER BY key", 2);
  add("SELECT label, position, key, scene, parameters, checksum, wedges, failure, pictures, "
      "sources FROM frames ORDER BY label",
      10);
  add("SELECT frame, key, position, measure, configuration, state, message, metrics, sources "
      "FROM points ORDER BY frame, key",
      9);
  return rows;
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(StudyKill, TwentyKillsLeaveTheSameRows) {
  const TemporaryFolder folder;
  write_text(folder / "s.toml", kStudy);
  const std::string whole = (folder / "whole").string();
  const std::string killed = (folder / "killed").string();
  const auto arguments = [&folder](const std::string& out) {
    return std::vector<std::string>{"study", (folder / "s.toml").string(), "-o", out};
  };
  expect_good(run_command(arguments(whole)));
  const std::vector<std::string> expected = rows_of(whole);
  ASSERT_EQ(expected.size(), kRows);

  std::mt19937 random(kSeed);
  int kills = 0, finished = 0;
  while (kills < kKills) {
    const auto milliseconds = static_cast<unsigned>(5 + random() % 300);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", kill " + std::to_string(kills) + " after " +
                 std::to_string(milliseconds) + " ms");
    const Outcome outcome = kill_command(milliseconds, SIGKILL, arguments(killed));
    if (outcome.code == 128 + SIGKILL) {
      kills += 1;
      continue;
    }
    // It was through before: its rows are right, and it begins anew.
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    ASSERT_EQ(rows_of(killed), expected);
    std::filesystem::remove_all(killed);
    finished += 1;
  }
  expect_good(run_command(arguments(killed)));
  EXPECT_EQ(rows_of(killed), expected);
  EXPECT_EQ(names_in(killed), names_in(whole)) << "no temporary file is left";
  EXPECT_EQ(read_text(folder / "killed/results.csv"), read_text(folder / "whole/results.csv"));
  std::cout << kKills << " kills, " << finished << " runs through before one, seed " << kSeed
            << '\n';
}

TEST(StudyKill, AnInterruptEndsItAndItGoesOn) {
  const TemporaryFolder folder;
  write_text(folder / "s.toml", kStudy);
  const std::vector<std::string> arguments{"study", (folder / "s.toml").string(), "-o",
                                           (folder / "out").string()};
  EXPECT_EQ(kill_command(200, SIGINT, arguments).code, 128 + SIGINT);
  expect_good(run_command(arguments));
  EXPECT_EQ(rows_of(folder / "out").size(), kRows);
}

}  // namespace
}  // namespace wedgesim::cli

#include "base/temporaries.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <memory>
#include <vector>

#include "base/file.h"
#include "tests/base/temporary_folder.h"

namespace wedgesim {
namespace {

void make(const std::filesystem::path& path) { std::ofstream(path) << "half"; }

TEST(TemporariesDeathTest, ASignalRemovesThemAndEndsTheProgram) {
  const TemporaryFolder folder;
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    EXPECT_EXIT(
        {
          remove_temporaries_on_signal();
          write_atomically(folder / "outer", [&](const auto& outer) {
            make(outer);
            write_atomically(folder / "inner", [&](const auto& inner) {
              make(inner);
              raise(signal);
            });
          });
        },
        testing::KilledBySignal(signal), "");
    EXPECT_EQ(folder.entries(), 0U) << signal;
  }
}

TEST(TemporariesDeathTest, WhatIsFinishedStays) {
  const TemporaryFolder folder;
  EXPECT_EXIT(
      {
        remove_temporaries_on_signal();
        write_atomically(folder / "done", make);
        { const RemovedOnSignal removed(folder / "done"); }
        raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
  EXPECT_TRUE(std::filesystem::exists(folder / "done"));
}

TEST(TemporariesDeathTest, AnIgnoredSignalStaysIgnored) {
  const TemporaryFolder folder;
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        remove_temporaries_on_signal();
        write_atomically(folder / "done", [](const auto& temporary) {
          make(temporary);
          raise(SIGHUP);
        });
        _exit(3);
      },
      testing::ExitedWithCode(3), "");
  EXPECT_TRUE(std::filesystem::exists(folder / "done"));
}

TEST(Temporaries, MoreThanThereIsRoomForAreLeftAlone) {
  std::vector<std::unique_ptr<RemovedOnSignal>> many;
  for (int i = 0; i < 100; ++i) many.push_back(std::make_unique<RemovedOnSignal>("x"));
  EXPECT_NO_THROW(RemovedOnSignal(std::string(10000, 'x')));
}

}  // namespace
}  // namespace wedgesim

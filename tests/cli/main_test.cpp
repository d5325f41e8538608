#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

constexpr std::array<const char*, 7> kCommands{"scenes", "render",  "trace", "dump",
                                               "count",  "explain", "study"};

TEST(Main, HelpNamesEveryCommand) {
  const Outcome help = run_command({"--help"});
  expect_good(help);
  for (const std::string command : kCommands) {
    EXPECT_NE(help.out.find("\n  " + command + ' '), std::string::npos) << command;
  }
}

TEST(Main, EveryCommandHasHelpWithAnExample) {
  for (const std::string command : kCommands) {
    const Outcome help = run_command({command, "--help"});
    expect_good(help);
    EXPECT_NE(help.out.find("Example"), std::string::npos) << command;
    EXPECT_NE(help.out.find("\n  wedgesim " + command), std::string::npos) << command;
  }
}

TEST(Main, NoCommandIsRefused) { expect_bad_input(run_command({}), {"no command", "scenes"}); }

TEST(Main, AnUnknownCommandIsRefused) {
  expect_bad_input(run_command({"frobnicate"}), {"frobnicate", "no such command", "scenes"});
}

TEST(Main, AnUnknownOptionIsRefusedByEveryCommand) {
  expect_bad_input(run_command({"--frobnicate"}), {"--frobnicate", "no such option"});
  const std::vector<std::vector<std::string>> complete{{"scenes"},
                                                       {"render", "x", "-o", "x.png"},
                                                       {"trace", "x", "-o", "x.wtrace"},
                                                       {"dump", "x"},
                                                       {"count", "x"},
                                                       {"explain", "x", "--pixel", "0,0"},
                                                       {"study", "x"}};
  for (std::vector<std::string> arguments : complete) {
    arguments.emplace_back("--frobnicate");
    expect_bad_input(run_command(arguments),
                     {arguments.front(), "--frobnicate", "no such option", "expected"});
  }
}

TEST(Main, AMissingArgumentIsNamed) {
  expect_bad_input(run_command({"render", "columns"}), {"wedgesim render", "--output"});
  expect_bad_input(run_command({"trace", "-o", "x.wtrace"}), {"wedgesim trace", "SCENE"});
  expect_bad_input(run_command({"dump"}), {"wedgesim dump", "FILE"});
  expect_bad_input(run_command({"count"}), {"wedgesim count", "FILE"});
  expect_bad_input(run_command({"explain", "x"}), {"wedgesim explain", "--pixel"});
  expect_bad_input(run_command({"study"}), {"wedgesim study", "NAME"});
}

TEST(Main, AnOptionWithoutItsValueIsNamed) {
  expect_bad_input(run_command({"count", "x", "--tile"}), {"--tile", "expected one value"});
  expect_bad_input(run_command({"count", "x", "--tile", "2", "--tile", "4"}),
                   {"--tile", "more than once"});
}

TEST(Main, OneArgumentTooManyIsNamed) {
  expect_bad_input(run_command({"dump", "a", "b"}), {"wedgesim dump: b", "too many"});
}

TEST(Main, OutputThatCannotBeWrittenIsAnError) {
  const TemporaryFolder folder;
  const std::string trace = make_trace(folder).string();
  const std::string program = WEDGESIM_BINARY_DIR "/cli/wedgesim";
  const std::string err = (folder / "err").string();
  const int status = std::system((program + " dump " + trace + " >/dev/full 2>" + err).c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_EQ(read_text(err).find("standard output: "), 0U);
}

TEST(Main, ProgressIsShownOnATerminalAlone) {
  const TemporaryFolder folder;
  const std::string image = (folder / "x.png").string();
  const std::vector<std::string> arguments{"render", "cylinder", "-o", image, "--size", "32x32"};
  const Outcome shown = run_on_terminal(arguments);
  EXPECT_EQ(shown.code, 0);
  EXPECT_NE(shown.err.find("rendering cylinder"), std::string::npos) << shown.err;
  expect_good(run_command(arguments));
}

}  // namespace
}  // namespace wedgesim::cli

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <csignal>

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
  const std::vector<std::vector<std::string>> printing{
      {"--help"},
      {"count", "--help"},
      {"scenes"},
      {"dump", trace},
      {"count", trace},
      {"explain", trace, "--pixel", "1,1"},
      {"trace", "cylinder", "-o", (folder / "x").string(), "--size", "16x16"}};
  for (const std::vector<std::string>& arguments : printing) {
    expect_bad_input(run_into("/dev/full", arguments), {"standard output: cannot be written"});
  }
}

TEST(Main, NamesNeverMakeTwoLines) {
  const std::string name = "a\nb\tc\x1b[31m\x7f";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"count", name},
                                                    {"render", name, "-o", "x.png"},
                                                    {"dump", name},
                                                    {name},
                                                    {"study", name},
                                                    {"scenes", name}}) {
    expect_bad_input(run_command(arguments), {"a\\nb\\tc\\x1b[31m\\x7f"});
  }
}

TEST(Main, EmptyValuesAreRefused) {
  const TemporaryFolder folder;
  const std::string trace = make_trace(folder).string();
  expect_bad_input(run_command({"count", ""}), {"FILE", "is empty"});
  expect_bad_input(run_command({"count", trace, "--json", ""}), {"--json", "is empty"});
  expect_bad_input(run_command({"count", trace, "--json="}), {"--json", "without a value"});
  expect_bad_input(run_command({"count", trace, "--maps", ""}), {"--maps", "is empty"});
  expect_bad_input(run_command({"dump", trace, "--obj", ""}), {"--obj", "is empty"});
  expect_bad_input(run_command({"trace", "cylinder", "-o", ""}), {"--output", "is empty"});
  expect_bad_input(run_command({"render", "cylinder", "-o", ""}), {"--output", "is empty"});
  expect_bad_input(run_command({"study", "paper2", "-o", ""}), {"--output", "is empty"});
  EXPECT_EQ(folder.entries(), 1U);
}

TEST(Main, AFlagTakesNoValue) {
  expect_bad_input(run_command({"trace", "cylinder", "-o", "x", "--repair=foo"}),
                   {"wedgesim trace", "--repair = foo", "it takes no value", "the option alone"});
}

TEST(Main, ASignalLeavesNoTemporaryFile) {
  const TemporaryFolder folder;
  const std::string trace = make_trace(folder).string();
  const std::filesystem::path temporary = folder / "temporary";
  std::filesystem::create_directory(temporary);
  const std::string pipe = (folder / "pipe").string();  // nobody reads it: writing waits
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    EXPECT_EQ(interrupt_command(temporary, signal, {"dump", trace, "--obj", pipe}).code,
              128 + signal);
    EXPECT_TRUE(std::filesystem::is_empty(temporary)) << signal;
  }
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

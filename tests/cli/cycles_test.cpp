#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

using Json = nlohmann::json;

struct Cycles : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path trace = make_trace(folder);

  Outcome cycles(std::vector<std::string> options) const {
    options.insert(options.begin(), {"cycles", trace.string()});
    return run_command(options);
  }
  Json json(std::vector<std::string> options) const {
    const std::filesystem::path file = folder / "result.json";
    options.insert(options.end(), {"--json", file.string()});
    expect_good(cycles(options));
    return Json::parse(read_text(file));
  }
};

TEST_F(Cycles, PrintsCyclesBottleneckAndBytes) {
  const Outcome outcome = cycles({});
  expect_good(outcome);
  for (const char* text : {" cycles, the bottleneck is ", "wedge_fetch", "li_update.stencil",
                           "tile_depths", "bytes: ", "6,144 compared", " 0 mismatched"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
}

TEST_F(Cycles, JsonHasTheNamesOfItsSchema) {
  const Json result = json({"--config", "paper2-three"});
  EXPECT_EQ(result["schema"], "wedgesim.cycles/1");
  EXPECT_EQ(result["tile"], 8);
  EXPECT_EQ(result["configuration"]["block"]["mode"], "three-pass");
  EXPECT_GT(result["counters"]["z_reads"], 0);
  ASSERT_EQ(result["units"].size(), 7U);
  for (const Json& unit : result["units"]) {
    EXPECT_EQ(unit["busy_cycles"].get<std::uint64_t>() +
                  unit["starved_cycles"].get<std::uint64_t>() +
                  unit["stalled_cycles"].get<std::uint64_t>(),
              result["cycles"].get<std::uint64_t>())
        << unit["name"];
  }
  EXPECT_EQ(result["memory"]["line_bytes"].get<std::uint64_t>() % 64, 0U);
  EXPECT_EQ(result["pixels"]["mismatched"], 0);
}

TEST_F(Cycles, ClockedGivesTheSame) {
  Json fast = json({"--config", "small"});
  Json clocked = json({"--config", "small", "--clocked"});
  fast.erase("timing");
  clocked.erase("timing");
  EXPECT_EQ(fast, clocked);
}

TEST_F(Cycles, PrintedConfigurationsAreTaken) {
  const Outcome printed = run_command({"cycles", "--print-config", "--config", "wide"});
  expect_good(printed);
  write_text(folder / "own.toml", printed.out);
  const std::string own = (folder / "own.toml").string();
  EXPECT_EQ(run_command({"cycles", "--print-config", "--config", own}).out, printed.out);
  EXPECT_EQ(json({"--config", own})["cycles"], json({"--config", "wide"})["cycles"]);
}

// Each line of a trace is one access of 64 bytes.
TEST_F(Cycles, MemoryTracesHaveAllBytes) {
  const std::string file = (folder / "memory.txt").string();
  for (const std::string format : {"csv", "dramsys", "dramsim3", "ramulator"}) {
    const Json result = json({"--memory-trace", file, "--memory-trace-format", format});
    std::istringstream lines(read_text(file));
    std::uint64_t accesses = 0;
    for (std::string line; std::getline(lines, line);) {
      accesses += line.find("0x") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(64 * accesses, result["memory"]["line_bytes"]) << format;
  }
}

TEST_F(Cycles, BadInputIsRefused) {
  write_text(folder / "bad.toml", "preset = \"small\"\n[penumbra]\nlanes = 0\n");
  const std::string bad = (folder / "bad.toml").string();
  const std::size_t entries = folder.entries();
  const std::string out = (folder / "out").string();
  expect_bad_input(cycles({"--config", bad, "--json", out}), {"bad.toml:3", "'lanes'", "1"});
  write_text(folder / "narrow.toml", "preset = \"small\"\n[formats]\nform_bits = 31\n");
  expect_bad_input(cycles({"--config", (folder / "narrow.toml").string(), "--json", out}),
                   {"narrow.toml", "'form_bits'", "too narrow", "32 or more"});
  std::filesystem::remove(folder / "narrow.toml");
  expect_bad_input(cycles({"--config", "huge"}), {"huge", "paper2-single"});
  expect_bad_input(cycles({"--config", (folder / "no.toml").string()}), {"no.toml"});
  expect_bad_input(cycles({"--memory-trace", out, "--memory-trace-format", "vcd"}),
                   {"--memory-trace-format", "ramulator"});
  expect_bad_input(cycles({"--json", "/proc/x.json"}), {"/proc/x.json"});
  expect_bad_input(cycles({"--json", trace.string()}), {"is read, too"});
  expect_bad_input(cycles({"--memory-trace", trace.string()}), {"is read, too"});
  expect_bad_input(run_command({"cycles"}), {"no FILE given"});
  expect_bad_input(run_command({"cycles", bad}), {"bad.toml"});
  EXPECT_EQ(folder.entries(), entries);
}

}  // namespace
}  // namespace wedgesim::cli

#include <gtest/gtest.h>

#include <map>
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

TEST_F(Cycles, TheCsvTraceNamesItsConfiguration) {
  const std::string file = (folder / "memory.csv").string();
  const auto hash = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--memory-trace", file});
    const Json result = json(options);
    const std::string text = read_text(file);
    const std::string key = "\n# configuration ";
    const std::string value = text.substr(text.find(key) + key.size(), 17);
    EXPECT_EQ(value, result["configuration"]["hash"].get<std::string>() + '\n');
    return value;
  };
  write_text(folder / "small.toml",
             run_command({"cycles", "--print-config", "--config", "small"}).out);
  const std::string small = hash({"--config", "small"});
  EXPECT_EQ(hash({"--config", (folder / "small.toml").string()}), small);
  EXPECT_NE(hash({"--config", "wide"}), small);
}

// Requests of 32 bytes: two lines for each of 64. Cycles of 1000 MHz: twice the block's.
TEST_F(Cycles, ATraceForDramSim3HasTheMemorysRequestsAndClock) {
  const std::string file = (folder / "memory.trc").string();
  const auto trace_lines = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--memory-trace", file, "--memory-trace-format", "dramsim3"});
    expect_good(cycles(options));
    std::vector<std::string> lines;
    std::istringstream text(read_text(file));
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
  };
  const auto last_cycle = [](const std::vector<std::string>& lines) {
    return std::stoull(lines.back().substr(lines.back().rfind(' ')));
  };
  const auto whole = trace_lines({"--memory-trace-mhz", "500"});
  const auto halves =
      trace_lines({"--memory-trace-mhz", "1000", "--memory-trace-request-bytes", "32"});
  EXPECT_EQ(halves.size(), 2 * whole.size());
  EXPECT_EQ(last_cycle(halves), 2 * last_cycle(whole));
  EXPECT_NEAR(static_cast<double>(last_cycle(trace_lines({}))),
              3.2 * static_cast<double>(last_cycle(whole)), 1.0);
}

// Every unit has a track, in the order of the pipeline, and its spans are its cycles.
TEST_F(Cycles, TheTimelineIsEveryCycleOfEveryUnit) {
  const std::string file = (folder / "timeline.json").string();
  const Json result = json({"--timeline", file});
  struct Track {
    std::string name;
    std::uint64_t busy = 0, stalled = 0, end = 0;
  };
  std::vector<Track> tracks;
  std::size_t overlaps = 0;
  const Json events = Json::parse(read_text(file))["traceEvents"];
  for (const Json& event : events) {
    if (event["name"] == "thread_name") tracks.push_back({event["args"]["name"]});
    if (event["ph"] != "X") continue;
    Track& track = tracks.at(event["tid"].get<std::size_t>() - 1);
    const auto begin = event["ts"].get<std::uint64_t>();
    overlaps += begin < track.end ? 1 : 0;
    track.end = begin + event["dur"].get<std::uint64_t>();
    (event["name"] == "busy" ? track.busy : track.stalled) += track.end - begin;
  }
  EXPECT_EQ(overlaps, 0U);
  ASSERT_EQ(tracks.size(), result["units"].size());
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const Json& unit = result["units"][i];
    EXPECT_EQ(tracks[i].name, unit["name"]);
    EXPECT_EQ(tracks[i].busy, unit["busy_cycles"]) << tracks[i].name;
    EXPECT_EQ(tracks[i].stalled, unit["stalled_cycles"]) << tracks[i].name;
    EXPECT_LE(tracks[i].end, result["cycles"].get<std::uint64_t>()) << tracks[i].name;
  }
}

// What a value change dump says of each unit, in cycles; times come in order.
std::map<std::string, std::map<std::string, std::uint64_t>> cycles_of_vcd(const std::string& text) {
  std::map<std::string, std::string> names, values;
  std::map<std::string, std::uint64_t> since;
  std::map<std::string, std::map<std::string, std::uint64_t>> cycles;
  std::istringstream words(text);
  std::uint64_t now = 0;
  for (std::string word; words >> word;) {
    if (word == "$var") {
      std::string type, width, id;
      words >> type >> width >> id >> names[id];
      EXPECT_EQ(width, "2");
    } else if (word[0] == '#') {
      EXPECT_GE(std::stoull(word.substr(1)), now);
      now = std::stoull(word.substr(1));
    } else if (word[0] == 'b' && word.size() == 3) {
      std::string id;
      words >> id;
      const std::string& name = names.at(id);
      if (values.contains(id)) cycles[name][values[id]] += now - since[id];
      values[id] = word;
      since[id] = now;
    }
  }
  return cycles;
}

TEST_F(Cycles, TheValueChangeDumpIsTheSame) {
  const std::string file = (folder / "timeline.vcd").string();
  const Json result = json({"--vcd", file});
  auto cycles = cycles_of_vcd(read_text(file));
  EXPECT_EQ(cycles.size(), 7U);
  for (const Json& unit : result["units"]) {
    EXPECT_EQ(cycles[unit["name"]]["b01"], unit["busy_cycles"]) << unit["name"];
    EXPECT_EQ(cycles[unit["name"]]["b10"], unit["stalled_cycles"]) << unit["name"];
  }
}

TEST_F(Cycles, AWindowIsAllThatBothShow) {
  const std::string timeline = (folder / "timeline.json").string();
  const std::string vcd = (folder / "timeline.vcd").string();
  expect_good(cycles({"--timeline", timeline, "--vcd", vcd, "--window", "1000,1200"}));
  std::size_t spans = 0;
  const Json events = Json::parse(read_text(timeline))["traceEvents"];
  for (const Json& event : events) {
    if (event["ph"] != "X") continue;
    ++spans;
    EXPECT_GE(event["ts"], 1000);
    EXPECT_LE(event["ts"].get<int>() + event["dur"].get<int>(), 1200);
  }
  EXPECT_GT(spans, 0U);
  for (const auto& [unit, states] : cycles_of_vcd(read_text(vcd))) {
    std::uint64_t sum = 0;
    for (const auto& state : states) sum += state.second;
    EXPECT_LE(sum, 200U) << unit;
  }
  // A window as wide as 64 bits.
  expect_good(cycles({"--timeline", timeline, "--window", "0,5000000000"}));
}

TEST_F(Cycles, MapsAreWrittenAndTheirScalesPrinted) {
  const std::string prefix = (folder / "map").string();
  const Outcome outcome = cycles({"--maps", prefix});
  expect_good(outcome);
  for (const char* map : {"_tile_bytes", "_tile_cycles"}) {
    EXPECT_NE(outcome.out.find(prefix + map + ": from 0 to "), std::string::npos);
    for (const char* kind : {".png", ".exr"}) {
      EXPECT_TRUE(std::filesystem::exists(prefix + map + kind)) << map << kind;
    }
  }
}

TEST_F(Cycles, EnergyIsCountsTimesTheTable) {
  write_text(folder / "energy.toml",
             "datapath_word_pj = 0\ncache_access_pj = 0\ndram_byte_pj = 2\n"
             "dram_activate_pj = 100\n");
  const std::string table = (folder / "energy.toml").string();
  const Json result = json({"--config", "small", "--energy", table});
  const Json& model = result["memory"]["model"];
  const Json& energy = result["energy_picojoules"];
  EXPECT_EQ(energy["dram_bytes"].get<double>(), 2.0 * model["bytes"].get<double>());
  EXPECT_EQ(energy["dram_activates"].get<double>(),
            100.0 * (model["row_misses"].get<double>() + model["row_conflicts"].get<double>()));
  EXPECT_EQ(energy["total"].get<double>(),
            energy["dram_bytes"].get<double>() + energy["dram_activates"].get<double>());
  EXPECT_NE(cycles({"--energy", table}).out.find("energy: "), std::string::npos);
  EXPECT_TRUE(json({})["energy_picojoules"].is_null());
}

// One output that cannot be written: none is there afterwards, nor a folder.
TEST_F(Cycles, AllOutputsAreWrittenOrNone) {
  const std::size_t entries = folder.entries();
  const auto file = [this](const char* name) { return (folder / name).string(); };
  expect_bad_input(cycles({"--timeline", file("t.json"), "--vcd", file("t.vcd"), "--memory-trace",
                           file("new/m.csv"), "--maps", file("map"), "--json", "/proc/x.json"}),
                   {"/proc/x.json"});
  EXPECT_EQ(folder.entries(), entries);
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
  expect_bad_input(cycles({"--memory-trace", out, "--memory-trace-request-bytes", "4"}),
                   {"--memory-trace-request-bytes", "8 to 4096"});
  expect_bad_input(cycles({"--memory-trace", out, "--memory-trace-request-bytes", "48"}),
                   {"request_bytes", "a power of two"});
  expect_bad_input(cycles({"--memory-trace", out, "--memory-trace-mhz", "0"}),
                   {"--memory-trace-mhz", "1 to 10000"});
  for (const char* window : {"5", "5,", "9,9", "-1,4", "a,b", "1,2,3"}) {
    expect_bad_input(cycles({"--timeline", out, "--window", window}),
                     {"--window", window, "is not a window", "BEGIN,END cycles"});
  }
  expect_bad_input(cycles({"--json", "/proc/x.json"}), {"/proc/x.json"});
  expect_bad_input(cycles({"--json", trace.string()}), {"is read, too"});
  expect_bad_input(cycles({"--memory-trace", trace.string()}), {"is read, too"});
  expect_bad_input(run_command({"cycles"}), {"no FILE given"});
  expect_bad_input(run_command({"cycles", bad}), {"bad.toml"});
  EXPECT_EQ(folder.entries(), entries);
}

}  // namespace
}  // namespace wedgesim::cli

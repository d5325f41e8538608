#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "base/image.h"
#include "model/count/counters.h"
#include "tests/cli/command.h"

namespace wedgesim::cli {
namespace {

using Json = nlohmann::json;

std::set<std::string> keys_of(const Json& json) {
  std::set<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.insert(key);
  return keys;
}

struct Count : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path trace = make_trace(folder);

  Outcome count(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"count", trace.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_command(arguments);
  }
  Json json(std::vector<std::string> options) const {
    const std::filesystem::path file = folder / "result.json";
    options.insert(options.end(), {"--json", file.string()});
    expect_good(count(options));
    return Json::parse(read_text(file));
  }
};

TEST_F(Count, PrintsEveryCounterWithUnitAndDescription) {
  const Outcome outcome = count({});
  expect_good(outcome);
  const model::Counters registry;
  for (const Counter* counter : registry.counters()) {
    EXPECT_NE(outcome.out.find('\n' + std::string(counter->name()) + ' '), std::string::npos)
        << counter->name();
    EXPECT_NE(outcome.out.find(counter->description()), std::string::npos) << counter->name();
  }
  EXPECT_NE(outcome.out.find("pixels: 6,144 compared in 2 configurations;"), std::string::npos);
  EXPECT_NE(outcome.out.find("the 10 worst pixels:"), std::string::npos);
}

TEST_F(Count, JsonHasTheNamesOfItsSchema) {
  const Json result = json({"--mode", "three-pass,single-pass"});
  EXPECT_EQ(keys_of(result),
            (std::set<std::string>{"schema", "trace", "configuration", "flagged", "configs"}));
  EXPECT_EQ(result["schema"], "wedgesim.count/1");
  EXPECT_EQ(keys_of(result["trace"]),
            (std::set<std::string>{"name", "checksum", "width", "height", "wedges"}));
  EXPECT_EQ(result["trace"]["width"], 96);
  EXPECT_EQ(result["configuration"]["mode"], Json({"three-pass", "single-pass"}));
  EXPECT_EQ(result["configuration"]["needs"], "all");
  ASSERT_EQ(result["configs"].size(), 2U);
  const Json& config = result["configs"][1];
  for (const char* key :
       {"mode", "tile", "cull", "share", "z", "datapath", "counters", "pixels", "timing"}) {
    EXPECT_TRUE(config.contains(key)) << key;
  }
  EXPECT_EQ(config["mode"], "single-pass");
  EXPECT_EQ(config["tile"], 8);
  EXPECT_EQ(config["cull"], Json({{"penumbra", "both"}, {"umbra", "zmax"}, {"accept", "none"}}));
  EXPECT_EQ(config["share"], "eye");
  EXPECT_EQ(config["z"], "pass");
  EXPECT_EQ(config["datapath"], "exact");
  EXPECT_EQ(keys_of(config["timing"]), (std::set<std::string>{"seconds"}));
  for (const char* key : {"compared", "max_error", "rms_error", "mismatched", "tolerance"}) {
    EXPECT_TRUE(config["pixels"].contains(key)) << key;
  }
  const Json& counted = config["counters"];
  EXPECT_EQ(config["totals"]["accesses"],
            counted["z_reads"].get<int>() + counted["li_writes"].get<int>());
  EXPECT_EQ(config["totals"]["accesses_floor"],
            counted["z_reads_floor"].get<int>() + counted["li_writes_floor"].get<int>());
  EXPECT_EQ(config["pixels"]["compared"], 96 * 64);
  EXPECT_EQ(config["pixels"]["mismatched"], 0);
  std::set<std::string> counters;
  const model::Counters registry;
  for (const Counter* counter : registry.counters()) counters.emplace(counter->name());
  EXPECT_EQ(keys_of(config["counters"]), counters);
  EXPECT_GT(config["counters"]["z_reads"], 0);
}

TEST_F(Count, DefaultsAreThoseOfTheManual) {
  const Json result = json({});
  ASSERT_EQ(result["configs"].size(), 2U);
  EXPECT_EQ(result["configs"][0]["mode"], "single-pass");
  EXPECT_EQ(result["configs"][1]["mode"], "three-pass");
  Json same = json({"--mode",       "single-pass,three-pass",
                    "--tile",       "8",
                    "--cull",       "both",
                    "--umbra-cull", "zmax",
                    "--accept",     "none",
                    "--share",      "eye",
                    "--z",          "auto",
                    "--tile-build", "eager",
                    "--datapath",   "exact",
                    "--needs",      "all"});
  EXPECT_EQ(same["configuration"], result["configuration"]);
  EXPECT_EQ(same["configs"][1]["counters"], result["configs"][1]["counters"]);
}

TEST_F(Count, EveryZMethodAndTileBuildIsTaken) {
  for (const std::string z : {"auto", "pass", "fail"}) {
    EXPECT_EQ(json({"--z", z})["configs"][0]["z"], z == "auto" ? "pass" : z);
  }
  const auto built = [this](const std::string& how) -> std::uint64_t {
    return json({"--tile-build", how})["configs"][0]["counters"]["tile_build_reads"];
  };
  EXPECT_EQ(built("eager"), 96U * 64U);
  EXPECT_LT(built("lazy"), 96U * 64U);
  EXPECT_GT(built("lazy"), 0U);
  EXPECT_EQ(built("none"), 0U);
}

TEST_F(Count, NothingButTimingVaries) {
  const auto without_timing = [this] {
    Json result = json({"--tile", "all"});
    for (Json& config : result["configs"]) config.erase("timing");
    return result;
  };
  EXPECT_EQ(without_timing(), without_timing());
}

TEST_F(Count, SetsAreCombined) {
  const Json result =
      json({"--mode", "single-pass,three-pass", "--tile", "4,16", "--cull", "none,zmax,sat",
            "--umbra-cull", "none,zmax", "--accept", "none,zmin", "--share", "eye,all"});
  EXPECT_EQ(result["configs"].size(), 2U * 2 * 3 * 2 * 2 * 2);
  std::set<std::string> distinct;
  for (Json config : result["configs"]) {
    config.erase("timing");
    config.erase("counters");
    distinct.insert(config.dump());
  }
  EXPECT_EQ(distinct.size(), result["configs"].size());
}

TEST_F(Count, AllTilesAreEight) {
  const Json result = json({"--tile", "all", "--mode", "single-pass"});
  std::vector<int> tiles;
  for (const Json& config : result["configs"]) tiles.push_back(config["tile"]);
  EXPECT_EQ(tiles, (std::vector{2, 4, 8, 16, 32, 64, 128, 256}));
}

TEST_F(Count, IntegersOf255AreOffered) {
  const Json result = json({"--datapath", "paper255"});
  EXPECT_EQ(result["configs"][0]["datapath"], "paper255");
  EXPECT_GT(result["configs"][0]["pixels"]["max_error"], 1e-6);
}

TEST_F(Count, SinglePrecisionIsOffered) {
  const Json result = json({"--datapath", "float32"});
  EXPECT_EQ(result["configs"][0]["datapath"], "float32");
  EXPECT_GT(result["configs"][0]["pixels"]["max_error"], 1e-7);
}

TEST_F(Count, FixedDatapathHoldsThePixelBars) {
  const Json result = json({"--datapath", "fixed"});
  EXPECT_EQ(result["configuration"]["formats"]["significand_bits"], 18);
  for (const Json& config : result["configs"]) {
    EXPECT_EQ(config["datapath"], "fixed");
    EXPECT_EQ(config["pixels"]["mismatched"], 0);
    EXPECT_GT(config["pixels"]["max_error"], 1e-6);
    EXPECT_LE(config["pixels"]["rms_error"], 0.25 / 255);
    EXPECT_TRUE(config["first_overflow"].is_null());
  }
}

TEST_F(Count, FormatsChangeTheWidths) {
  const std::filesystem::path file = folder / "formats.toml";
  const auto rms = [&](const std::string& text) {
    write_text(file, text);
    const Json result = json({"--datapath", "fixed", "--formats", file.string()});
    return result["configs"][0]["pixels"]["rms_error"].get<double>();
  };
  EXPECT_LT(rms("li_fraction_bits = 20\n"), 0.2 * rms("# the default\n"));
  EXPECT_TRUE(json({"--datapath", "fixed"})["flagged"].empty());
  // Too few bits are a failed check, not bad input.
  write_text(file, "form_bits = 32\n");
  const Outcome narrow = count({"--datapath", "fixed", "--formats", file.string()});
  EXPECT_EQ(narrow.code, 1);
  EXPECT_NE(narrow.out.find(" wedges flagged: "), std::string::npos);
}

TEST_F(Count, BadFormatsAreRefused) {
  const std::filesystem::path file = folder / "formats.toml";
  const auto fixed = [&] { return count({"--datapath", "fixed", "--formats", file.string()}); };
  expect_bad_input(fixed(), {"formats.toml", "No such file"});
  write_text(file, "li_bits = 16\n");
  expect_bad_input(fixed(), {"formats.toml", "li_bits"});
  write_text(file, "\nform_bits = 63\n");
  expect_bad_input(fixed(), {"formats.toml", "form_bits", "62"});
  write_text(file, "form_bits = 23\n");
  expect_bad_input(fixed(), {"formats.toml", "form_bits", "24"});
  write_text(file, "form_bits = 31\n");
  expect_bad_input(fixed(), {"form_bits", "too narrow for a frame of 96x64", "32 or more"});
  write_text(file, "form_bits = 'many'\n");
  expect_bad_input(fixed(), {"formats.toml", "form_bits"});
  write_text(file, "form_bits = \n");
  expect_bad_input(fixed(), {"formats.toml"});
  write_text(file, "form_bits = 50\n");
  expect_bad_input(count({"--formats", file.string()}), {"--formats", "--datapath fixed"});
}

TEST_F(Count, MapsShowWhereTheAccessesAre) {
  const std::string prefix = (folder / "maps/p").string();
  const Json result = json({"--maps", prefix, "--mode", "three-pass"});
  const auto sum = [&](const std::string& name) {
    double total = 0.0;
    for (const float value : read_image(prefix + name + ".exr").values) total += value;
    return total;
  };
  EXPECT_EQ(sum("_z_reads"), result["configs"][0]["counters"]["z_reads"]);
  EXPECT_EQ(sum("_li_writes"), result["configs"][0]["counters"]["li_writes"]);
  for (const char* name : {"_z_reads", "_li_writes", "_li", "_difference"}) {
    EXPECT_EQ(read_image(prefix + name + ".png").width, 96) << name;
    EXPECT_EQ(read_image(prefix + name + ".exr").channels, 1) << name;
  }
}

TEST_F(Count, ZFailIsTakenWhereItIsNeeded) {
  trace = make_trace(folder, "eye-in-shadow");
  EXPECT_EQ(json({})["configs"][0]["z"], "fail");
  expect_bad_input(count({"--z", "pass"}), {"--z pass", "fail or auto"});
}

TEST_F(Count, BadOptionsAreRefused) {
  const std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> bad{
      {{"--tile", "3"}, {"--tile", "'3'", "2 to 256"}},
      {{"--tile", "0"}, {"--tile", "'0'"}},
      {{"--tile", "512"}, {"--tile", "'512'"}},
      {{"--tile", "4,,8"}, {"--tile", "empty"}},
      {{"--tile", ""}, {"--tile"}},
      {{"--tile", "8,8"}, {"--tile", "'8' is given twice"}},
      {{"--tile", "8,4,08"}, {"--tile", "'08' is given twice"}},
      {{"--tile", "all,8"}, {"--tile", "'all' stands beside other values"}},
      {{"--mode", "single-pass,single-pass"}, {"--mode", "given twice"}},
      {{"--cull", "both,none,both"}, {"--cull", "'both' is given twice"}},
      {{"--mode", "two-pass"}, {"--mode", "two-pass", "single-pass, three-pass"}},
      {{"--cull", "all"}, {"--cull", "'all'", "zrange"}},
      {{"--umbra-cull", "both"}, {"--umbra-cull", "'both'"}},
      {{"--accept", "zmax"}, {"--accept", "'zmax'"}},
      {{"--share", "none"}, {"--share", "'none'"}},
      {{"--z", "maybe"}, {"--z", "'maybe'"}},
      {{"--tile-build", "never"}, {"--tile-build", "'never'"}},
      {{"--datapath", "float"}, {"--datapath", "'float'", "exact"}},
      {{"--needs", "some"}, {"--needs", "'some'", "all"}},
      {{"--tile", "2,4", "--maps", (folder / "maps/p").string()},
       {"--maps", "given with 4 configurations", "--mode single-pass or three-pass"}},
      {{"--maps", (folder / "maps/p").string()}, {"--maps", "given with 2 configurations"}},
      {{"--mode", "single-pass", "--maps", "/proc/p"}, {"/proc/p_", "cannot be written"}},
      {{"--mode", "single-pass", "--maps", (trace / "p").string()}, {"p_", "folder"}},
      {{"--json", "/proc/x.json"}, {"/proc/x.json"}},
      {{"--json", (trace / "x.json").string()}, {"x.json"}},
  };
  for (const auto& [options, words] : bad) {
    const Outcome outcome = count(options);
    expect_bad_input(outcome, words);
    EXPECT_EQ(outcome.err.find("/.p_"), std::string::npos) << "temporary: " << outcome.err;
    EXPECT_EQ(folder.entries(), 1U) << options.back();
  }
}

TEST_F(Count, DamagedTracesAreRefused) {
  const std::string sound = read_text(trace);
  const std::filesystem::path good = trace;
  trace = folder / "damaged.wtrace";
  expect_bad_input(count({}), {"damaged.wtrace", "No such file"});
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{31}, sound.size() / 2, sound.size() - 1}) {
    write_text(trace, sound.substr(0, length));
    expect_bad_input(count({}), {"damaged.wtrace"});
  }
  for (std::size_t at = 0; at < sound.size(); at += sound.size() / 8 + 1) {
    std::string flipped = sound;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    write_text(trace, flipped);
    expect_bad_input(count({"--json", (folder / "x.json").string()}), {"damaged.wtrace"});
  }
  write_text(trace, sound + "x");
  expect_bad_input(count({}), {"damaged.wtrace"});
  EXPECT_FALSE(std::filesystem::exists(folder / "x.json"));
}

}  // namespace
}  // namespace wedgesim::cli

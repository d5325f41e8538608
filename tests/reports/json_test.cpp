#include "reports/json.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/base/temporary_folder.h"
#include "tests/reports/results.h"

namespace wedgesim::reports {
namespace {

TEST(Json, ATraceIsNamedWithItsChecksum) {
  EXPECT_EQ(to_json(TraceInfo{"x", 0xabcU, 3, 2, 7}).dump(),
            R"({"name":"x","checksum":"0000000000000abc","width":3,"height":2,"wedges":7})");
}

TEST(Json, AResultHasAllCountersInTheirOrder) {
  const model::CountResult result = make_result({}, 5, 3);
  const Json counters = to_json(result, model::DatapathKind::exact)["counters"];
  ASSERT_EQ(counters.size(), result.counters->counters().size());
  std::size_t i = 0;
  for (const auto& [name, value] : counters.items()) {
    const Counter& counter = *result.counters->counters()[i++];
    EXPECT_EQ(name, counter.name());
    EXPECT_EQ(value, counter.value());
  }
}

TEST(Json, AResultSaysItsEffectiveConfiguration) {
  model::CountResult result = make_result({}, 5, 3);
  result.config = {model::Mode::three_pass,   32,
                   model::Cull::sat,          model::UmbraCull::none,
                   model::Accept::zmin,       model::Share::all,
                   model::ZChoice::automatic, model::TileBuild::lazy};
  result.z = model::ZMethod::fail;
  const Json json = to_json(result, model::DatapathKind::paper255);
  EXPECT_EQ(json["mode"], "three-pass");
  EXPECT_EQ(json["tile"], 32);
  EXPECT_EQ(json["cull"].dump(), R"({"penumbra":"sat","umbra":"none","accept":"zmin"})");
  EXPECT_EQ(json["share"], "all");
  EXPECT_EQ(json["z"], "fail") << "resolved, not `auto`";
  EXPECT_EQ(json["tile_build"], "lazy");
  EXPECT_EQ(json["datapath"], "paper255");
  EXPECT_EQ(json["timing"].dump(), R"({"seconds":0.25})");
}

TEST(Json, AResultHasItsTotalsAndTheFloorOfTheFrame) {
  model::CountResult result = make_result({}, 5, 3);
  result.counters->z_reads_min = 1;
  result.counters->wedge_bytes = 2;
  result.wrong_contributions = 7;
  const Json json = to_json(result, model::DatapathKind::exact);
  EXPECT_EQ(json["totals"].dump(), R"({"accesses":8,"accesses_floor":150,"all_bytes":12500})");
  EXPECT_EQ(json["wrong_contributions"], 7);
}

TEST(Json, APixelCheckIsToldWhole) {
  model::CountResult result = make_result({}, 5, 3);
  result.pixels = {6, 0.5, 0.25, 0.75, 3, 0.125, {}};
  EXPECT_EQ(to_json(result, model::DatapathKind::exact)["pixels"].dump(),
            R"({"compared":6,"max_error":0.5,"rms_error":0.25,"rms_penumbra":0.75,)"
            R"("mismatched":3,"tolerance":0.125,"worst":[]})");
}

TEST(Json, APixelCheckListsItsWorstPixels) {
  model::CountResult result = make_result({}, 5, 3);
  result.pixels.mismatched = 1;
  result.pixels.max_error = 0.5;
  result.pixels.worst = {{4, 1, 0.25, 0.75, 0.5, 0.125}};
  const Json pixels = to_json(result, model::DatapathKind::exact)["pixels"];
  EXPECT_EQ(pixels["mismatched"], 1);
  EXPECT_EQ(pixels["max_error"], 0.5);
  EXPECT_EQ(pixels["worst"].dump(),
            R"([{"x":4,"y":1,"expected":0.25,"li":0.75,"error":0.5,"sensitivity":0.125}])");
}

TEST(Json, AConfigurationHasEachValueOnce) {
  std::vector<model::CountConfig> configs;
  for (const model::Mode mode : {model::Mode::three_pass, model::Mode::single_pass}) {
    for (const unsigned tile : {4U, 8U}) configs.push_back({mode, tile});
  }
  const Json json = to_json(configs, model::DatapathKind::exact);
  EXPECT_EQ(json["mode"].dump(), R"(["three-pass","single-pass"])");
  EXPECT_EQ(json["tile"].dump(), "[4,8]");
  EXPECT_EQ(json["cull"].dump(), R"(["both"])");
  EXPECT_EQ(json["z"].dump(), R"(["auto"])");
}

TEST(Json, CountHasItsSchema) {
  std::vector<model::CountResult> results;
  results.push_back(make_result({}, 5, 3));
  const Json json = count_json({"x", 1, 3, 2, 7}, results, model::DatapathKind::exact,
                               std::array{model::WedgeFlag{5, model::FlagReason::light, 3.0}});
  EXPECT_EQ(json["flagged"].dump(), R"([{"wedge":5,"reason":"light","value":3.0}])");
  EXPECT_EQ(json["schema"], "wedgesim.count/1");
  EXPECT_EQ(json["configs"].size(), 1U);
  const TemporaryFolder folder;
  write_json(folder / "x.json", json);
  EXPECT_EQ(folder.entries(), 1U);
}

}  // namespace
}  // namespace wedgesim::reports

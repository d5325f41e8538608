// Does the block, which walks tiles on its own, access what the counter counts and leave the words
// that the counter's fixed datapath leaves?
#include "model/units/tile_work.h"

#include <gtest/gtest.h>

#include "model/count/count.h"
#include "model/units/frame_walk.h"
#include "tests/support/render.h"

namespace wedgesim::model::units {
namespace {

traces::Trace render(const std::string& scene, traces::fb::WedgeKind kind,
                     functional::LightShape light) {
  return wedgesim::test::render(scene, kind, {150, 100}, light);
}

std::string label(const CountConfig& config) {
  std::string text(spelling(config.mode));
  for (const std::string_view part :
       {spelling(config.cull), spelling(config.umbra_cull), spelling(config.accept),
        spelling(config.share), spelling(config.z), spelling(config.tile_build)}) {
    text += " " + std::string(part);
  }
  return text + " tile " + std::to_string(config.tile);
}

void expect_equal(const traces::TraceView& trace, const std::vector<CountConfig>& configs,
                  const datapath::Formats& formats = {}) {
  CountOptions options;
  options.datapath = DatapathKind::fixed;
  options.datapath.formats = formats;
  options.maps = true;
  const std::vector<CountResult> counted = count(trace, configs, options);
  for (const CountResult& expected : counted) {
    FrameWalk walk(trace, expected.config, expected.z == ZMethod::fail, options.datapath.formats);
    while (walk.next() != nullptr) {
    }
    const TileDatapath& block = walk.datapath();
    for (std::size_t i = 0; i < block.counters().counters().size(); ++i) {
      const Counter& counter = *block.counters().counters()[i];
      EXPECT_EQ(counter.value(), expected.counters->counters()[i]->value())
          << counter.name() << ": " << label(expected.config);
    }
    const datapath::LiWord& li = options.datapath.formats.li;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.li.size(); ++i) {
      wrong += li.wrap(expected.li[i]) == block.li()[i] ? 0 : 1;
    }
    EXPECT_EQ(block.first_overflow(), expected.first_overflow) << label(expected.config);
    EXPECT_EQ(wrong, 0U) << "LI words: " << label(expected.config);
    if (testing::Test::HasFailure()) return;
  }
}

std::vector<CountConfig> all_configs(ZChoice z) {
  std::vector<CountConfig> configs;
  for (const unsigned tile : {2U, 4U, 8U, 16U, 64U, 256U}) {
    for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
      for (const Cull cull :
           {Cull::none, Cull::zmax, Cull::zrange, Cull::planes, Cull::both, Cull::sat}) {
        CountConfig config;
        config.tile = tile;
        config.mode = mode;
        config.cull = cull;
        config.z = z;
        configs.push_back(config);
        config.umbra_cull = UmbraCull::none;
        config.accept = Accept::zmin;
        config.tile_build = TileBuild::lazy;
        config.share = Share::all;
        configs.push_back(config);
        config.umbra_cull = UmbraCull::zmax;
        configs.push_back(config);
      }
    }
  }
  return configs;
}

TEST(TileWork, EqualsTheCounterInEveryConfiguration) {
  for (const auto& [kind, light] :
       {std::pair{traces::fb::WedgeKind_linear, functional::LightShape::rectangle},
        std::pair{traces::fb::WedgeKind_coverage, functional::LightShape::rectangle},
        std::pair{traces::fb::WedgeKind_coverage, functional::LightShape::sphere}}) {
    const traces::Trace pass = render("plain-columns", kind, light);
    expect_equal(pass.view(), all_configs(ZChoice::pass));
    if (HasFailure()) return;
    expect_equal(pass.view(), all_configs(ZChoice::fail));
    if (HasFailure()) return;
    const traces::Trace shadow = render("eye-in-shadow", kind, light);
    expect_equal(shadow.view(), all_configs(ZChoice::automatic));
    if (HasFailure()) return;
  }
}

// Thin letters in few pixels: wedges whose faces cover no pixel but whose umbra polygon does.
TEST(TileWork, EqualsTheCounterWhereWedgesAreThin) {
  for (const auto& size : {std::pair{96, 64}, std::pair{8, 8}}) {
    const traces::Trace thin =
        wedgesim::test::render("text2002", traces::fb::WedgeKind_linear, size);
    std::vector<CountConfig> configs(2);
    configs[1].mode = Mode::three_pass;
    expect_equal(thin.view(), configs);
  }
}

// An LI word of 48 bits, and one so narrow that it wraps.
TEST(TileWork, EqualsTheCounterInWordsOfOtherWidths) {
  const traces::Trace trace =
      render("columns", traces::fb::WedgeKind_coverage, functional::LightShape::rectangle);
  std::vector<CountConfig> configs(2);
  configs[1].mode = Mode::three_pass;
  for (const datapath::LiWord li : {datapath::LiWord{24, 24}, datapath::LiWord{2, 4}}) {
    datapath::Formats formats;
    formats.li = li;
    expect_equal(trace.view(), configs, formats);
  }
}

}  // namespace
}  // namespace wedgesim::model::units

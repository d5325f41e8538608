#include "reports/runner/study_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "reports/runner/value.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::reports {
namespace {

constexpr const char* kFrames = "[frames]\nscene = \"cylinder\"\n";

Study parse(const std::string& text) { return parse_study(text, "s", "s.toml"); }

std::string error_of(const std::string& text) {
  return input_error_of([&text] { parse(text); });
}

std::vector<std::string> column(const Study& study, const std::string& key) {
  std::vector<std::string> values;
  for (const Configuration& configuration : study.configurations) {
    values.push_back(to_text(find_value(configuration.values, key)));
  }
  return values;
}

TEST(StudyFile, ABlockIsEveryCombinationOfItsLists) {
  const Study study = parse(std::string(kFrames) +
                            "[configuration]\nblock.cull = \"sat\"\n"
                            "[[grid]]\nblock.tile = [4, 16]\nblock.mode = [\"three-pass\", "
                            "\"single-pass\"]\n");
  EXPECT_EQ(column(study, "block.tile"), (std::vector<std::string>{"4", "4", "16", "16"}));
  EXPECT_EQ(column(study, "block.mode")[1], "single-pass");
  EXPECT_EQ(column(study, "block.cull")[3], "sat");
  EXPECT_EQ(study.head.axes, (std::vector<std::string>{"block.tile", "block.mode"}));
  EXPECT_EQ(study.points(), 4U);
}

TEST(StudyFile, AListGoesPointByPoint) {
  const Study study = parse(std::string(kFrames) +
                            "[[list]]\nblock.mode = \"three-pass\"\nblock.tile = [4, 16]\n"
                            "block.cull = [\"none\", \"sat\"]\n");
  EXPECT_EQ(column(study, "block.tile"), (std::vector<std::string>{"4", "16"}));
  EXPECT_EQ(column(study, "block.cull"), (std::vector<std::string>{"none", "sat"}));
  EXPECT_NE(error_of(std::string(kFrames) + "[[list]]\nblock.tile = [4, 16]\n"
                                            "block.cull = [\"none\", \"sat\", \"both\"]\n")
                .find("s.toml:5: 'block.cull' has 3 values, 'block.tile' 2"),
            std::string::npos);
}

TEST(StudyFile, ARandomSampleIsItsSeeds) {
  const std::string text = "measure = \"cycles\"\n" + std::string(kFrames) +
                           "[[random]]\ncount = 20\nseed = 5\n"
                           "penumbra.lanes = {low = 1, high = 16, log2 = true}\n"
                           "z_read.outstanding = {low = 10, high = 50, step = 10}\n";
  const Study study = parse(text);
  EXPECT_EQ(study.configurations.size(), 20U);
  EXPECT_EQ(column(study, "penumbra.lanes"), column(parse(text), "penumbra.lanes"));
  std::string other = text;
  other.replace(other.find("seed = 5"), 8, "seed = 6");
  EXPECT_NE(column(study, "penumbra.lanes"), column(parse(other), "penumbra.lanes"));
  std::set<std::string> keys;
  for (const Configuration& configuration : study.configurations) {
    keys.insert(point_key(configuration, 0));
    const double lanes = *number_of(find_value(configuration.values, "penumbra.lanes"));
    EXPECT_TRUE(lanes == 1 || lanes == 2 || lanes == 4 || lanes == 8 || lanes == 16) << lanes;
    const double lines = *number_of(find_value(configuration.values, "z_read.outstanding"));
    EXPECT_EQ(static_cast<int>(lines) % 10, 0) << lines;
  }
  EXPECT_EQ(keys.size(), 20U) << "all different";
  EXPECT_NE(error_of(text + "[[random]]\ncount = 3\nseed = 1\npenumbra.lanes = [1, 2]\n")
                .find("3 different points are asked for; expected at most 2"),
            std::string::npos);
}

TEST(StudyFile, EqualPointsAreOne) {
  const Study study = parse(std::string(kFrames) +
                            "[[grid]]\nblock.tile = [4, 8]\n[[grid]]\nblock.tile = [8, 16]\n");
  EXPECT_EQ(column(study, "block.tile"), (std::vector<std::string>{"4", "8", "16"}));
}

TEST(StudyFile, PresetsAndDatapathsAreAxesToo) {
  const Study timed = parse("measure = \"cycles\"\n" + std::string(kFrames) +
                            "[[grid]]\npreset = [\"small\", \"wide\"]\n");
  EXPECT_EQ(column(timed, "penumbra.lanes"), (std::vector<std::string>{"1", "16"}));
  EXPECT_EQ(column(timed, "memory.kind"), (std::vector<std::string>{"dram", "dram"}));
  EXPECT_EQ(timed.head.axes, std::vector<std::string>{"preset"});
  const Study counted =
      parse(std::string(kFrames) + "[[grid]]\ndatapath = [\"exact\", \"paper255\"]\n");
  EXPECT_EQ(counted.configurations[1].datapath, model::DatapathKind::paper255);
  EXPECT_EQ(error_of(std::string("datapath = \"fixed\"\n") + kFrames +
                     "[[grid]]\nformats.li_fraction_bits = [8, 11]\n"),
            "");
}

TEST(StudyFile, FramesAreScenesTimesTheirOptions) {
  const Study study = parse(
      "[frames]\nscene = [\"cylinder\", \"fractal\"]\nframe = [3, \"10-20:5\"]\n"
      "size = [\"32x24\", \"64x48\"]\nlight_scale = 0.5\nkind = \"linear\"\n");
  ASSERT_EQ(study.frames.size(), 16U);
  EXPECT_EQ(study.frames[1].row.label, "cylinder-f3-64x48");
  EXPECT_EQ(study.frames[8].row.label, "fractal-f3-32x24");
  EXPECT_EQ(study.frames[6].scene.frame, 20);
  EXPECT_EQ(study.frames[1].scene.size, std::pair(64, 48));
  EXPECT_EQ(study.frames[1].scene.light_scale, 0.5);
  EXPECT_EQ(study.frames[1].options.kind, traces::fb::WedgeKind_linear);
  EXPECT_EQ(to_text(find_value(study.frames[1].row.parameters, "width")), "64");
  std::set<std::string> keys;
  for (const FrameSpec& frame : study.frames) keys.insert(frame.row.key);
  EXPECT_EQ(keys.size(), 16U);
}

TEST(StudyFile, SeveralTablesOfFramesFollowEachOther) {
  const Study study = parse(
      "by = [\"field_side\", \"wedges\"]\n"
      "[[frames]]\nscene = \"cylinder\"\n[[frames]]\nscene = \"boxes\"\nfield_side = [2, 9]\n");
  ASSERT_EQ(study.frames.size(), 3U);
  EXPECT_EQ(study.frames[2].row.label, "boxes-n9");
  EXPECT_EQ(study.frames[2].scene.field_side, 9);
  EXPECT_EQ(study.frames[0].scene.field_side, std::nullopt);
}

TEST(StudyFile, AFrameIsKnownByWhatItIsMadeFrom) {
  const TemporaryFolder folder;
  const std::string scene =
      "description = \"x\"\n[camera]\neye = [0.0, 3.0, 5.0]\ntarget = [0.0, 0.0, 0.0]\n"
      "[light]\nshape = \"point\"\ncentre = [0.0, 9.0, 0.0]\n"
      "[[object]]\nshape = \"mesh\"\nfile = \"m.obj\"\n";
  const auto key = [&](const std::string& text, const std::string& mesh) {
    std::ofstream(folder / "x.toml") << text;
    std::ofstream(folder / "m.obj") << mesh;
    return parse_study("[frames]\nscene = \"x.toml\"\n", "s", (folder / "s.toml").string())
        .frames.front()
        .row.key;
  };
  const std::string first = key(scene, "v 0 0 0\n");
  EXPECT_EQ(key(scene, "v 0 0 0\n"), first);
  EXPECT_NE(key(scene, "v 0 0 1\n"), first);
  EXPECT_NE(key(scene + "\n", "v 0 0 0\n"), first);
}

struct BadStudy {
  const char* text;
  const char* error;
};

class BadStudies : public testing::TestWithParam<BadStudy> {};

TEST_P(BadStudies, AreRefusedAtTheirLine) {
  const std::string error = error_of(GetParam().text);
  EXPECT_EQ(error.find(GetParam().error), 0U) << error;
}

#define FRAMES "[frames]\nscene = \"cylinder\"\n"
INSTANTIATE_TEST_SUITE_P(
    StudyFile, BadStudies,
    testing::Values(
        BadStudy{"measure = \"taste\"\n" FRAMES, "s.toml:1: 'measure' is 'taste'"},
        BadStudy{"title = \"x\"\n", "s.toml:1: 'frames' is missing"},
        BadStudy{"titel = \"x\"\n" FRAMES, "s.toml:1: unknown key 'titel'"},
        BadStudy{"[frames]\nscene = \"nowhere\"\n", "nowhere: no such scene"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nframe = \"30-40\"\n",
                 "s.toml:3: 'cylinder' has no frame 32"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nframe = \"5-\"\n", "s.toml:3: 'frame' is '5-'"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nsize = \"9\"\n", "s.toml:3: 'size' is '9'"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nkind = \"round\"\n",
                 "s.toml:3: 'kind' is 'round'; expected one of coverage, linear"},
        BadStudy{"[frames]\nscene = [\"cylinder\", \"cylinder\"]\n",
                 "s.toml:2: 'scene' names a value twice"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nfield_side = 3\n",
                 "s.toml:3: 'field_side' is set, but cylinder has no field"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nframe = \"0-1000000000:1\"\n",
                 "s.toml:3: 'frame' has too many frames in '0-1000000000:1'; expected at most"},
        BadStudy{"[frames]\nscene = \"cylinder\"\nframe = [\"0-99999\", \"100000-2147483647:7\"]\n",
                 "s.toml:3: 'frame' has too many frames in '100000-2147483647:7'"},
        BadStudy{"frames = 3\n", "s.toml:1: 'frames' is no table"},
        BadStudy{"[frames]\nsceen = \"cylinder\"\n", "s.toml:2: unknown key 'sceen'"},
        BadStudy{FRAMES "[[grid]]\nblock.tile = [4, 7]\n",
                 "s.toml:4: block.tile: 'tile' 7 is no power of two"},
        BadStudy{FRAMES "[[grid]]\nblock.tile = [4, 4]\n",
                 "s.toml:4: 'block.tile' names a value twice"},
        BadStudy{FRAMES "[[grid]]\nblock.tiles = 4\n", "s.toml:4: block.tiles: unknown key"},
        BadStudy{FRAMES "[[grid]]\nblok.tile = 4\n", "s.toml:4: blok.tile: unknown key 'blok'"},
        BadStudy{FRAMES "[configuration]\npenumbra.lanes = 17\n",
                 "s.toml:4: penumbra.lanes: 'lanes' is 17; expected an integer from 1 to 16"},
        BadStudy{FRAMES "[configuration]\nblock.tile = [4, 8]\n",
                 "s.toml:4: 'block.tile' has several values"},
        BadStudy{FRAMES "[[grid]]\npenumbra.lanes = [1, 2]\n",
                 "s.toml:4: penumbra.lanes: has no effect on what 'count' measures"},
        BadStudy{FRAMES "[[grid]]\nmeasure = \"cycles\"\nz_read.cache_bytes = 64\n"
                        "z_read.cache_ways = [1, 2]\n",
                 "s.toml:"},
        BadStudy{"metrics = [\"z_reeds\"]\n" FRAMES, "s.toml:1: 'metrics' names 'z_reeds'"},
        BadStudy{"by = \"weather\"\n" FRAMES, "s.toml:1: 'by' names 'weather'"},
        BadStudy{FRAMES "[[plot]]\nkind = \"pie\"\ntitle = \"\"\nx = \"frame\"\ny = \"z_reads\"\n",
                 "s.toml:4: 'kind' is 'pie'"},
        BadStudy{FRAMES "[[plot]]\nkind = \"bar\"\ntitle = \"\"\nx = \"frame\"\ny = \"cycles\"\n",
                 "s.toml:7: 'y' is 'cycles'"}));
#undef FRAMES

TEST(StudyFile, EveryBuiltInStudyIsGood) {
  ASSERT_FALSE(built_in_studies().empty());
  for (const BuiltInStudy& study : built_in_studies()) {
    EXPECT_EQ(input_error_of([&study] { read_study(std::string(study.name)); }), "");
  }
  EXPECT_NE(input_error_of([] { read_study("paper9"); }).find("paper9: no such study"),
            std::string::npos);
}

TEST(StudyFile, Paper2CoversWhatPaper2Asks) {
  const Study study = read_study("paper2");
  EXPECT_EQ(study.frames.size(), 5U);
  EXPECT_EQ(study.configurations.size(), 240U);
  const auto has = [&study](const model::CountConfig& config) {
    return std::ranges::count_if(study.configurations, [&config](const Configuration& found) {
             return found.block.rasterizer == config;
           }) == 1;
  };
  for (const model::Mode mode : {model::Mode::three_pass, model::Mode::single_pass}) {
    for (unsigned tile = 2; tile <= 256; tile *= 2) {
      for (const model::Cull cull : {model::Cull::none, model::Cull::zmax, model::Cull::zrange,
                                     model::Cull::planes, model::Cull::both, model::Cull::sat}) {
        EXPECT_TRUE(has({mode, tile, cull}));
        EXPECT_TRUE(has({mode, tile, cull, model::UmbraCull::none}));
      }
      EXPECT_TRUE(
          has({mode, tile, model::Cull::both, model::UmbraCull::zmax, model::Accept::zmin}));
    }
  }
}

}  // namespace
}  // namespace wedgesim::reports

// Do heat maps show the accesses that are counted, in the page and in the files beside it?
#include "reports/page/heat_maps.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/image.h"
#include "tests/base/temporary_folder.h"

namespace wedgesim::reports::page {
namespace {

// The frame worked out by hand (invariants/hand_worked_test.cpp), both modes, tiles of 4 and 8.
Results hand_worked(const std::filesystem::path& folder) {
  std::filesystem::copy_file(
      std::filesystem::path(WEDGESIM_SOURCE_DIR) / "traces/samples/hand-worked.wtrace",
      folder / "hand-worked.wtrace");
  Results results;
  results.study.axes = {"block.mode", "block.tile"};
  FrameRow frame;
  frame.label = frame.scene = "hand-worked";
  frame.parameters = {{"width", std::int64_t{16}}, {"height", std::int64_t{16}}};
  results.frames.push_back(frame);
  for (const char* mode : {"three-pass", "single-pass"}) {
    for (const std::int64_t tile : {4, 8}) {
      PointRow point;
      point.frame = frame.label;
      point.measure = "count";
      point.configuration = {{"block.mode", std::string(mode)}, {"block.tile", tile}};
      for (const auto& [key, word] : {std::pair("block.cull", "both"),
                                      {"block.umbra_cull", "zmax"},
                                      {"block.accept", "none"},
                                      {"block.share", "eye"},
                                      {"block.z", "auto"}}) {
        point.configuration[key] = std::string(word);
      }
      point.metrics["z_reads"] = std::int64_t{1};
      results.points.push_back(point);
    }
  }
  return results;
}

const HeatMap& find(const Page& page, const std::string& mode, unsigned tile,
                    const std::string& kind) {
  for (const HeatMap& map : page.maps) {
    if (map.mode == mode && map.tile == tile && map.kind == kind) return map;
  }
  throw std::out_of_range(mode + kind);
}

TEST(HeatMaps, ShowWhatIsCounted) {
  const TemporaryFolder folder;
  const Results results = hand_worked(folder.path());
  Page page{results, {}, {}, {}, {}};
  add_heat_maps(Columns(results), folder.path(), page);
  ASSERT_EQ(page.maps.size(), 8U);
  EXPECT_EQ(find(page, "three-pass", 8, "z reads").total, 191.0);
  EXPECT_EQ(find(page, "three-pass", 4, "z reads").total, 155.0);
  EXPECT_EQ(find(page, "single-pass", 4, "z reads").total, 124.0);
  EXPECT_EQ(find(page, "single-pass", 8, "LI writes").total, 82.0);
  EXPECT_EQ(find(page, "three-pass", 8, "LI writes").maximum, 4.0);  // contributions_max
}

TEST(HeatMaps, FilesHoldAllValues) {
  const TemporaryFolder folder;
  const Results results = hand_worked(folder.path());
  Page page{results, {}, {}, {}, {}};
  add_heat_maps(Columns(results), folder.path(), page);
  const auto file = folder.path() / find(page, "three-pass", 8, "z reads").file;
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
  const Image image = read_image(std::filesystem::path(file).replace_extension(".exr"));
  EXPECT_EQ(image.width, 16);
  EXPECT_EQ(std::accumulate(image.values.begin(), image.values.end(), 0.0F), 191.0F);
  // What no tile size changes is written once.
  EXPECT_EQ(find(page, "three-pass", 4, "LI writes").file,
            find(page, "three-pass", 8, "LI writes").file);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry :
       std::filesystem::directory_iterator(folder.path() / "maps")) {
    ++files;
  }
  EXPECT_EQ(files, 2U * (4U + 2U));
}

TEST(HeatMaps, NoneWithoutTraces) {
  const TemporaryFolder folder;
  const Results results = hand_worked(folder.path());
  std::filesystem::remove(folder.path() / "hand-worked.wtrace");
  Page page{results, {}, {}, {}, {}};
  add_heat_maps(Columns(results), folder.path(), page);
  EXPECT_TRUE(page.maps.empty());
}

}  // namespace
}  // namespace wedgesim::reports::page

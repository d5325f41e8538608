#include "reports/picture.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "reports/map_files.h"
#include "reports/maps.h"
#include "tests/base/temporary_folder.h"
#include "tests/reports/results.h"
#include "tests/traces/sample.h"

namespace wedgesim::reports {
namespace {

float luminance(const Image& image, int x) {
  const float* p = image.pixel(x, 0);
  return 0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2];
}

TEST(Picture, HeatIsBrighterWhereThereIsMore) {
  const TemporaryFolder folder;
  const std::vector<float> values{0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 9.0F};
  write_heat(folder / "x.png", values, 6, 1, 4.0F);
  const Image image = read_image(folder / "x.png");
  ASSERT_EQ(image.channels, 3);
  EXPECT_LT(luminance(image, 0), 0.02F);
  for (int x = 1; x < 5; ++x) EXPECT_GT(luminance(image, x), luminance(image, x - 1)) << x;
  EXPECT_GT(luminance(image, 4), 0.9F);
  EXPECT_EQ(luminance(image, 5), luminance(image, 4)) << "beyond the scale";
}

TEST(Picture, ExrHoldsTheValues) {
  const TemporaryFolder folder;
  const std::vector<float> values{0.0F, -0.25F, 7.5F, 1.0F};
  write_heat(folder / "h.exr", values, 2, 2, 4.0F);
  EXPECT_EQ(read_image(folder / "h.exr").values, values);
  write_values(folder / "v.exr", values, 2, 2);
  EXPECT_EQ(read_image(folder / "v.exr").values, values);
}

TEST(Picture, ColoursFollowTheSrgbCurveInPngAlone) {
  const TemporaryFolder folder;
  Image linear(1, 1, 3);
  linear.values = {0.0F, 0.2140411F, 1.0F};  // 0.2140411 linear is 0.5 encoded
  write_colours(folder / "x.png", linear);
  write_colours(folder / "x.exr", linear);
  const Image png = read_image(folder / "x.png");
  EXPECT_NEAR(png.values[1], 0.5F, 0.003F);
  EXPECT_EQ(png.values[2], 1.0F);
  EXPECT_EQ(read_image(folder / "x.exr").values, linear.values);
}

TEST(Picture, OtherNamesAreRefusedBeforeTheWork) {
  EXPECT_NO_THROW(require_image_name("a/b.png"));
  EXPECT_NO_THROW(require_image_name("b.exr"));
  EXPECT_THROW(require_image_name("b.jpg"), InputError);
  EXPECT_THROW(require_image_name("png"), InputError);
}

TEST(Maps, AreWrittenWithTheirScales) {
  const TemporaryFolder folder;
  traces::Trace trace = traces::sample_trace();
  const std::size_t pixels = trace.depth.size();
  trace.expected_li.assign(pixels, 1.0);
  model::CountResult result = make_result({}, 5, 3);
  result.z_reads.assign(pixels, 2);
  result.z_reads[1] = 7;
  result.li_writes.assign(pixels, 0);
  result.li.assign(pixels, std::int64_t{1} << 40);
  result.li[2] = std::int64_t{1} << 39;
  const MapScales scales =
      write_maps((folder / "p").string(), trace.view(), result, model::DatapathKind::exact);
  EXPECT_EQ(scales.z_reads, 7.0F);
  EXPECT_EQ(scales.li_writes, 1.0F) << "an empty map still has a scale";
  EXPECT_EQ(scales.difference, 0.5F);
  EXPECT_EQ(folder.entries(), 8U);
  const auto files = map_files((folder / "p").string());
  EXPECT_EQ(files.size(), 8U);
  for (const auto& file : files) EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(read_image(folder / "p_z_reads.exr").values[1], 7.0F);
  EXPECT_EQ(read_image(folder / "p_li.exr").values[2], 0.5F);
  EXPECT_EQ(read_image(folder / "p_difference.exr").values[2], 0.5F);
  EXPECT_EQ(read_image(folder / "p_difference.exr").values[1], 0.0F);
}

TEST(Maps, WithoutExpectedLightThereIsNoDifference) {
  const TemporaryFolder folder;
  traces::Trace trace = traces::sample_trace();
  trace.expected_li.clear();
  const std::size_t pixels = trace.depth.size();
  model::CountResult result = make_result({}, 5, 3);
  result.z_reads.assign(pixels, 2);
  result.li_writes.assign(pixels, 1);
  result.li.assign(pixels, 0);
  write_maps((folder / "p").string(), trace.view(), result, model::DatapathKind::exact);
  EXPECT_EQ(folder.entries(), 6U);
}

}  // namespace
}  // namespace wedgesim::reports

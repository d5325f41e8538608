#include "base/image.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "tests/base/temporary_folder.h"

namespace wedgesim {
namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Every pixel and channel its own value, the awkward floats among them.
Image awkward_image(int channels) {
  Image image(13, 7, channels);
  float value = 1e-30f;
  for (float& v : image.values) v = value *= -1.37f;
  image.values[0] = 0.0f;
  image.values[1] = -0.0f;
  image.values[2] = std::numeric_limits<float>::denorm_min();
  image.values[3] = std::numeric_limits<float>::max();
  image.values[4] = std::numeric_limits<float>::infinity();
  return image;
}

void expect_same_bits(const Image& a, const Image& b) {
  ASSERT_EQ(a.width, b.width);
  ASSERT_EQ(a.height, b.height);
  ASSERT_EQ(a.channels, b.channels);
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(a.values[i]), std::bit_cast<std::uint32_t>(b.values[i]))
        << "value " << i;
  }
}

TEST(Image, StoresRowsFromTheTop) {
  Image image(3, 2, 2);
  image.pixel(1, 1)[1] = 5.0f;
  EXPECT_EQ(image.values[(1 * 3 + 1) * 2 + 1], 5.0f);
}

TEST(Exr, KeepsEveryBit) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3, 7}) {
    const Image image = awkward_image(channels);
    write_image(folder / "x.exr", image);
    expect_same_bits(read_image(folder / "x.exr"), image);
  }
}

TEST(Exr, NamesItsChannels) {
  const TemporaryFolder folder;
  write_image(folder / "x.exr", awkward_image(2), {"li", "z_reads"});
  const std::string bytes = content(folder / "x.exr");
  EXPECT_NE(bytes.find("z_reads"), std::string::npos);
}

TEST(Png, KeepsAllByteValues) {
  const TemporaryFolder folder;
  for (const int channels : {1, 3}) {
    Image image(16, 16, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      image.values[i] = static_cast<float>(i % 256) / 255.0f;
    }
    write_image(folder / "x.png", image);
    const Image back = read_image(folder / "x.png");
    ASSERT_EQ(back.values.size(), image.values.size());
    for (std::size_t i = 0; i < back.values.size(); ++i) {
      ASSERT_EQ(std::lround(back.values[i] * 255.0f), static_cast<long>(i % 256)) << "value " << i;
    }
  }
}

TEST(Png, ClampsAndRoundsToTheNearest) {
  const TemporaryFolder folder;
  Image image(4, 1, 1);
  image.values = {-3.0f, 2.0f, 100.4f / 255.0f, 100.6f / 255.0f};
  write_image(folder / "x.png", image);
  const Image back = read_image(folder / "x.png");
  EXPECT_EQ(back.values[0], 0.0f);
  EXPECT_EQ(back.values[1], 1.0f);
  EXPECT_EQ(std::lround(back.values[2] * 255.0f), 100);
  EXPECT_EQ(std::lround(back.values[3] * 255.0f), 101);
}

TEST(WriteImage, GivesTheSameBytesAgain) {
  const TemporaryFolder folder;
  const Image image = awkward_image(3);
  for (const std::string extension : {".png", ".exr"}) {
    write_image(folder / ("a" + extension), image);
    write_image(folder / ("b" + extension), image);
    const std::string bytes = content(folder / ("a" + extension));
    EXPECT_FALSE(bytes.empty());
    EXPECT_TRUE(bytes == content(folder / ("b" + extension))) << extension;
  }
}

TEST(Exr, HoldsNoTimeOfWriting) {
  // Two writes within one second would hide a clock in the file.
  const TemporaryFolder folder;
  write_image(folder / "x.exr", awkward_image(1));
  EXPECT_NE(content(folder / "x.exr").find("2000:01:01 00:00:00"), std::string::npos);
}

TEST(WriteImage, RefusesOtherFormats) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_image(folder / "x.jpg", Image(2, 2, 3)), InputError);
  EXPECT_THROW(write_image(folder / "x", Image(2, 2, 3)), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteImage, FailureLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_image(folder / "x.png", Image(0, 0, 3)), InputError);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(ReadImage, RefusesWhatIsNoImage) {
  const TemporaryFolder folder;
  write_file(folder / "x.png", std::string_view("no image at all"));
  EXPECT_THROW(read_image(folder / "x.png"), InputError);
  EXPECT_THROW(read_image(folder / "missing.exr"), InputError);
}

TEST(ReadImage, RefusesATruncatedFile) {
  const TemporaryFolder folder;
  for (const std::string extension : {".png", ".exr"}) {
    write_image(folder / ("x" + extension), awkward_image(3));
    const std::string bytes = content(folder / ("x" + extension));
    write_file(folder / ("x" + extension), std::string_view(bytes).substr(0, bytes.size() / 2));
    EXPECT_THROW(read_image(folder / ("x" + extension)), InputError) << extension;
  }
}

}  // namespace
}  // namespace wedgesim

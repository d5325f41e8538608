// Are pictures made smaller by means, and grey ones stored as grey?
#include "reports/page/small_picture.h"

#include <gtest/gtest.h>

#include "tests/base/temporary_folder.h"

namespace wedgesim::reports::page {
namespace {

TEST(SmallPicture, HasTheMeanOfEachSquare) {
  Image image(5, 2, 1);
  image.values = {0, 2, 4, 6, 8, 2, 4, 6, 8, 10};
  const Image small = reduced(image, 3);
  EXPECT_EQ(small.width, 3);
  EXPECT_EQ(small.height, 1);
  EXPECT_EQ(small.values, (std::vector<float>{2, 6, 9}));  // the last is one pixel wide
  EXPECT_EQ(reduced(image, 5).values, image.values);
}

TEST(SmallPicture, GreyHasOneChannel) {
  const TemporaryFolder folder;
  Image image(2, 1, 3);
  image.values = {0.2F, 0.2F, 0.2F, 0.6F, 0.6F, 0.6F};
  const auto channels = [&] {
    const std::string bytes = png_of(image, folder / "scratch.png");
    EXPECT_FALSE(std::filesystem::exists(folder / "scratch.png"));
    std::ofstream(folder / "copy.png", std::ios::binary) << bytes;
    const Image read = read_image(folder / "copy.png");
    EXPECT_NEAR(read.pixel(1, 0)[0], 0.6F, 0.5F / 255.0F);
    return read.channels;
  };
  EXPECT_EQ(channels(), 1);
  image.values[5] = 0.5F;
  EXPECT_EQ(channels(), 3);
}

}  // namespace
}  // namespace wedgesim::reports::page

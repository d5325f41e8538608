#include "traces/depth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wedgesim::traces {
namespace {

constexpr fb::DepthFormat kFormats[] = {fb::DepthFormat_unorm24, fb::DepthFormat_float32,
                                        fb::DepthFormat_unorm16, fb::DepthFormat_float32_reversed};

TEST(Depth, Ends) {
  for (const fb::DepthFormat format : kFormats) {
    EXPECT_EQ(decode_depth(format, encode_depth(format, 0.0)), 0.0) << format;
    EXPECT_EQ(decode_depth(format, encode_depth(format, 1.0)), 1.0) << format;
    EXPECT_EQ(decode_depth(format, sky_word(format)), 1.0) << format;
    EXPECT_EQ(encode_depth(format, -3.0), encode_depth(format, 0.0)) << format;
    EXPECT_EQ(encode_depth(format, 1.5), encode_depth(format, 1.0)) << format;
  }
}

TEST(Depth, Words) {
  EXPECT_EQ(sky_word(fb::DepthFormat_unorm24), 0xffffffU);
  EXPECT_EQ(sky_word(fb::DepthFormat_unorm16), 0xffffU);
  EXPECT_EQ(sky_word(fb::DepthFormat_float32), 0x3f800000U);
  EXPECT_EQ(sky_word(fb::DepthFormat_float32_reversed), 0U);
  EXPECT_EQ(encode_depth(fb::DepthFormat_unorm16, 1.0 / 65535.0), 1U);
  // Rounded to nearest, not down.
  EXPECT_EQ(encode_depth(fb::DepthFormat_unorm16, 1.6 / 65535.0), 2U);
  EXPECT_EQ(encode_depth(fb::DepthFormat_unorm24, 7.4 / 16777215.0), 7U);
}

// A stored word comes back, and no depth moves by more than half a step.
TEST(Depth, NearestWord) {
  constexpr std::uint64_t kSeed = 24;
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 100000; ++i) {
    const double z = static_cast<double>(random() >> 11) * 0x1p-53;
    for (const fb::DepthFormat format : kFormats) {
      const std::uint32_t word = encode_depth(format, z);
      const double stored = decode_depth(format, word);
      ASSERT_EQ(encode_depth(format, stored), word) << "seed " << kSeed << ' ' << format;
      const double step = format == fb::DepthFormat_unorm16 ? 1.0 / 65535.0 : 1.0 / 16777215.0;
      ASSERT_LE(std::abs(stored - z), 0.5000001 * step) << "seed " << kSeed << ' ' << format;
    }
  }
}

}  // namespace
}  // namespace wedgesim::traces

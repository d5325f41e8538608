#include "functional/light/split_word.h"

#include <gtest/gtest.h>

namespace wedgesim::functional {
namespace {

TEST(SplitWord, HoldsThreeBitsAComponent) {
  const SplitWord word = SplitWord::pack(0b101'010'111'001);
  EXPECT_EQ(word.components, (std::array<std::uint8_t, 4>{5, 2, 7, 1}));
  for (int value = 0; value <= SplitWord::kWhole; ++value) {
    ASSERT_EQ(SplitWord::pack(value).unpack(), value);
  }
}

TEST(SplitWord, SumsAreExactUpTo36Words) {
  for (const int value : {1, 0777, 04321, SplitWord::kWhole}) {
    SplitWord sum;
    for (int i = 1; i <= 36; ++i) {
      sum.add(SplitWord::pack(value));
      ASSERT_EQ(sum.unpack(), i * value) << i;
    }
  }
}

TEST(SplitWord, OverflowStaysAtTheLargest) {
  SplitWord sum;
  for (int i = 0; i < 37; ++i) sum.add(SplitWord::pack(SplitWord::kWhole));
  EXPECT_EQ(sum.components, (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
  EXPECT_LT(sum.unpack(), 37 * SplitWord::kWhole);
  sum.add(SplitWord::pack(SplitWord::kWhole));
  EXPECT_EQ(sum.unpack(), 255 * (512 + 64 + 8 + 1));
}

TEST(ShortWord, HasSixBitsAndTwoToOverflow) {
  EXPECT_EQ(ShortWord::of(0.0F).component, 0);
  EXPECT_EQ(ShortWord::of(0.5F).component, 32);
  EXPECT_EQ(ShortWord::of(1.0F).component, 63);
  ShortWord sum;
  for (int i = 0; i < 4; ++i) sum.add(ShortWord::of(1.0F));
  EXPECT_EQ(sum.component, 252);
  sum.add(ShortWord::of(1.0F));
  EXPECT_EQ(sum.component, 255);
}

}  // namespace
}  // namespace wedgesim::functional

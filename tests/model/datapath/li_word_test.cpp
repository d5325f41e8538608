#include "model/datapath/li_word.h"

#include <gtest/gtest.h>

namespace wedgesim::model::datapath {
namespace {

TEST(LiWord, RoundsContributionsToNearestTiesToEven) {
  const LiWord word;  // S5_11
  EXPECT_EQ(word.bits(), 16);
  EXPECT_EQ(word.one(), 2048);
  EXPECT_EQ(word.of(0.5), 1024);
  EXPECT_EQ(word.of(0.5 / 2048), 0);
  EXPECT_EQ(word.of(1.5 / 2048), 2);
  EXPECT_EQ(word.of(-0.75 / 2048), -1);
}

TEST(LiWord, WrapsSoThatOrderDoesNotMatter) {
  const LiWord word;
  EXPECT_EQ(word.wrap(32767), 32767);
  EXPECT_EQ(word.wrap(32768), -32768);
  EXPECT_EQ(word.wrap(-32769), 32767);
  EXPECT_EQ(word.wrap(word.wrap(40000) - 20000), 20000);
  EXPECT_TRUE(word.holds(-32768));
  EXPECT_TRUE(word.holds(32767));
  EXPECT_FALSE(word.holds(32768));
  EXPECT_FALSE(word.holds(-32769));
  EXPECT_EQ((LiWord{2, 4}.wrap(32)), -32);
}

}  // namespace
}  // namespace wedgesim::model::datapath

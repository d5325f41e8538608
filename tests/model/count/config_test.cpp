#include "model/count/config.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace wedgesim::model {
namespace {

template <typename E>
void expect_round_trip() {
  for (std::size_t i = 0; i < kSpellings<E>.size(); ++i) {
    EXPECT_EQ(parse<E>("--option", spelling(static_cast<E>(i))), static_cast<E>(i));
  }
}

TEST(Config, EveryValueHasItsWord) {
  expect_round_trip<Mode>();
  expect_round_trip<Cull>();
  expect_round_trip<UmbraCull>();
  expect_round_trip<Accept>();
  expect_round_trip<Share>();
  expect_round_trip<ZChoice>();
  expect_round_trip<TileBuild>();
  expect_round_trip<DatapathKind>();
  EXPECT_EQ(spelling(Mode::three_pass), "three-pass");
  EXPECT_EQ(spelling(ZChoice::automatic), "auto");
  EXPECT_EQ(spelling(Cull::sat), "sat");
  EXPECT_EQ(spelling(TileBuild::none), "none");
}

TEST(Config, AnUnknownWordIsRefusedWithAllThatAreKnown) {
  try {
    parse<Accept>("--accept", "zmax");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--accept: unknown value 'zmax'; expected one of none, zmin");
  }
}

TEST(Config, TilesArePowersOfTwo) {
  EXPECT_EQ(parse_tile("--tile", "2"), 2u);
  EXPECT_EQ(parse_tile("--tile", "256"), 256u);
  for (const char* text : {"1", "3", "512", "0", "-8", "8x", "", " 8", "99999999999"}) {
    EXPECT_THROW(parse_tile("--tile", text), InputError) << text;
  }
  EXPECT_THROW(check({.tile = 12}), InputError);
  EXPECT_NO_THROW(check(CountConfig{}));
}

}  // namespace
}  // namespace wedgesim::model

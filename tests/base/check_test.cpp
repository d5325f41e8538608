#include "base/check.h"

#include <gtest/gtest.h>

#include <string>

namespace wedgesim {
namespace {

std::string message_of(void (*check)()) {
  try {
    check();
  } catch (const CheckError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Check, PassesWhatHolds) {
  EXPECT_NO_THROW(WEDGESIM_CHECK(1 < 2));
  EXPECT_NO_THROW(CHECK_EQ(2, 2));
  EXPECT_NO_THROW(CHECK_NE(1, 2));
  EXPECT_NO_THROW(CHECK_LT(1, 2));
  EXPECT_NO_THROW(CHECK_LE(2, 2));
  EXPECT_NO_THROW(CHECK_GT(2, 1));
  EXPECT_NO_THROW(CHECK_GE(2, 2));
}

TEST(Check, ThrowsAtWhatDoesNot) {
  EXPECT_THROW(WEDGESIM_CHECK(2 < 1), CheckError);
  EXPECT_THROW(CHECK_EQ(1, 2), CheckError);
  EXPECT_THROW(CHECK_NE(2, 2), CheckError);
  EXPECT_THROW(CHECK_LT(2, 2), CheckError);
  EXPECT_THROW(CHECK_LE(3, 2), CheckError);
  EXPECT_THROW(CHECK_GT(2, 2), CheckError);
  EXPECT_THROW(CHECK_GE(1, 2), CheckError);
}

TEST(Check, PrintsBothValuesAndThePlace) {
  const std::string text = message_of([] {
    const int tiles = 7;
    CHECK_LE(tiles, 3 + 1);
  });
  EXPECT_NE(text.find("check_test.cpp:"), std::string::npos) << text;
  EXPECT_NE(text.find("tiles <= 3 + 1 (7 against 4)"), std::string::npos) << text;
}

TEST(Check, PrintsBytesAsNumbers) {
  const std::string text = message_of([] {
    const unsigned char byte = 65;
    CHECK_EQ(byte, 0);
  });
  EXPECT_NE(text.find("(65 against 0)"), std::string::npos) << text;
}

TEST(Check, EvaluatesEachSideOnce) {
  int calls = 0;
  CHECK_EQ(++calls, 1);
  EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace wedgesim

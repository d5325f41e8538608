#include "model/datapath/rounder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

namespace wedgesim::model::datapath {
namespace {

__extension__ using Wide = __int128;

// A second way: significand and exponent in integers, shifted and rounded by hand.
double round_integer(Wide value, int exponent, int bits) {
  const bool negative = value < 0;
  Wide size = negative ? -value : value;
  int shift = 0;
  while (size >> shift >> bits != 0) ++shift;
  const Wide kept = size >> shift;
  const Wide rest = size - (kept << shift);
  const Wide half = shift > 0 ? Wide{1} << (shift - 1) : 0;
  const bool up = shift > 0 && (rest > half || (rest == half && (kept & 1) != 0));
  const double result = std::ldexp(
      static_cast<double>(static_cast<std::int64_t>(kept + (up ? 1 : 0))), exponent + shift);
  return negative ? -result : result;
}

class Operands {
 public:
  Operands(int bits, unsigned seed) : bits_(bits), random_(seed) {}
  struct Real {
    std::int64_t significand;
    int exponent;
    double value() const { return std::ldexp(static_cast<double>(significand), exponent); }
  };
  Real next(int spread) {
    const auto size = std::uniform_int_distribution<std::int64_t>(
        std::int64_t{1} << (bits_ - 1), (std::int64_t{1} << bits_) - 1)(random_);
    return {random_() % 2 == 0 ? size : -size,
            std::uniform_int_distribution<int>(-spread, spread)(random_)};
  }

 private:
  int bits_;
  std::mt19937 random_;
};

TEST(Rounder, RoundsToNearestTiesToEven) {
  const Rounder round(8);
  EXPECT_EQ(round(0.0), 0.0);
  EXPECT_EQ(round(255.0), 255.0);
  EXPECT_EQ(round(256.5), 256.0);
  EXPECT_EQ(round(257.0), 256.0);  // a tie, down to even
  EXPECT_EQ(round(259.0), 260.0);  // a tie, up to even
  EXPECT_EQ(round(257.001), 258.0);
  EXPECT_EQ(round(511.0), 512.0);
  EXPECT_EQ(round(-259.0), -260.0);
  EXPECT_EQ(round(std::ldexp(259.0, -900)), std::ldexp(260.0, -900));
}

TEST(Rounder, GivesWhatIntegerOperatorsGive) {
  const unsigned seed = 20020;
  std::cout << "seed " << seed << '\n';
  for (const int bits : {8, 14, 18, 25}) {
    const Rounder round(bits);
    Operands operands(bits, seed);
    for (int i = 0; i < 50000; ++i) {
      const auto a = operands.next(12);
      const auto b = operands.next(12);
      const Wide product = Wide{a.significand} * b.significand;
      ASSERT_EQ(round(a.value() * b.value()),
                round_integer(product, a.exponent + b.exponent, bits));
      const int low = std::min(a.exponent, b.exponent);
      const Wide sum =
          (Wide{a.significand} << (a.exponent - low)) + (Wide{b.significand} << (b.exponent - low));
      ASSERT_EQ(round(a.value() + b.value()), round_integer(sum, low, bits));
      // 60 more bits and whether anything is left: the quotient rounds as the exact one does.
      const Wide numerator = Wide{a.significand} << 60;
      const Wide quotient =
          2 * (numerator / b.significand) +
          (numerator % b.significand != 0 ? (a.significand < 0) != (b.significand < 0) ? -1 : 1
                                          : 0);
      ASSERT_EQ(round(a.value() / b.value()),
                round_integer(quotient, a.exponent - b.exponent - 61, bits));
    }
  }
}

TEST(Rounder, TakesIntegersThatNoDoubleHolds) {
  const unsigned seed = 7;
  std::cout << "seed " << seed << '\n';
  std::mt19937_64 random(seed);
  for (const int bits : {8, 18, 25}) {
    const Rounder round(bits);
    for (int i = 0; i < 200000; ++i) {
      const auto integer = static_cast<std::int64_t>(random()) >> (1 + random() % 62);
      ASSERT_EQ(round(integer, -7), round_integer(integer, -7, bits)) << integer;
    }
    // Just beside ties of 62-bit integers.
    const std::int64_t tie = (std::int64_t{1} << 61) + (std::int64_t{1} << (61 - bits));
    for (const std::int64_t integer : {tie - 1, tie, tie + 1, -tie - 1, -tie, -tie + 1}) {
      ASSERT_EQ(round(integer, 0), round_integer(integer, 0, bits)) << integer;
    }
  }
}

}  // namespace
}  // namespace wedgesim::model::datapath

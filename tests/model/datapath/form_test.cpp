#include "model/datapath/form.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <iostream>
#include <random>

#include "model/datapath/inside_test.h"
#include "tests/support/expect_input_error.h"
#include "traces/depth.h"

namespace wedgesim::model::datapath {
namespace {

using traces::fb::DepthFormat;
__extension__ using Wide = __int128;

LinearForm random_form(std::mt19937& random) {
  std::uniform_real_distribution<double> sign(-1.0, 1.0);
  const auto size = [&] { return std::ldexp(sign(random), static_cast<int>(random() % 30)); };
  return {size() / 1024.0, size() / 1024.0, size(), size()};
}

TEST(ZSteps, KeepUnormWordsAndRoundFloats) {
  for (const DepthFormat format :
       {DepthFormat::DepthFormat_unorm24, DepthFormat::DepthFormat_unorm16}) {
    const ZSteps steps(format);
    for (const std::uint32_t word : {0U, 1U, 777U, 65535U}) EXPECT_EQ(steps.of_word(word), word);
  }
  const ZSteps steps(DepthFormat::DepthFormat_float32);
  EXPECT_EQ(steps.of_word(traces::encode_depth(DepthFormat::DepthFormat_float32, 1.0)), 1 << 26);
  EXPECT_EQ(steps.of_word(traces::encode_depth(DepthFormat::DepthFormat_float32, 0.25)), 1 << 24);
}

// Products that cancel down to what rounding them would have lost.
TEST(LinearForm, CombineKeepsWhatIsLeftOfLargeTerms) {
  const double tiny = 0x1p-30;
  const LinearForm p{1.0 + tiny, 1e9 + tiny, 1.0, 0.0};
  const LinearForm q{1.0 + 2.0 * tiny, 1e9, tiny, 5.0};
  const LinearForm two = combine(p, 1.0 + tiny, q, -1.0);
  EXPECT_EQ(two.a, tiny * tiny);
  EXPECT_EQ(two.c, 1.0);
  EXPECT_EQ(two.d, -5.0);
  // The first two cancel down to a digit, which the third one takes away.
  const LinearForm three = combine(p, 1.0, q, -1.0, LinearForm{1.0, 1.0, 0.0, 0.0}, -tiny);
  EXPECT_EQ(three.a, -2.0 * tiny);
  EXPECT_EQ(three.b, p.b - q.b - tiny);
}

// Does a reversed depth keep its precision however near the far plane the frame lies?
TEST(ZSteps, OfReversedDepthsCountBackFromTheFarPlane) {
  const auto format = DepthFormat::DepthFormat_float32_reversed;
  const auto word = [](float stored) { return std::bit_cast<std::uint32_t>(stored); };
  const ZSteps wide(format);
  EXPECT_EQ(wide.of_word(traces::encode_depth(format, 0.75)), -(1 << 24));
  EXPECT_EQ(wide.of_word(traces::sky_word(format)), wide.high());
  EXPECT_EQ(wide.of_word(word(1.0F)), wide.low());
  const std::array<std::uint32_t, 3> words{word(0.0F), word(0x1.8p-30F), word(0x1p-31F)};
  const ZSteps narrow(format, words);
  EXPECT_EQ(narrow.one(), 0x1p55);
  EXPECT_EQ(narrow.of_word(words[1]), -(3 << 24));
  EXPECT_EQ(narrow.of_word(words[2]), -(1 << 24));
  EXPECT_EQ(narrow.first(1.0 - 0x1p-31), -(1 << 24));
  EXPECT_EQ(narrow.first(0.0), narrow.low() - 1);
  EXPECT_EQ(narrow.last(1.0), 0);
  // The same value at the same depth, whatever counts it.
  const LinearForm form{0.25, -0.5, 0x3p30, 1.0 - 0x3p30};
  const FixedForm fixed = quantize_alone(form, narrow, 58);
  const Place at = place(2.5, 1.5, static_cast<double>(narrow.of_word(words[1])));
  EXPECT_NEAR(std::ldexp(static_cast<double>(fixed.at(at)), fixed.exponent),
              0.25 * 2.5 - 0.5 * 1.5 + 1.0 - 3.0 * 1.5, 1e-9);
}

// One step of depth, and one pixel, changes the steepest form: with a bit less it does not.
TEST(LeastFormBits, KeepAStepOfDepthAndAPixel) {
  for (const DepthFormat depth :
       {DepthFormat::DepthFormat_unorm16, DepthFormat::DepthFormat_unorm24}) {
    const ZSteps steps(depth);
    const int bits = least_form_bits(depth, 1 << 14, 100);
    const LinearForm deep{0.0, 0.0, 0.999, 0.0};
    EXPECT_NE(quantize_alone(deep, steps, bits).c, 0);
    const LinearForm wide{1.9 / (1 << 14), 0.0, 0.0, 0.0};
    EXPECT_NE(quantize_alone(wide, steps, bits).a, 0);
    EXPECT_NO_THROW(require_form_bits(bits, depth, 1 << 14, 100, "here"));
    EXPECT_NE(input_error_of([&] { require_form_bits(bits - 1, depth, 1 << 14, 100, "here"); }),
              "");
  }
  EXPECT_EQ(least_form_bits(DepthFormat::DepthFormat_unorm24, 640, 427), 35);
}

TEST(ZSteps, AreInAnIntervalIffTheStoredDepthIs) {
  const DepthFormat format = DepthFormat::DepthFormat_unorm24;
  const ZSteps steps(format);
  std::mt19937 random(3);
  for (int i = 0; i < 100000; ++i) {
    const std::uint32_t word = random() % 16777216;
    const double z = traces::decode_depth(format, word);
    const double near = i % 2 == 0 ? z : z + (static_cast<double>(random() % 5) - 2.0) * 1e-8;
    ASSERT_EQ(steps.of_word(word) >= steps.first(near), z >= near) << word << ' ' << near;
    ASSERT_EQ(steps.of_word(word) <= steps.last(near), z <= near) << word << ' ' << near;
  }
}

TEST(FixedForm, NeverOverflowsItsBitsWhateverTheOrder) {
  const unsigned seed = 11;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const ZSteps steps(DepthFormat::DepthFormat_unorm24);
  for (const int bits : {51, 58, 62}) {
    const Wide limit = Wide{1} << bits;
    for (int i = 0; i < 20000; ++i) {
      const FixedForm form = quantize_alone(random_form(random), steps, bits);
      for (int corner = 0; corner < 8; ++corner) {
        const Place at{(corner & 1) * 32768, (corner >> 1 & 1) * 32768, (corner >> 2) * 16777215};
        const Wide parts[] = {Wide{form.a} * at.x, Wide{form.b} * at.y, Wide{form.c} * at.z,
                              Wide{form.d}};
        for (int set = 1; set < 16; ++set) {
          Wide sum = 0;
          for (int k = 0; k < 4; ++k) sum += (set >> k & 1) != 0 ? parts[k] : 0;
          ASSERT_LT(sum, limit);
          ASSERT_GT(sum, -limit);
        }
        ASSERT_EQ(Wide{form.at(at)}, parts[0] + parts[1] + parts[2] + parts[3]);
      }
    }
  }
}

TEST(FixedForm, IsWithinItsStatedError) {
  std::mt19937 random(12);
  const ZSteps steps(DepthFormat::DepthFormat_unorm24);
  double worst = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const LinearForm form = random_form(random);
    const FixedForm fixed = quantize_alone(form, steps, 51);
    const Place at{static_cast<std::int64_t>(random() % 32768),
                   static_cast<std::int64_t>(random() % 32768),
                   static_cast<std::int64_t>(random() % 16777216)};
    const long double exact = static_cast<long double>(form.a) * at.x / 2 +
                              static_cast<long double>(form.b) * at.y / 2 +
                              static_cast<long double>(form.c) * at.z / 16777215 + form.d;
    const auto error = static_cast<double>(
        std::fabs(std::ldexp(static_cast<long double>(fixed.at(at)), fixed.exponent) - exact));
    const double bound =
        16384 * (std::fabs(form.a) + std::fabs(form.b)) + std::fabs(form.c) + std::fabs(form.d);
    worst = std::max(worst, error / std::ldexp(bound, 25 - 51));
  }
  std::cout << "largest error: " << worst << " of what is stated\n";
  EXPECT_LE(worst, 1.0);
  EXPECT_GT(worst, 0.1);
}

TEST(FixedForm, OneExponentMakesDifferencesExact) {
  const ZSteps steps(DepthFormat::DepthFormat_unorm24);
  const LinearForm forms[] = {{1.0, 2.0, 3e6, 4.0}, {1e-9, 0.0, 1.0, -1.0}};
  const int exponent = common_exponent(forms, steps, 62);
  const FixedForm large = quantize(forms[0], steps, exponent);
  const FixedForm small = quantize(forms[1], steps, exponent);
  EXPECT_EQ(large.exponent, small.exponent);
  const LinearForm sum = combine(forms[0], 1.0, forms[1], 1.0);
  const FixedForm added = quantize(sum, steps, exponent);
  EXPECT_NEAR(static_cast<double>(added.c - large.c - small.c), 0.0, 1.0);
  EXPECT_EQ(common_exponent(std::array{LinearForm{}}, steps, 62),
            common_exponent(std::array{LinearForm{}}, steps, 24));
}

TEST(FixedPlane, PutsAPointOnASharedPlaneInExactlyOneOfItsSides) {
  const FixedPlane plus{{3, -3, 1, 0, 0}, false};
  FixedPlane minus = plus;
  minus.minus = true;
  for (std::int64_t z = -2; z <= 2; ++z) {
    const Place at{5, 5, z};
    EXPECT_NE(plus.inside(at), minus.inside(at));
  }
  EXPECT_TRUE(plus.inside({5, 5, 0}));
}

TEST(FixedPlane, ABoxReachesAndHoldsAsItsPointsDo) {
  const unsigned seed = 5;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const auto integer = [&](int low, int high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random);
  };
  int decided = 0;
  for (int i = 0; i < 20000; ++i) {
    const FixedPlane plane{{integer(-9, 9), integer(-9, 9), integer(-9, 9), integer(-60, 60), 0},
                           integer(0, 1) == 1};
    const Place low{integer(0, 5), integer(0, 5), integer(0, 5)};
    const FixedBox box{low, {low.x + integer(0, 4), low.y + integer(0, 4), low.z + integer(0, 4)}};
    bool any = false;
    bool all = true;
    for (Place at = box.low; at.z <= box.high.z; ++at.z) {
      for (at.y = box.low.y; at.y <= box.high.y; ++at.y) {
        for (at.x = box.low.x; at.x <= box.high.x; ++at.x) {
          any = any || plane.inside(at);
          all = all && plane.inside(at);
        }
      }
    }
    ASSERT_EQ(reaches(plane, box), any);
    ASSERT_EQ(holds(plane, box), all);
    decided += !any || all ? 1 : 0;
  }
  EXPECT_GT(decided, 1000);
}

}  // namespace
}  // namespace wedgesim::model::datapath

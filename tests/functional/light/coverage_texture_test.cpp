#include "functional/light/coverage_texture.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "functional/scene/light_texture.h"
#include "tests/functional/light/chords.h"

namespace wedgesim::functional {
namespace {

using Lookup = std::array<float, 3> (CoverageTexture::*)(const glm::dvec2&,
                                                         const glm::dvec2&) const;

double rms_error(const Emission& emission, const CoverageTexture& table, Lookup lookup) {
  Random random(7);
  double sum = 0.0;
  constexpr int kChords = 20000;
  for (int i = 0; i < kChords; ++i) {
    const RandomChord chord = random_chord(random);
    const auto exact = emission.beyond(chord.p, chord.q);
    const auto is = (table.*lookup)(chord.p, chord.q);
    for (std::size_t c = 0; c < static_cast<std::size_t>(emission.channels()); ++c) {
      sum += std::pow(is[c] - exact[c], 2.0) / emission.channels();
    }
  }
  return std::sqrt(sum / kChords);
}

Emission of_fire() { return Emission(emission_shares(make_fire(0, 16, 32, 1))); }

// Does the error fall as that of a rounded (1/n) and of an interpolated (1/n²) function?
TEST(CoverageTexture, ErrorFallsWithItsSide) {
  for (const bool textured : {false, true}) {
    const Emission emission = textured ? of_fire() : Emission();
    double nearest_before = 1.0;
    double linear_before = 1.0;
    for (const int side : {8, 16, 32}) {
      const auto start = std::chrono::steady_clock::now();
      const CoverageTexture table(emission, side, CoverageWords::float32);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      const double nearest = rms_error(emission, table, &CoverageTexture::nearest);
      const double linear = rms_error(emission, table, &CoverageTexture::quadlinear);
      std::cout << (textured ? "fire" : "even") << ", side " << side << ": RMS error " << nearest
                << " nearest, " << linear << " quadlinear; made in " << seconds.count() << " s\n";
      EXPECT_LT(nearest, 0.65 * nearest_before);
      EXPECT_LT(linear, 0.55 * linear_before);
      EXPECT_LT(linear, 0.5 * nearest);
      nearest_before = nearest;
      linear_before = linear;
    }
  }
}

// Entries are exact where both ends are theirs.
TEST(CoverageTexture, IsExactAtItsEntries) {
  Random random(8);
  const Image shares = emission_shares(make_fire(3, 16, 32, 1));
  const Emission emission(shares);
  constexpr int kSide = 10;
  const CoverageTexture table(emission, kSide, CoverageWords::float32);
  for (int i = 0; i < 300; ++i) {
    const auto coordinate = [&] { return 2.0 * random.whole(0, kSide - 1) / (kSide - 1) - 1.0; };
    const RandomChord chord{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (std::abs(chord.p.x * chord.q.y - chord.p.y * chord.q.x) < 1e-12) continue;
    const auto exact = exact_beyond(shares, chord.p, chord.q);
    const auto nearest = table.nearest(chord.p, chord.q);
    const auto linear = table.quadlinear(chord.p, chord.q);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(nearest[c], exact[c], 1e-6);
      ASSERT_NEAR(linear[c], exact[c], 1e-5);
    }
  }
}

// A chord nearly through the centre: whichever side its nearest entries pass, the result is near.
TEST(CoverageTexture, KeepsToTheChordsSideOfTheCentre) {
  Random random(9);
  const Emission emission = of_fire();
  const CoverageTexture table(emission, 32, CoverageWords::bits8);
  for (int i = 0; i < 3000; ++i) {
    const double angle = random.uniform(-4.0, 4.0);
    glm::dvec2 p(std::cos(angle), std::sin(angle));
    p /= std::max(std::abs(p.x), std::abs(p.y));
    const glm::dvec2 aside = random.uniform(-0.01, 0.01) * glm::dvec2(-p.y, p.x);
    const auto clamped = [](const glm::dvec2& at) {
      return glm::dvec2(std::clamp(at.x, -1.0, 1.0), std::clamp(at.y, -1.0, 1.0));
    };
    const glm::dvec2 a = clamped(p + aside);
    const glm::dvec2 b = clamped(-p + aside);
    const auto exact = emission.beyond(a, b);
    const auto nearest = table.nearest(a, b);
    const auto linear = table.quadlinear(a, b);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(nearest[c], exact[c], 0.1) << i;
      ASSERT_NEAR(linear[c], exact[c], 0.03) << i;
    }
  }
}

TEST(CoverageTexture, WordsOf8BitsAreTheFloatsRounded) {
  Random random(10);
  const Emission emission = of_fire();
  const CoverageTexture floats(emission, 16, CoverageWords::float32);
  const CoverageTexture words(emission, 16, CoverageWords::bits8);
  EXPECT_EQ(floats.bytes(), 4 * words.bytes());
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const RandomChord chord = random_chord(random);
    const auto exact = floats.nearest(chord.p, chord.q);
    const auto is = words.nearest(chord.p, chord.q);
    for (std::size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, static_cast<double>(std::abs(is[c] - exact[c])));
    }
  }
  EXPECT_LE(worst, 0.5 / 255.0 + 1e-6);
  EXPECT_GT(worst, 0.4 / 255.0);
}

TEST(CoverageTexture, HasTheSizesOfThePaper) {
  EXPECT_EQ(coverage_texture(nullptr, 32, CoverageWords::bits8)->bytes(), std::size_t{1} << 20U);
  const auto fire = std::make_shared<const Image>(make_fire(0, 16, 32, 1));
  EXPECT_EQ(coverage_texture(fire, 32, CoverageWords::bits8)->bytes(), std::size_t{3} << 20U);
}

TEST(CoverageTexture, IsMadeOnceForEachPicture) {
  const auto picture = [](int frame) {
    return std::make_shared<const Image>(make_fire(frame, 4, 16, 1));
  };
  const auto first = coverage_texture(picture(0), 8, CoverageWords::bits8);
  const auto second = coverage_texture(picture(1), 8, CoverageWords::bits8);
  EXPECT_NE(first, second);
  EXPECT_EQ(coverage_texture(picture(0), 8, CoverageWords::bits8), first);
  EXPECT_EQ(coverage_texture(picture(1), 8, CoverageWords::bits8), second);
  EXPECT_NE(coverage_texture(picture(0), 10, CoverageWords::bits8), first);
  EXPECT_NE(coverage_texture(picture(0), 8, CoverageWords::float32), first);
  EXPECT_NE(coverage_texture(nullptr, 8, CoverageWords::bits8), first);
}

}  // namespace
}  // namespace wedgesim::functional

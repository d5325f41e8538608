#include "functional/light/emission.h"

#include <gtest/gtest.h>

#include "functional/scene/light_texture.h"
#include "tests/functional/light/chords.h"

namespace wedgesim::functional {
namespace {

Image even() {
  Image image(1, 1, 3);
  image.values = {1.0F, 1.0F, 1.0F};
  return image;
}

Image random_shares(Random& random, int width, int height) {
  Image image(width, height, 3);
  for (float& value : image.values) value = static_cast<float>(random.uniform(0.0, 1.0));
  return emission_shares(image);
}

void expect_exact(const Emission& emission, const Image& shares, const RandomChord& chord) {
  const auto exact = exact_beyond(shares, chord.p, chord.q);
  const auto is = emission.beyond(chord.p, chord.q);
  for (std::size_t c = 0; c < static_cast<std::size_t>(emission.channels()); ++c) {
    ASSERT_NEAR(is[c], exact[c], 5e-7) << "channel " << c << " (" << chord.p.x << ", " << chord.p.y
                                       << ") (" << chord.q.x << ", " << chord.q.y << ")";
  }
}

TEST(Emission, OfAnEvenLightIsItsArea) {
  Random random(1);
  const Emission emission;
  EXPECT_EQ(emission.channels(), 1);
  for (int i = 0; i < 2000; ++i) expect_exact(emission, even(), random_chord(random));
}

TEST(Emission, OfATextureIsTheSumOverItsTexels) {
  Random random(2);
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {5, 4}, {16, 16}, {1, 9}}) {
    const Image shares = random_shares(random, width, height);
    const Emission emission(shares);
    EXPECT_EQ(emission.channels(), 3);
    for (int i = 0; i < 200; ++i) expect_exact(emission, shares, random_chord(random));
  }
}

// Chords along lines of texels, along diagonals, from corners: where every comparison is a tie.
TEST(Emission, HoldsOnLinesOfTexels) {
  Random random(3);
  const Image shares = random_shares(random, 4, 4);
  const Emission emission(shares);
  for (int i = 0; i < 3000; ++i) {
    const auto coordinate = [&] { return 0.5 * random.whole(-2, 2); };
    const RandomChord chord{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    const double cross = chord.p.x * chord.q.y - chord.p.y * chord.q.x;
    if (cross == 0.0) continue;
    expect_exact(emission, shares, chord);
  }
}

TEST(Emission, AChordThroughTheCentreHidesOneSideOrTheOther) {
  Random random(4);
  const Image shares = random_shares(random, 6, 6);
  const Emission emission(shares);
  for (int i = 0; i < 500; ++i) {
    glm::dvec2 p = random_chord(random).p;
    if (i % 5 == 0) p = {i % 10 == 0 ? -0.5 : 0.5, i % 10 == 0 ? 0.5 : -0.5};
    if (i % 7 == 0) p.x = -p.y;
    const glm::dvec2 q = -random.uniform(0.1, 1.0) * p;
    const auto one = emission.beyond(p, q);
    const auto other = emission.beyond(q, p);
    const glm::dvec2 aside = 1e-7 * glm::dvec2(-p.y, p.x);
    const auto near = exact_beyond(shares, p + aside, q + aside);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(std::min(std::abs(one[c] - near[c]), std::abs(1.0 - one[c] - near[c])), 0.0,
                  2e-6);
      ASSERT_NEAR(std::min(std::abs(one[c] - other[c]), std::abs(1.0 - one[c] - other[c])), 0.0,
                  1e-6);
    }
  }
}

// Ends in one direction as seen from the centre, as near as numbers can be, hide nothing.
TEST(Emission, AChordAlongARayHidesNothing) {
  Random random(5);
  const Emission emission(random_shares(random, 8, 8));
  for (int i = 0; i < 2000; ++i) {
    glm::dvec2 p = random_chord(random).p;
    if (i % 3 == 0) p.y = -p.x;  // where the sum begins
    glm::dvec2 q = random.uniform(0.1, 1.0) * p;
    if (i % 2 == 0) q.y = std::nextafter(q.y, i % 4 == 0 ? 2.0 : -2.0);
    for (const double part : emission.beyond(p, q)) ASSERT_NEAR(part, 0.0, 1e-12);
  }
}

TEST(EmissionShares, SumToOneInEveryColour) {
  Image texture(2, 2, 3);
  texture.values = {1, 0, 2, 3, 0, 2, 0, 0, 0, 0, 0, 4};
  const Image shares = emission_shares(texture);
  EXPECT_EQ(shares.values,
            (std::vector<float>{.25F, .25F, .25F, .75F, .25F, .25F, 0, .25F, 0, 0, .25F, .5F}));
  Light light;
  light.colour = {2.0, 3.0, 4.0};
  EXPECT_EQ(light_power(light), light.colour);
  light.texture = std::make_shared<const Image>(texture);
  EXPECT_EQ(light_power(light), glm::dvec3(2.0, 0.0, 8.0));
}

}  // namespace
}  // namespace wedgesim::functional

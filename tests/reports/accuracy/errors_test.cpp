#include "reports/accuracy/errors.h"

#include <gtest/gtest.h>

namespace wedgesim::reports::accuracy {
namespace {

using functional::DepthBuffer;

// Pixels: two of a receiver (object 0), one of a caster (object 1), one of the sky.
struct FourPixels : testing::Test {
  functional::Scene scene;
  DepthBuffer depth;
  FourPixels() {
    scene.objects.resize(2);
    scene.objects[1].casts = true;
    depth.width = 4;
    depth.height = 1;
    depth.words.assign(4, 0);
    depth.triangle = {0, 1, 2, DepthBuffer::kSky};
    depth.first_triangle = {0, 2, 3};
  }
  Errors errors(Region region, const std::vector<float>& values,
                const std::vector<float>& reference) const {
    ErrorSum sum;
    sum.add(Regions(scene, depth, reference), region, values, reference, 4);
    return sum.errors();
  }
};

TEST_F(FourPixels, EachRegionHoldsItsPixels) {
  const std::vector<float> reference{0.0F, 0.5F, 0.25F, 1.0F};
  EXPECT_EQ(errors(Region::surfaces, reference, reference).values, 3U);
  EXPECT_EQ(errors(Region::receivers, reference, reference).values, 2U);
  EXPECT_EQ(errors(Region::casters, reference, reference).values, 1U);
  EXPECT_EQ(errors(Region::penumbra, reference, reference).values, 2U);
}

TEST_F(FourPixels, RmseLargestAndSharesAreThoseOfTheDifferences) {
  const Errors found =
      errors(Region::receivers, {0.3F, 0.5F, 9.0F, 9.0F}, {0.0F, 0.5F - 2.0F / 255.0F, 0.0F, 0.0F});
  EXPECT_NEAR(found.rmse, std::sqrt((0.09 + 4.0 / 255.0 / 255.0) / 2.0), 1e-7);
  EXPECT_NEAR(found.largest, 0.3, 1e-7);
  EXPECT_EQ(found.beyond_1_255, 1.0);
  EXPECT_EQ(found.beyond_16_255, 0.5);
  EXPECT_NEAR(found.psnr_db(), -20.0 * std::log10(found.rmse), 1e-12);
}

TEST_F(FourPixels, KindsAreUmbraPenumbraAndLit) {
  const auto wrong = [&](float value, float truth) {
    return errors(Region::receivers, {value, 1.0F, 0.0F, 0.0F}, {truth, 1.0F, 0.0F, 0.0F})
        .wrong_kind;
  };
  EXPECT_EQ(wrong(0.1F, 0.9F), 0.0) << "both partly lit";
  EXPECT_EQ(wrong(0.4F / 255.0F, 0.0F), 0.0) << "shown as nothing";
  EXPECT_EQ(wrong(0.6F / 255.0F, 0.0F), 0.5);
  EXPECT_EQ(wrong(0.5F, 1.0F), 0.5);
  EXPECT_EQ(wrong(-1.0F, 0.0F), 0.0);
}

TEST_F(FourPixels, ValuesAreClampedAsADisplayDoes) {
  EXPECT_EQ(errors(Region::surfaces, {-3.0F, 1.5F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F, 0.0F}).rmse,
            0.0);
}

TEST_F(FourPixels, EveryChannelCounts) {
  const std::vector<float> reference(12, 0.0F);
  std::vector<float> values(12, 0.0F);
  values[4] = 1.0F;  // of pixel 1, channel 1
  const Errors found = errors(Region::receivers, values, reference);
  EXPECT_EQ(found.values, 6U);
  EXPECT_NEAR(found.rmse, std::sqrt(1.0 / 6.0), 1e-12);
}

TEST_F(FourPixels, NothingComparedIsNoError) {
  EXPECT_EQ(errors(Region::penumbra, {0, 0, 0, 0}, {1, 1, 1, 1}).values, 0U);
}

}  // namespace
}  // namespace wedgesim::reports::accuracy

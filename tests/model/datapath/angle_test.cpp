#include "model/datapath/angle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace wedgesim::model::datapath {
namespace {

TEST(UpperAngle, IsWithinItsStatedError) {
  const Rounder round(18);
  double worst = 0.0;
  for (int i = 0; i <= 200000; ++i) {
    const double angle = kPi * i / 200000;
    const double r = std::ldexp(1.0, i % 40 - 20);
    const double y = round(r * std::fabs(std::sin(angle)));
    const double x = round(r * std::cos(angle));
    worst = std::max(worst, std::fabs(upper_angle(y, x, round) - std::atan2(y, x)));
  }
  std::cout << "largest error " << worst << '\n';
  EXPECT_LE(worst, 2e-5);
  EXPECT_EQ(upper_angle(0.0, 0.0, round), 0.0);
  EXPECT_EQ(upper_angle(0.0, -2.0, round), round(kPi));
  EXPECT_EQ(upper_angle(3.0, 0.0, round), round(kPi / 2));
}

}  // namespace
}  // namespace wedgesim::model::datapath

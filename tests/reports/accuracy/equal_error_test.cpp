// What ray tracing takes for another method's error, on made-up run times that follow a power law.
#include "reports/accuracy/equal_error.h"

#include <gtest/gtest.h>

namespace wedgesim::reports::accuracy {
namespace {

Measured made(const std::string& choice, double error, double seconds) {
  Measured measured;
  measured.choice = functional::choose_method("", choice);
  measured.errors[static_cast<std::size_t>(Region::receivers)] = {.values = 1, .rmse = error};
  measured.timing.all_threads = seconds;
  return measured;
}

struct EqualError : testing::Test {
  // seconds = 1e-4 / error² from 0.1 to 0.01, then 1e-2 / error.
  std::vector<Measured> methods{made("raytraced-64", 0.01, 1.0), made("raytraced-16", 0.1, 0.01),
                                made("hard", 0.02, 0.005), made("raytraced-256", 0.001, 10.0)};
};

TEST_F(EqualError, IsReadOffBetweenNeighboursInLogarithms) {
  for (const auto& [error, seconds, extrapolated] : {std::tuple(0.05, 0.04, false),
                                                     {0.01, 1.0, false},
                                                     {0.002, 5.0, false},
                                                     {0.2, 0.0025, true},
                                                     {0.0005, 20.0, true}}) {
    const auto rays = ray_traced_for(methods, error);
    ASSERT_TRUE(rays.has_value());
    EXPECT_NEAR(rays->seconds, seconds, 1e-9 * seconds) << error;
    EXPECT_EQ(rays->extrapolated, extrapolated) << error;
  }
}

TEST_F(EqualError, IsOfChoicesThatErrAndAreNotRaysThemselves) {
  EXPECT_NEAR(ray_traced_like(methods, methods[2])->seconds, 0.25, 1e-9);
  EXPECT_FALSE(ray_traced_like(methods, methods[0]).has_value());
  EXPECT_FALSE(ray_traced_like(methods, made("ssv", 0.0, 1.0)).has_value());
  Measured refused = methods[2];
  refused.refused = "no";
  EXPECT_FALSE(ray_traced_like(methods, refused).has_value());
}

TEST_F(EqualError, NeedsTwoChoicesOfRays) {
  methods.resize(1);
  EXPECT_FALSE(ray_traced_for(methods, 0.01).has_value());
  methods.push_back(methods[0]);
  EXPECT_FALSE(ray_traced_for(methods, 0.01).has_value()) << "of different errors";
}

}  // namespace
}  // namespace wedgesim::reports::accuracy

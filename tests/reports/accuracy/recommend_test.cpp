#include "reports/accuracy/recommend.h"

#include <gtest/gtest.h>

namespace wedgesim::reports::accuracy {
namespace {

Measured made(const std::string& name, double error, double milliseconds) {
  Measured measured;
  measured.choice.text = name;
  measured.errors[static_cast<std::size_t>(Region::receivers)] = {.values = 1, .rmse = error};
  measured.timing.all_threads = 1e-3 * milliseconds;
  return measured;
}

TEST(ErrorOf, IsThatOfAllSurfacesWithoutAReceiver) {
  Measured measured;
  measured.errors[static_cast<std::size_t>(Region::surfaces)] = {.values = 4, .rmse = 0.3};
  EXPECT_EQ(error_of(measured), 0.3);
  measured.errors[static_cast<std::size_t>(Region::receivers)] = {.values = 2, .rmse = 0.1};
  EXPECT_EQ(error_of(measured), 0.1);
}

TEST(ParetoFront, LeavesOutWhatHasNoSuchCost) {
  std::vector<Measured> methods{made("nothing told", 0.001, 1.0), made("cheap", 0.1, 1.0)};
  methods[1].accesses.bytes = 100;
  EXPECT_EQ(pareto_front(methods, bytes_of), std::vector<std::size_t>{1});
}

struct Recommend : testing::Test {
  std::vector<Measured> methods{made("slow", 0.001, 100.0), made("worse", 0.2, 20.0),
                                made("middle", 0.01, 10.0), made("fast", 0.1, 1.0),
                                made("refused", 0.0, 0.0)};
  Recommend() { methods.back().refused = "not a plane"; }
};

TEST_F(Recommend, TheFrontHoldsWhatNoOtherBeatsFastestFirst) {
  EXPECT_EQ(pareto_front(methods), (std::vector<std::size_t>{3, 2, 0}));
}

TEST_F(Recommend, OfEqualTimesOnlyTheMoreExactIsOnTheFront) {
  EXPECT_EQ(pareto_front({made("a", 0.2, 1.0), made("b", 0.1, 1.0)}), std::vector<std::size_t>{1});
}

TEST_F(Recommend, TheFastestWithinAnError) {
  const Recommendation found = recommend(methods, {.max_error = 0.05, .budget_seconds = {}});
  ASSERT_EQ(found.method, 2U);
  EXPECT_EQ(found.why,
            "middle (RMSE 0.0100, 10.0 ms) for RMSE up to 0.05; what is faster is less exact: "
            "fast (RMSE 0.1000, 1.0 ms); what is more exact is slower: slow (RMSE 0.0010, 100.0 "
            "ms)");
}

TEST_F(Recommend, TheMostExactWithinABudget) {
  EXPECT_EQ(recommend(methods, {.max_error = {}, .budget_seconds = 0.05}).method, 2U);
  EXPECT_EQ(recommend(methods, {.max_error = {}, .budget_seconds = 0.005}).method, 3U);
}

TEST_F(Recommend, WithBothTheFastestWithinBoth) {
  EXPECT_EQ(recommend(methods, {.max_error = 0.05, .budget_seconds = 1.0}).method, 2U);
  const Recommendation none = recommend(methods, {.max_error = 0.05, .budget_seconds = 0.005});
  EXPECT_FALSE(none.method.has_value());
  EXPECT_EQ(none.why,
            "no method reaches RMSE up to 0.05 in 5 ms; the fastest is fast (RMSE 0.1000, 1.0 ms); "
            "the most exact is slow (RMSE 0.0010, 100.0 ms)");
}

}  // namespace
}  // namespace wedgesim::reports::accuracy

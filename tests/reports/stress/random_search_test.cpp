// Do the renderer and the model, exact and fixed, survive frames of extreme sizes and positions,
// and is their light intensity right wherever they do not themselves foresee that it may not be?
// 10^4 random frames, or as many as WEDGESIM_RANDOM_FRAMES says. One that fails is made simpler and
// printed as the text of which families/found.cpp makes a case.
#include "tests/reports/stress/random_search.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <numeric>
#include <ostream>
#include <string>

#include "reports/stress/families/random_case.h"

namespace wedgesim::reports::stress {
namespace {

constexpr int kFrames = 10000;
constexpr int kSeed = 20050;
// The judge looks at all pixels of one frame in so many; of others at those in dispute.
constexpr int kJudgedWhole = 4;

struct RandomFrame {
  Genes genes{};
};

// Found by RapidCheck, by this name.
// NOLINTNEXTLINE(readability-identifier-naming)
void showValue(const RandomFrame& frame, std::ostream& os) {
  os << '"' << text_of(frame.genes) << '"';
}

rc::Gen<RandomFrame> random_frame() {
  return [](const rc::Random& random, int) {
    rc::Random source(random);
    std::mt19937_64 engine(source.next());
    return rc::shrinkable::shrinkRecur(RandomFrame{draw(engine)}, [](const RandomFrame& frame) {
      std::vector<RandomFrame> all;
      for (const Genes& genes : simpler(frame.genes)) all.push_back({genes});
      return rc::seq::fromContainer(all);
    });
  };
}

struct Statistics {
  int frames = 0, refused = 0, penumbrae = 0, flagged = 0;
};

// In a harmless frame an error of one arithmetic is seen, though others are right.
TEST(RandomSearch, APlantedErrorIsFound) {
  const Case harmless = case_of(Genes{});
  EXPECT_FALSE(is_wrong(probe(harmless, true)));
  for (const char* arithmetic : {"renderer", "exact", "fixed"}) {
    for (const std::size_t pixel : {0U, 27U, 63U}) {
      const Probe result = probe(harmless, false, {arithmetic, pixel, 0.02});
      ASSERT_EQ(result.faults.size(), 1U) << arithmetic;
      EXPECT_EQ(result.faults[0].arithmetic, arithmetic);
      EXPECT_EQ(result.faults[0].pixel, pixel);
      EXPECT_TRUE(is_wrong(result)) << arithmetic;
    }
  }
}

TEST(RandomSearch, EveryFrameIsRightOrForeseenOrRefused) {
  const char* const text = std::getenv("WEDGESIM_RANDOM_FRAMES");
  const std::string frames = text != nullptr ? text : std::to_string(kFrames);
  const std::string parameters = fmt::format("seed={} max_success={}", kSeed, frames);
  ASSERT_EQ(setenv("RC_PARAMS", parameters.c_str(), 0), 0);  // unless it is set
  fmt::print("RC_PARAMS=\"{}\"\n", std::getenv("RC_PARAMS"));

  Statistics statistics;
  bool running = false;
  bool failed = false;
  EXPECT_TRUE(rc::check("LI is the judge's, or its arithmetic foresees that it may not be", [&] {
    failed = failed || running;  // the one before did not reach the end
    running = true;
    const RandomFrame frame = *random_frame();
    // While it shrinks, nothing may hide.
    const int sum = std::accumulate(frame.genes.begin(), frame.genes.end(), 0);
    const Probe result = probe(case_of(frame.genes), failed || sum % kJudgedWhole == 0);
    statistics.frames += 1;
    statistics.refused += result.refused ? 1 : 0;
    statistics.penumbrae += result.penumbra > 0.0 ? 1 : 0;
    statistics.flagged += result.faults.empty() ? 0 : 1;
    if (is_wrong(result)) RC_FAIL(describe(result));
    running = false;
  }));
  if (failed || running) return;
  fmt::print("{} frames: {} refused, {} with penumbrae, {} with pixels off and foreseen\n",
             statistics.frames, statistics.refused, statistics.penumbrae, statistics.flagged);
  EXPECT_LT(3 * statistics.refused, statistics.frames);
  EXPECT_GT(3 * statistics.penumbrae, statistics.frames);
}

}  // namespace
}  // namespace wedgesim::reports::stress

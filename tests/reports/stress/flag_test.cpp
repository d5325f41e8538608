// Is each reason for doubt seen where it is, and only there; what a datapath foresees as such, what
// only a comparison shows as such?
#include "reports/stress/flag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "model/count/wedge_check.h"
#include "reports/stress/case_name.h"
#include "reports/stress/frame.h"

namespace wedgesim::reports::stress {
namespace {

using Numbers = std::vector<std::uint32_t>;

// A frame in one arithmetic, as measure() has it. Sums may be changed before run().
struct Looked {
  Case made;
  functional::Frame frame;
  traces::TraceView trace;
  model::Datapath datapath;
  Evaluation own, exact;
  std::vector<TraceRounding> roundings;

  Looked(const char* name, Arithmetic arithmetic)
      : made(parse_case("name", name).make()),
        frame(frame_of(made)),
        trace(frame.trace.view()),
        datapath(datapath_of(arithmetic, made)),
        own(evaluate(trace, method_of(frame), datapath)),
        exact(evaluate(trace, method_of(frame), {})),
        roundings(trace_roundings(trace, method_of(frame))) {}

  std::vector<Flagged> run() const { return flag(trace, datapath, own, exact, roundings); }

  // Nothing is left that a comparison could show.
  void compare_nothing() {
    trace.expected_li = {};
    for (std::size_t i = 0; i < own.sums.size(); ++i) {
      exact.sums[i] =
          std::llround(static_cast<double>(own.sums[i]) / datapath.one() * model::Datapath().one());
    }
  }

  // The primitives at some pixels, each once.
  Numbers numbers_at(const std::vector<std::size_t>& pixels) const {
    Numbers all;
    for (const Numbers& numbers : wedges_at(trace, pixels)) {
      all.insert(all.end(), numbers.begin(), numbers.end());
    }
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    return all;
  }

  // The pixel of a penumbra whose stored depth matters most, and that not all primitives are at.
  std::size_t sensitive_pixel() const {
    std::size_t best = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < trace.depth.size(); ++i) {
      const auto here = static_cast<double>(trace.li_sensitivity[i]);
      const std::size_t count = numbers_at({i}).size();
      if (here <= most || count == 0 || count >= roundings.size()) continue;
      best = i;
      most = here;
    }
    EXPECT_GT(most, 0.0);
    return best;
  }

  // Says what LI is at a pixel: its expected one, so many tolerances and sensitivities more.
  void set(Evaluation& evaluation, std::size_t pixel, double tolerances, double sensitivities) {
    const double one = &evaluation == &own ? datapath.one() : model::Datapath().one();
    const double more = tolerances * datapath.tolerance() +
                        sensitivities * static_cast<double>(trace.li_sensitivity[pixel]);
    evaluation.sums[pixel] =
        std::llround(one * (static_cast<double>(trace.expected_li[pixel]) + more));
  }
};

Numbers numbers_of(const std::vector<Flagged>& flagged) {
  Numbers numbers;
  for (const Flagged& one : flagged) numbers.push_back(one.wedge);
  return numbers;
}

// Those of one reason.
std::vector<Flagged> with(std::vector<Flagged> flagged, std::string_view reason) {
  std::erase_if(flagged, [&](const Flagged& one) { return one.reason != reason; });
  return flagged;
}

constexpr std::string_view kWord = "LI leaves its word at a pixel";
constexpr std::string_view kShows = "its rounding may show at a pixel";
constexpr std::string_view kMany = "too many contributions are rounded at a pixel";
constexpr std::string_view kPasses = "a plane of it passes a pixel by less than its rounding";
constexpr std::string_view kMoves =
    "rounding may move its edge or its planes by a quarter of the bar";
constexpr std::string_view kFiner =
    "a pixel's stored depth is finer than its window depth in double precision";
constexpr std::string_view kDiffers = "its pixel's sum differs visibly from double precision";
constexpr std::string_view kApart = "the block and the renderer differ at a pixel";

TEST(Flag, NothingIsFlaggedInHarmlessFrames) {
  for (const char* name : {"distance-ratio,0,1", "distance-ratio,1,1", "distance-ratio,2,1"}) {
    for (const Arithmetic arithmetic :
         {Arithmetic::fixed, Arithmetic::float32, Arithmetic::double_precision}) {
      EXPECT_TRUE(Looked(name, arithmetic).run().empty()) << name << ' ' << name_of(arithmetic);
    }
  }
}

struct Doubtful {
  const char* name;
  Arithmetic arithmetic;
  std::string_view reason;
};

// Each reason that needs no other arithmetic, without one to compare with.
TEST(Flag, ForeseesEachReason) {
  const Doubtful cases[]{
      {"overlap,0,18", Arithmetic::fixed, kWord},
      {"line-light,0,1e-8", Arithmetic::fixed, kShows},
      {"line-light,0,1e-8", Arithmetic::float32, kShows},
      {"many-edges,0,1000", Arithmetic::fixed, kMany},
      {"contact,0,0", Arithmetic::double_precision, kPasses},
      {"found-flagged,0,3", Arithmetic::fixed, kPasses},
      {"found-flagged,0,4", Arithmetic::fixed, kMoves},
      {"found-flagged,0,8", Arithmetic::double_precision, kMoves},
      {"edge-at-light,0,0", Arithmetic::fixed, model::describe(model::FlagReason::plane)},
      {"found-flagged,0,2", Arithmetic::fixed, model::describe(model::FlagReason::light)},
      {"near-far-reversed,0,1e9", Arithmetic::double_precision, kFiner},
  };
  for (const Doubtful& one : cases) {
    SCOPED_TRACE(std::string(one.name) + ' ' + std::string(name_of(one.arithmetic)));
    Looked looked(one.name, one.arithmetic);
    const std::vector<Flagged> compared = looked.run();
    looked.compare_nothing();
    const std::vector<Flagged> alone = looked.run();
    EXPECT_FALSE(with(alone, one.reason).empty());
    Numbers foreseen;
    for (const Flagged& flagged : compared) {
      if (flagged.foreseen) foreseen.push_back(flagged.wedge);
    }
    EXPECT_EQ(numbers_of(alone), foreseen);
    for (const Flagged& flagged : alone) EXPECT_TRUE(flagged.foreseen) << flagged.reason;
  }
}

// A word too short is the fixed datapath's trouble, a depth too fine that of double.
TEST(Flag, ReasonsAreThoseOfTheArithmetic) {
  EXPECT_TRUE(Looked("overlap,0,18", Arithmetic::float32).run().empty());
  EXPECT_TRUE(Looked("overlap,0,18", Arithmetic::double_precision).run().empty());
  EXPECT_TRUE(Looked("near-far-reversed,0,1e9", Arithmetic::fixed).run().empty());
}

// LI that its word cannot hold, and contributions too many to be rounded, at one pixel.
TEST(Flag, ForeseesAtThatPixelAlone) {
  Looked word("distance-ratio,0,1", Arithmetic::fixed);
  const std::size_t pixel = word.sensitive_pixel();
  word.own.sums[pixel] = std::llround(1e6 * word.datapath.one());
  ASSERT_FALSE(word.datapath.li_holds(word.own.sums[pixel]));
  EXPECT_EQ(numbers_of(word.run()), word.numbers_at({pixel}));
  EXPECT_EQ(with(word.run(), kWord).size(), word.numbers_at({pixel}).size());
  Looked many("distance-ratio,0,1", Arithmetic::fixed);
  many.own.contributions[pixel] = 1'000'000;
  EXPECT_EQ(numbers_of(many.run()), many.numbers_at({pixel}));
  EXPECT_FALSE(with(many.run(), kMany).empty());
  for (const Flagged& flagged : many.run()) EXPECT_TRUE(flagged.foreseen);
}

// An error at one pixel, a fifth more or less than what is allowed.
TEST(Flag, AComparisonFlagsAtThatPixelAlone) {
  for (const Arithmetic arithmetic : {Arithmetic::fixed, Arithmetic::float32}) {
    SCOPED_TRACE(name_of(arithmetic));
    Looked looked("distance-ratio,0,1", arithmetic);
    const std::size_t pixel = looked.sensitive_pixel();
    for (const double sign : {1.0, -1.0}) {
      looked.set(looked.own, pixel, 0.8 * sign, sign);
      EXPECT_TRUE(looked.run().empty());
      looked.set(looked.own, pixel, 1.2 * sign, sign);
      const std::vector<Flagged> flagged = looked.run();
      EXPECT_EQ(numbers_of(flagged), looked.numbers_at({pixel}));
      for (const Flagged& one : flagged) {
        EXPECT_FALSE(one.foreseen);
        EXPECT_EQ(one.reason, kDiffers);
      }
    }
  }
}

// Of double itself a quarter of the tolerance is allowed beside the renderer.
TEST(Flag, DoubleIsComparedWithTheRenderer) {
  Looked looked("distance-ratio,0,1", Arithmetic::double_precision);
  const std::size_t pixel = looked.sensitive_pixel();
  for (const double part : {0.2, 0.3}) {
    looked.set(looked.own, pixel, part, 1.0);
    looked.set(looked.exact, pixel, part, 1.0);
    const std::vector<Flagged> flagged = looked.run();
    EXPECT_EQ(numbers_of(flagged), part > 0.25 ? looked.numbers_at({pixel}) : Numbers());
    EXPECT_EQ(with(flagged, kApart).size(), flagged.size());
    for (const Flagged& one : flagged) EXPECT_FALSE(one.foreseen);
  }
  looked.trace.expected_li = {};
  EXPECT_TRUE(looked.run().empty()) << "nothing to compare with";
}

// Neither is too far from double precision, nor that from the renderer, but both together.
TEST(Flag, BothDifferencesTogetherAreCompared) {
  Looked looked("distance-ratio,0,1", Arithmetic::float32);
  const std::size_t pixel = looked.sensitive_pixel();
  looked.set(looked.exact, pixel, 0.2, 0.0);
  looked.set(looked.own, pixel, 1.1, 1.0);
  const std::vector<Flagged> flagged = looked.run();
  EXPECT_EQ(numbers_of(flagged), looked.numbers_at({pixel}));
  EXPECT_EQ(with(flagged, kApart).size(), flagged.size());
}

}  // namespace
}  // namespace wedgesim::reports::stress

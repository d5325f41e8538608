#include "model/count/explain.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "model/count/count.h"
#include "tests/model/count/synthetic.h"
#include "tests/support/repetitions.h"

namespace wedgesim::model {
namespace {

void expect_explained(const traces::Trace& trace, const CountConfig& config) {
  CountOptions options;
  options.maps = true;
  const CountResult counted = std::move(count(trace.view(), {&config, 1}, options).front());
  std::size_t pixel = 0;
  for (int y = 0; y < static_cast<int>(trace.header.height); ++y) {
    for (int x = 0; x < static_cast<int>(trace.header.width); ++x, ++pixel) {
      const Explanation explanation = explain(trace.view(), x, y, config);
      ASSERT_EQ(explanation.word, counted.li[pixel]) << x << ' ' << y;
      ASSERT_EQ(explanation.z_reads, counted.z_reads[pixel]) << x << ' ' << y;
      ASSERT_EQ(explanation.li_writes, counted.li_writes[pixel]) << x << ' ' << y;
    }
  }
}

TEST(Explain, AddsUpToWhatIsCounted) {
  for (unsigned seed = 1; seed <= repetitions(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = seed % 2 == 0 ? test::random_tetrahedra(random, 23, 17, 6)
                                              : test::random_nonsense(random, 23, 17, 6);
    const auto cull = static_cast<Cull>(seed % 6);
    const auto z = seed % 3 == 0 ? ZChoice::fail : ZChoice::pass;
    expect_explained(trace,
                     {Mode::single_pass, 4, cull, UmbraCull::zmax, Accept::zmin, Share::all, z});
    expect_explained(trace,
                     {Mode::three_pass, 8, cull, UmbraCull::zmax, Accept::none, Share::eye, z});
  }
}

TEST(Explain, NamesTestsAndContributions) {
  test::SyntheticTrace synthetic(8, 8, 0.5);
  const std::uint32_t front = synthetic.add_plane(0, 0, 1, -0.2);
  const std::uint32_t right = synthetic.add_plane(1, 0, 0, -3.0, true);  // x > 3
  const std::vector<test::Point> square{{0, 0, 0.2}, {8, 0, 0.2}, {8, 8, 0.2}, {0, 8, 0.2}};
  synthetic.add_face(square, test::Facing::eye, front);
  const std::uint32_t wedge =
      synthetic.add_wedge(traces::fb::WedgeKind_coverage, {front, right}, 0.2, 0.9);
  synthetic.add_umbra(square, test::Facing::eye, front, wedge);
  synthetic.trace.expected_li.assign(64, 0.25);

  const std::string inside = to_text(explain(synthetic.trace.view(), 5, 2, {}));
  EXPECT_NE(inside.find("pixel 5,2: z 0.5"), std::string::npos) << inside;
  EXPECT_NE(inside.find("face 0: survives"), std::string::npos) << inside;
  EXPECT_NE(inside.find("plane -1: v -2.5, inside"), std::string::npos) << inside;
  EXPECT_NE(inside.find("side polygon 0, facing the eye"), std::string::npos) << inside;
  EXPECT_NE(inside.find("passes: -1"), std::string::npos) << inside;
  EXPECT_NE(inside.find("1 z reads, 1 LI writes, shared"), std::string::npos) << inside;
  EXPECT_NE(inside.find("expected 0.25"), std::string::npos) << inside;
  const std::string outside = to_text(explain(synthetic.trace.view(), 2, 2, {}));
  EXPECT_NE(outside.find("plane -1: v +0.5, outside"), std::string::npos) << outside;
  EXPECT_NE(outside.find("the point is outside the wedge: +0.000000000"), std::string::npos)
      << outside;

  for (std::uint32_t i = 0; i < 64; ++i) synthetic.set_depth(i % 8, i / 8, 0.1);
  const std::string culled = to_text(explain(synthetic.trace.view(), 5, 2, {}));
  EXPECT_NE(culled.find("face 0: culled by zrange"), std::string::npos) << culled;
  EXPECT_NE(culled.find("tile culled: +0"), std::string::npos) << culled;
  EXPECT_NE(culled.find("0 z reads, 0 LI writes; LI = 1 = 1.000000000"), std::string::npos)
      << culled;
}

TEST(Explain, RefusesPixelsOutsideTheFrame) {
  test::SyntheticTrace synthetic(8, 4, 0.5);
  EXPECT_THROW(explain(synthetic.trace.view(), 8, 0, {}), InputError);
  EXPECT_THROW(explain(synthetic.trace.view(), 0, -1, {}), InputError);
}

}  // namespace
}  // namespace wedgesim::model

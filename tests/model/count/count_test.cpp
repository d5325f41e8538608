#include "model/count/count.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "base/error.h"
#include "tests/model/count/naive_counter.h"
#include "tests/model/count/synthetic.h"
#include "tests/support/repetitions.h"
#include "traces/depth.h"
#include "traces/verify.h"

namespace wedgesim::model {
namespace {

using test::Facing;
using test::SyntheticTrace;

std::map<std::string, std::uint64_t, std::less<>> values(const Counters& counters) {
  std::map<std::string, std::uint64_t, std::less<>> result;
  for (const Counter* counter : counters.counters()) {
    result.emplace(counter->name(), counter->value());
  }
  return result;
}

// The example at the end of the counters' definitions: 4x2 pixels, tile 2, so tile A is x = 0-1 and
// B is x = 2-3. Faces F1 = A and F2 = column 2; a quad on columns 1 and 2, all of it passing;
// inside are (1, 0), (1, 1), (2, 0). With `b_in_front` all of tile B lies before everything.
traces::Trace example(Facing umbra_facing, bool b_in_front) {
  SyntheticTrace synthetic(4, 2, 0.5);
  const std::uint32_t front = synthetic.add_plane(0, 0, 1, -0.2);    // z >= 0.2
  const std::uint32_t from_1 = synthetic.add_plane(1, 0, 0, -1);     // columns 1, 2, 3
  const std::uint32_t corner = synthetic.add_plane(-1, -1, 0, 3.5);  // without (2, 1)
  const auto rectangle = [](double x0, double x1) {
    return std::vector<test::Point>{{x0, 0, 0.2}, {x1, 0, 0.2}, {x1, 2, 0.2}, {x0, 2, 0.2}};
  };
  synthetic.add_face(rectangle(0, 2), Facing::eye, front);
  synthetic.add_face(rectangle(2, 3), Facing::eye, front);
  const std::uint32_t wedge =
      synthetic.add_wedge(traces::fb::WedgeKind_coverage, {front, from_1, corner}, 0.2, 0.9);
  const std::uint32_t quad = umbra_facing == Facing::eye ? synthetic.add_plane(0, 0, 1, -0.2)
                                                         : synthetic.add_plane(0, 0, -1, 0.2);
  synthetic.add_umbra(rectangle(1, 3), umbra_facing, quad, wedge);
  for (std::uint32_t y = 0; b_in_front && y < 2; ++y) {
    synthetic.set_depth(2, y, 0.1);
    synthetic.set_depth(3, y, 0.1);
  }
  return std::move(synthetic.trace);
}

struct Expected {
  CountConfig config;
  std::uint64_t z_reads, li_writes, tile_visits;
};

void expect_example(const traces::Trace& trace, const std::vector<Expected>& expected) {
  for (const Expected& e : expected) {
    const auto results = count(trace.view(), {&e.config, 1});
    const Counters& counters = *results[0].counters;
    SCOPED_TRACE(std::string(spelling(e.config.mode)));
    EXPECT_EQ(counters.z_reads.value(), e.z_reads);
    EXPECT_EQ(counters.li_writes.value(), e.li_writes);
    EXPECT_EQ(counters.tile_visits.value(), e.tile_visits);
  }
}

CountConfig config_of(Mode mode, Cull cull, UmbraCull umbra_cull, Share share = Share::eye) {
  CountConfig config;
  config.mode = mode;
  config.tile = 2;
  config.cull = cull;
  config.umbra_cull = umbra_cull;
  config.share = share;
  return config;
}

TEST(Example, WithoutCulling) {
  // Three-pass: F1 4 + F2 2 + U 4 = 10 reads; 3 inside + 4 passed = 7 writes; visits: F1 in A, F2
  // in B, U in A and B. Single-pass: the union of columns 0, 1, 2 is 6 reads; passed or inside are
  // columns 1 and 2, 4 writes; the faces' 2 visits.
  expect_example(example(Facing::eye, false),
                 {{config_of(Mode::three_pass, Cull::none, UmbraCull::none), 10, 7, 4},
                  {config_of(Mode::single_pass, Cull::none, UmbraCull::none), 6, 4, 2}});
}

TEST(Example, WithAnUmbraPolygonFacingAway) {
  expect_example(
      example(Facing::away, false),
      {{config_of(Mode::single_pass, Cull::none, UmbraCull::none, Share::eye), 10, 7, 4},
       {config_of(Mode::single_pass, Cull::none, UmbraCull::none, Share::all), 6, 4, 2}});
}

TEST(Example, WithTileBInFront) {
  // B is culled for faces and polygon: F1's 4 pixels and U's 2 of column 1 are left.
  expect_example(example(Facing::eye, true),
                 {{config_of(Mode::three_pass, Cull::both, UmbraCull::zmax), 6, 4, 4},
                  {config_of(Mode::single_pass, Cull::both, UmbraCull::zmax), 4, 2, 2}});
}

TEST(Example, AllOtherCounters) {
  const traces::Trace trace = example(Facing::eye, true);
  const std::vector<CountConfig> configs{config_of(Mode::three_pass, Cull::both, UmbraCull::zmax),
                                         config_of(Mode::single_pass, Cull::both, UmbraCull::zmax)};
  const auto results = count(trace.view(), configs);
  const auto three = values(*results[0].counters);
  const auto single = values(*results[1].counters);
  // Only A survives, read whole: 4 pixels for P and 4 for Q, or once.
  EXPECT_EQ(three.at("z_reads_whole_tile"), 8u);
  EXPECT_EQ(single.at("z_reads_whole_tile"), 4u);
  // Column 1 passes: 2 stencil writes; (1, 0) and (1, 1) are inside: 2 LI writes.
  EXPECT_EQ(three.at("stencil_writes"), 2u);
  EXPECT_EQ(three.at("stencil_reads"), 2u);
  EXPECT_EQ(three.at("li_reads"), 2u);
  EXPECT_EQ(single.at("stencil_writes"), 0u);
  EXPECT_EQ(single.at("li_reads"), 2u);
  // `both` names 2 words, umbra `zmax` 1: three-pass 2 faces * 2 + 2 polygon visits * 1; the union
  // of a shared visit is still 2.
  EXPECT_EQ(three.at("tile_reads"), 6u);
  EXPECT_EQ(single.at("tile_reads"), 4u);
  EXPECT_EQ(single.at("tile_words"), 4u);        // 2 tiles of 2 words
  EXPECT_EQ(single.at("tile_build_reads"), 8u);  // all pixels
  EXPECT_EQ(single.at("visits_culled_zrange"), 1u);
  EXPECT_EQ(single.at("visits_culled_planes"), 0u);
  EXPECT_EQ(single.at("umbra_visits_culled"), 1u);
  EXPECT_EQ(three.at("umbra_visits_culled"), 1u);
  EXPECT_EQ(single.at("umbra_visits_accepted"), 0u);
  EXPECT_EQ(single.at("tiles_inside"), 0u);     // A's column 0 is outside
  EXPECT_EQ(single.at("pixels_covered"), 10u);  // 6 of faces, 4 of the polygon
  EXPECT_EQ(single.at("pixels_inside"), 2u);    // (2, 0) is now in front
  // Merge: 8 stencil words and the 2 LI words where it is not 0; clears of 8 and of 16 words.
  EXPECT_EQ(three.at("merge_reads"), 10u);
  EXPECT_EQ(three.at("merge_writes"), 2u);
  EXPECT_EQ(three.at("clear_writes"), 16u);
  EXPECT_EQ(single.at("merge_reads"), 0u);
  EXPECT_EQ(single.at("clear_writes"), 8u);
  EXPECT_EQ(three.at("z_reads_min"), 4u);
  EXPECT_EQ(three.at("li_writes_min"), 2u);
  EXPECT_EQ(single.at("z_reads_floor"), 2u);
  EXPECT_EQ(single.at("li_writes_floor"), 2u);
  EXPECT_EQ(single.at("li_overflow_pixels"), 0u);
  EXPECT_EQ(single.at("contributions_max"), 2u);
  EXPECT_EQ(three.at("wedge_bytes"), 2 * single.at("wedge_bytes"));  // passes 1 and 3
  // Depth 4 bytes * (4 read + 4 + 8 of tiles), LI 2 bytes * (2 + 2 + 8 cleared).
  EXPECT_EQ(single.at("all_bytes"), 4 * 16u + 2 * 12u + single.at("wedge_bytes"));
  // 4 * (6 + 6 + 8); LI 2 * (2 + 2, merge 2 + 2, 8 cleared); stencil 2 + 2, merge 8, 8 cleared.
  EXPECT_EQ(three.at("all_bytes"), 4 * 20u + 2 * 16u + 20u + three.at("wedge_bytes"));
}

std::vector<CountConfig> all_configs(const std::vector<unsigned>& tiles) {
  std::vector<CountConfig> configs;
  for (unsigned tile : tiles) {
    for (Mode mode : {Mode::single_pass, Mode::three_pass}) {
      for (Cull cull :
           {Cull::none, Cull::zmax, Cull::zrange, Cull::planes, Cull::both, Cull::sat}) {
        for (UmbraCull umbra : {UmbraCull::none, UmbraCull::zmax}) {
          for (Accept accept : {Accept::none, Accept::zmin}) {
            for (Share share : {Share::eye, Share::all}) {
              const auto build = static_cast<TileBuild>(configs.size() % 3);
              configs.push_back(
                  {mode, tile, cull, umbra, accept, share, ZChoice::automatic, build});
            }
          }
        }
      }
    }
  }
  return configs;
}

std::string describe(const CountConfig& c) {
  std::string text(spelling(c.mode));
  return text.append(" tile ")
      .append(std::to_string(c.tile))
      .append(" cull ")
      .append(spelling(c.cull))
      .append(" umbra ")
      .append(spelling(c.umbra_cull))
      .append(" accept ")
      .append(spelling(c.accept))
      .append(" share ")
      .append(spelling(c.share))
      .append(" build ")
      .append(spelling(c.tile_build));
}

void expect_naive(const traces::Trace& trace, std::vector<CountConfig> configs, bool fail) {
  ASSERT_NO_THROW(traces::verify(trace.view(), "synthetic"));
  for (CountConfig& config : configs) config.z = fail ? ZChoice::fail : ZChoice::pass;
  CountOptions options;
  options.maps = true;
  const auto results = count(trace.view(), configs, options);
  for (std::size_t i = 0; i < configs.size(); ++i) {
    SCOPED_TRACE(describe(configs[i]) + (fail ? " z-fail" : " z-pass"));
    const test::NaiveCount naive = test::naive_count(trace.view(), configs[i], fail);
    ASSERT_EQ(values(*results[i].counters), naive.counters);
    ASSERT_EQ(results[i].li, naive.li);
    ASSERT_EQ(results[i].z_reads, naive.z_reads);
    ASSERT_EQ(results[i].li_writes, naive.li_writes);
  }
}

TEST(Count, EqualsTheNaiveCounterOnNonsense) {
  for (unsigned seed = 1; seed <= repetitions(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_nonsense(random, 13 + seed, 21 - seed, 3);
    expect_naive(trace, all_configs({2, 4, 8, 16}), seed % 2 == 0);
    if (HasFatalFailure()) return;
  }
}

TEST(Count, EqualsTheNaiveCounterOnTetrahedra) {
  for (unsigned seed = 1; seed <= repetitions(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 19, 17, 3);
    expect_naive(trace, all_configs({2, 4, 8, 32}), seed % 2 == 0);
    if (HasFatalFailure()) return;
  }
}

TEST(Count, EqualsTheNaiveCounterOnATallFrame) {
  // Beyond one band of rows, with the largest tiles.
  std::mt19937 random(7);
  const traces::Trace trace = test::random_tetrahedra(random, 9, 530, 3);
  expect_naive(
      trace, {CountConfig{}, {Mode::three_pass, 256, Cull::zmax}, {Mode::single_pass, 128}}, false);
}

TEST(Count, CullingSharingModeAndTileKeepEveryWord) {
  for (unsigned seed = 1; seed <= repetitions(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 75, 50, 30);
    auto configs = all_configs({2, 4, 8, 16, 32, 64, 128, 256});
    for (CountConfig& config : configs) config.z = seed % 2 == 0 ? ZChoice::fail : ZChoice::pass;
    CountOptions options;
    options.maps = true;
    const auto results = count(trace.view(), configs, options);
    EXPECT_GT(results[0].counters->pixels_inside.value(), 0u);
    for (const CountResult& result : results) {
      ASSERT_EQ(result.wrong_contributions, 0u) << describe(result.config);
      ASSERT_EQ(result.li, results[0].li) << describe(result.config);
    }
  }
}

TEST(Count, ThreadsAndKernelsChangeNothing) {
  const std::vector<CountConfig> configs{{},
                                         {Mode::three_pass, 2, Cull::zmax},
                                         {Mode::single_pass, 32, Cull::sat, UmbraCull::none},
                                         {.accept = Accept::zmin, .share = Share::all}};
  for (unsigned seed = 1; seed <= repetitions(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = seed % 2 == 0 ? test::random_tetrahedra(random, 75, 50, 30)
                                              : test::random_nonsense(random, 75, 50, 30);
    CountOptions options;
    options.maps = true;
    options.threads = 1;
    const auto alone = count(trace.view(), configs, options);
    for (unsigned threads : {2u, 7u}) {
      options.threads = threads;
      options.kernel = threads == 2 ? KernelChoice::simd : KernelChoice::scalar;
      const auto together = count(trace.view(), configs, options);
      for (std::size_t i = 0; i < configs.size(); ++i) {
        ASSERT_EQ(values(*together[i].counters), values(*alone[i].counters));
        ASSERT_EQ(together[i].li, alone[i].li);
        ASSERT_EQ(together[i].z_reads, alone[i].z_reads);
        ASSERT_EQ(together[i].li_writes, alone[i].li_writes);
      }
    }
  }
}

TEST(Count, AWrongTileTestShowsInTheWords) {
  // A face that claims to begin behind where its plane does: `zmax` then culls what is inside.
  SyntheticTrace synthetic(8, 8, 0.5);
  const std::uint32_t plane = synthetic.add_plane(0, 0, 1, -0.2);
  synthetic.add_face({{0, 0, 0.7}, {8, 0, 0.7}, {8, 8, 0.7}, {0, 8, 0.7}}, Facing::eye, plane);
  synthetic.add_wedge(traces::fb::WedgeKind_coverage, {plane}, 0.0, 1.0);
  const std::vector<CountConfig> configs{{.cull = Cull::both}, {.cull = Cull::zmax}};
  CountOptions options;
  options.maps = true;
  const auto results = count(synthetic.trace.view(), configs, options);
  EXPECT_EQ(results[0].wrong_contributions, 0u);
  EXPECT_EQ(results[1].wrong_contributions, 64u);
  EXPECT_NE(results[0].li, results[1].li);
  EXPECT_EQ(results[1].li, std::vector<std::int64_t>(64, std::int64_t{1} << 40));
}

TEST(Count, CullingKeepsWhatSinglePrecisionTakesForInside) {
  // At the face's column its plane is z >= 0.5, in single precision z >= 0.5 - 2^-11.
  SyntheticTrace synthetic(16, 8, 0.49975);
  const std::uint32_t plane = synthetic.add_plane(1000, 0, 1, -8500.5);
  synthetic.add_face({{8, 0, 0.5}, {9, 0, 0.5}, {9, 8, 0.5}, {8, 8, 0.5}}, Facing::eye, plane);
  synthetic.add_wedge(traces::fb::WedgeKind_coverage, {plane}, 0.2, 0.9);
  CountOptions options;
  options.datapath = DatapathKind::float32;
  for (const CountConfig& config : all_configs({2, 8})) {
    const auto results = count(synthetic.trace.view(), {&config, 1}, options);
    ASSERT_EQ(results[0].counters->pixels_inside.value(), 8u);
    ASSERT_EQ(results[0].wrong_contributions, 0u) << describe(config);
    const auto exact = count(synthetic.trace.view(), {&config, 1});
    ASSERT_EQ(exact[0].counters->pixels_inside.value(), 0u);
  }
}

TEST(Count, PassAndFailAgreeOnClosedUmbraVolumes) {
  for (unsigned seed = 1; seed <= repetitions(20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const traces::Trace trace = test::random_tetrahedra(random, 60, 50, 0);
    const std::vector<CountConfig> configs{
        {.z = ZChoice::pass}, {.z = ZChoice::fail}, {.mode = Mode::three_pass, .z = ZChoice::fail}};
    CountOptions options;
    options.maps = true;
    const auto results = count(trace.view(), configs, options);
    EXPECT_EQ(results[0].li, results[1].li);
    EXPECT_EQ(results[0].li, results[2].li);
  }
}

TEST(Count, ComparesWithTheExpectedLightIntensity) {
  std::mt19937 random(3);
  traces::Trace trace = test::random_tetrahedra(random, 40, 30, 5);
  const CountConfig config;
  CountOptions options;
  options.maps = true;
  const auto exact = count(trace.view(), {&config, 1}, options);
  for (std::int64_t word : exact[0].li) {
    trace.expected_li.push_back(static_cast<double>(word) / word_one(DatapathKind::exact));
  }
  trace.li_sensitivity.assign(trace.depth.size(), 0.0F);
  EXPECT_EQ(count(trace.view(), {&config, 1})[0].pixels.max_error, 0.0);
  trace.expected_li[45] += 0.25;    // (5, 1)
  trace.li_sensitivity[45] = 0.5F;  // explains it
  trace.expected_li[83] -= 0.125;   // (3, 2)
  trace.expected_li[84] -= 0.5e-6;  // within tolerance
  const PixelCheck check = count(trace.view(), {&config, 1})[0].pixels;
  EXPECT_EQ(check.compared, 1200u);
  EXPECT_EQ(check.mismatched, 1u);
  EXPECT_DOUBLE_EQ(check.max_error, 0.25);
  EXPECT_NEAR(check.rms_error, 0.125 / std::sqrt(1199.0), 1e-12);
  ASSERT_EQ(check.worst.size(), 3u);
  EXPECT_EQ(check.worst[0].x, 5);
  EXPECT_EQ(check.worst[0].y, 1);
  EXPECT_DOUBLE_EQ(check.worst[1].error, 0.125);
}

TEST(Count, LeavesOutTheSkyUnderTheOtherZMethod) {
  std::mt19937 random(3);
  traces::Trace trace = test::random_tetrahedra(random, 40, 30, 2);
  const auto sky = static_cast<std::uint64_t>(std::count(
      trace.depth.begin(), trace.depth.end(), traces::sky_word(trace.header.depth_format)));
  ASSERT_GT(sky, 0u);
  trace.expected_li.assign(trace.depth.size(), 1.0);
  const std::vector<CountConfig> configs{{.z = ZChoice::pass}, {.z = ZChoice::fail}};
  const auto results = count(trace.view(), configs);
  EXPECT_EQ(results[0].pixels.compared, 1200u);
  EXPECT_EQ(results[1].pixels.compared, 1200u - sky);
}

TEST(Count, RefusesZPassWhereTheTraceNeedsZFail) {
  SyntheticTrace synthetic(4, 4, 0.5);
  synthetic.trace.header.z_fail_needed = true;
  const CountConfig pass{.z = ZChoice::pass};
  EXPECT_THROW(count(synthetic.trace.view(), {&pass, 1}), InputError);
  const CountConfig automatic;
  EXPECT_EQ(count(synthetic.trace.view(), {&automatic, 1})[0].z, ZMethod::fail);
}

TEST(Count, CountsSumsOutOfRange) {
  // 20 polygons that all pass leave 1 - 20 in LI; the stencil holds -20 well.
  SyntheticTrace synthetic(2, 2, 0.5);
  const std::uint32_t plane = synthetic.add_plane(0, 0, 1, -0.2);
  for (int i = 0; i < 20; ++i) {
    synthetic.add_umbra({{0, 0, 0.2}, {1, 0, 0.2}, {1, 2, 0.2}, {0, 2, 0.2}}, Facing::eye, plane,
                        traces::kNone);
  }
  const std::vector<CountConfig> configs{{Mode::single_pass}, {Mode::three_pass}};
  const auto results = count(synthetic.trace.view(), configs);
  EXPECT_EQ(results[0].counters->li_overflow_pixels.value(), 2u);
  EXPECT_EQ(results[1].counters->li_overflow_pixels.value(), 2u);
  EXPECT_EQ(results[0].counters->contributions_max.value(), 20u);
}

TEST(Count, TakesMinusZeroForZeroInDepthIntervals) {
  // Half of the frame is at depth 0, where the wedge and its polygon end: inside, and not beyond.
  SyntheticTrace synthetic(8, 8, 0.0);
  for (std::uint32_t i = 0; i < 32; ++i) synthetic.set_depth(i % 8, i / 8, 0.5);
  const std::vector<test::Point> all{{0, 0, -0.0}, {8, 0, -0.0}, {8, 8, -0.0}, {0, 8, -0.0}};
  const std::uint32_t everywhere = synthetic.add_plane(0, 0, 0, 1);
  synthetic.add_face(all, Facing::eye, everywhere);
  const std::uint32_t wedge =
      synthetic.add_wedge(traces::fb::WedgeKind_coverage, {everywhere}, -0.0, -0.0);
  const std::uint32_t nowhere = synthetic.add_plane(0, 0, 0, -1);
  synthetic.add_umbra(all, Facing::eye, nowhere, wedge);
  ASSERT_TRUE(std::signbit(synthetic.trace.wedges[0].z_max()));
  ASSERT_TRUE(std::signbit(synthetic.trace.umbra_polygons[0].z_max()));
  const CountConfig config;
  CountOptions options;
  options.maps = true;
  const auto simd = count(synthetic.trace.view(), {&config, 1}, options);
  options.kernel = KernelChoice::scalar;
  const auto scalar = count(synthetic.trace.view(), {&config, 1}, options);
  EXPECT_EQ(scalar[0].counters->pixels_inside.value(), 32u);
  EXPECT_EQ(simd[0].counters->pixels_inside.value(), 32u);
  EXPECT_EQ(simd[0].li, scalar[0].li);
}

TEST(Count, RefusesMoreContributionsThanAPixelCanSum) {
  // One umbra polygon over pixel (9, 2) alone, listed again and again.
  SyntheticTrace synthetic(12, 4, 0.5);
  const std::uint32_t plane = synthetic.add_plane(0, 0, 1, -0.2);
  synthetic.add_umbra({{9, 2, 0.2}, {10, 2, 0.2}, {10, 3, 0.2}, {9, 3, 0.2}}, Facing::eye, plane,
                      traces::kNone);
  auto& polygons = synthetic.trace.umbra_polygons;
  polygons.resize((1U << 20) - 1, polygons.front());
  const CountConfig config;
  const auto most = count(synthetic.trace.view(), {&config, 1});
  EXPECT_EQ(most[0].counters->contributions_max.value(), 1048575u);
  polygons.push_back(polygons.front());
  try {
    count(synthetic.trace.view(), {&config, 1});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("pixel 9,2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("1048575"), std::string::npos) << error.what();
  }
}

TEST(Count, Paper255CountsInIntegers) {
  std::mt19937 random(5);
  const traces::Trace trace = test::random_tetrahedra(random, 40, 30, 5);
  const CountConfig config;
  CountOptions options;
  options.maps = true;
  const auto exact = count(trace.view(), {&config, 1}, options);
  options.datapath = DatapathKind::paper255;
  const auto paper = count(trace.view(), {&config, 1}, options);
  const auto most = static_cast<double>(paper[0].counters->contributions_max.value());
  bool shaded = false;
  for (std::size_t i = 0; i < trace.depth.size(); ++i) {
    const double li = static_cast<double>(exact[0].li[i]) / word_one(DatapathKind::exact);
    EXPECT_NEAR(static_cast<double>(paper[0].li[i]), 255.0 * li, 0.5 * most + 1e-6);
    shaded = shaded || paper[0].li[i] != 255;
  }
  EXPECT_TRUE(shaded);
}

}  // namespace
}  // namespace wedgesim::model

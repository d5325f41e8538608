// Are the words of the plain evaluation those of model::count, and does it see what is wrong?
#include "reports/stress/evaluate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "functional/methods/frame.h"
#include "functional/reference/judge.h"
#include "functional/scene/scene_file.h"
#include "model/count/count.h"
#include "reports/stress/case_name.h"
#include "reports/stress/frame.h"

namespace wedgesim::reports::stress {
namespace {

namespace fb = traces::fb;

TEST(Evaluate, GivesTheWordsOfCount) {
  for (const char* scene : {"plain-columns", "eye-in-shadow"}) {
    for (const auto kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
      functional::SceneOptions scene_options;
      scene_options.size = std::pair(96, 64);
      functional::FrameOptions options;
      options.kind = kind;
      const functional::Frame frame =
          functional::make_frame(functional::load_scene(scene, scene_options), options);
      ASSERT_GT(frame.trace.wedges.size(), 10U);
      for (const auto datapath :
           {model::DatapathKind::exact, model::DatapathKind::fixed, model::DatapathKind::float32}) {
        model::CountOptions count_options;
        count_options.datapath = datapath;
        count_options.maps = true;
        const auto counted =
            model::count(frame.trace.view(), std::vector{model::CountConfig{}}, count_options);
        const Evaluation plain = evaluate(frame.trace.view(), method_of(frame), datapath);
        EXPECT_EQ(plain.sums, counted.front().li) << scene << kind;
        EXPECT_GT(plain.visits, 100U);
        EXPECT_EQ(plain.not_finite, 0U);
      }
    }
  }
}

// The largest error against the judge beyond sensitivity.
double worst(const Case& made, const functional::Frame& judged, const traces::Trace& trace) {
  std::vector<std::size_t> pixels(trace.depth.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = i;
  const auto judge = functional::judge_light_intensity(made.scene, judged, pixels);
  const model::Datapath exact;
  const auto li = li_of(evaluate(trace.view(), method_of(judged), exact).sums, exact);
  double most = 0.0;
  for (std::size_t i = 0; i < li.size(); ++i) {
    most = std::max(
        most, std::fabs(li[i] - judge[i]) - static_cast<double>(judged.trace.li_sensitivity[i]));
  }
  return most;
}

TEST(Evaluate, APlantedErrorShows) {
  const Case made = parse_case("name", "distance-ratio,0,1").make();
  const functional::Frame frame = frame_of(made);
  EXPECT_LT(worst(made, frame, frame.trace), 1e-9);
  traces::Trace moved = frame.trace;
  for (fb::Plane& plane : moved.planes) {
    plane = fb::Plane(plane.a(), plane.b(), plane.c(), plane.d() * (1.0 + 1e-3));
  }
  EXPECT_GT(worst(made, frame, moved), 1e-3);
  traces::Trace fewer = frame.trace;
  fewer.umbra_polygons.pop_back();
  fewer.wedges.pop_back();
  EXPECT_GT(worst(made, frame, fewer), 0.1);
}

TEST(Evaluate, CountsWrongSigns) {
  const Case made = parse_case("name", "distance-ratio,0,1").make();
  const functional::Frame frame = frame_of(made);
  const Evaluation exact = evaluate(frame.trace.view(), method_of(frame), {});
  EXPECT_GT(exact.signs, 1000U);
  EXPECT_EQ(exact.wrong_signs, 0U);
  const Case hard = parse_case("name", "on-side-plane,0,0").make();
  const functional::Frame on_plane = frame_of(hard);
  const Evaluation single =
      evaluate(on_plane.trace.view(), method_of(on_plane), model::DatapathKind::float32);
  EXPECT_GT(single.wrong_signs, 0U);
  // Umbra polygons without a wedge, whose planes alone decide.
  functional::Frame lone = frame_of(parse_case("name", "found,0,19").make());
  const auto of_polygons = [&] {
    return evaluate(lone.trace.view(), method_of(lone), model::DatapathKind::float32);
  };
  EXPECT_GT(of_polygons().wrong_signs, 0U);
  lone.trace.wedges.clear();
  EXPECT_GT(of_polygons().wrong_signs, 0U);
}

TEST(WedgesAt, FindsThoseThatCoverAPixel) {
  const functional::Frame frame = frame_of(parse_case("name", "frame-size,0,0").make());
  const Evaluation plain = evaluate(frame.trace.view(), method_of(frame), {});
  std::vector<std::size_t> pixels(frame.trace.depth.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = i;
  const auto wedges = wedges_at(frame.trace.view(), pixels);
  std::size_t most = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    EXPECT_GE(wedges[i].size(), plain.contributions[i]);
    most = std::max(most, wedges[i].size());
  }
  EXPECT_GT(most, 0U);
  EXPECT_LE(most, frame.trace.wedges.size());
}

}  // namespace
}  // namespace wedgesim::reports::stress

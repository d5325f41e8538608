#include "reports/stress/shrink.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "functional/methods/light_intensity.h"
#include "functional/reference/judge.h"
#include "functional/scene/origin.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/frame_parts.h"
#include "reports/stress/replay.h"
#include "reports/table.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Frame;

// What single parts of a case's frame add to a pixel's LI.
class Shares {
 public:
  Shares(const Case& stress_case, Arithmetic arithmetic, std::size_t pixel)
      : case_(stress_case), arithmetic_(arithmetic), pixel_(pixel), frame_(frame_of(stress_case)) {}

  std::vector<Culprit> all() const {
    PartFrame alone(frame_);
    std::vector<Culprit> culprits;
    for (const Part& part : parts_of(frame_)) {
      Culprit culprit;
      culprit.wedge = part.wedge;
      culprit.polygon = part.polygon;
      const Frame& frame = alone.only(part);
      culprit.li = li_of_part(frame);
      culprit.judge =
          functional::judge_light_intensity(case_.scene, frame, std::array{pixel_}).front() - 1.0;
      find_edge(part, culprit);
      culprits.push_back(culprit);
    }
    return culprits;
  }

 private:
  double li_of_part(const Frame& frame) const {
    if (arithmetic_ == Arithmetic::renderer) {
      const functional::Scene scene = functional::taken_from(case_.scene, frame.origin);
      const functional::Window window =
          functional::make_window(scene.camera, scene.width, scene.height);
      const auto li =
          functional::evaluate_light_intensity(scene, window, frame.depth, frame.geometry,
                                               frame.trace, frame.trace.header.expected_z_method);
      return li.li[pixel_] - 1.0;
    }
    const model::Datapath datapath = datapath_of(arithmetic_, case_);
    const Evaluation evaluation = evaluate(frame.trace.view(), method_of(frame), datapath);
    return static_cast<double>(evaluation.sums[pixel_]) / datapath.one() - 1.0;
  }

  void find_edge(const Part& part, Culprit& culprit) const {
    functional::EdgeSource source;
    if (part.polygon) source = frame_.geometry.umbra_sources[*part.polygon].edge;
    if (part.wedge) source = frame_.geometry.wedges[*part.wedge].source;
    if (part.bare) source = frame_.geometry.bare_edges[*part.bare].source;
    culprit.has_edge = source.begin != source.end;
    if (culprit.has_edge) {
      const auto& positions = case_.scene.objects[source.object].mesh.positions;
      culprit.begin = positions[source.begin];
      culprit.end = positions[source.end];
    }
  }

  const Case& case_;
  Arithmetic arithmetic_;
  std::size_t pixel_;
  Frame frame_;
};

// The first so many culprits whose errors together exceed the bar.
void keep_fewest(Shrunk& shrunk) {
  const double sign = shrunk.li > shrunk.judge ? 1.0 : -1.0;
  std::ranges::stable_sort(shrunk.culprits, std::ranges::greater(),
                           [sign](const Culprit& c) { return sign * c.error(); });
  const double bar = tolerance_of(shrunk.arithmetic) + shrunk.sensitivity;
  double sum = 0.0;
  std::size_t kept = 0;
  while (kept < shrunk.culprits.size() && sum <= bar) sum += sign * shrunk.culprits[kept++].error();
  const bool has_left_word = std::fabs(shrunk.sum - shrunk.li) > bar;
  shrunk.culprits.resize(sum > bar && !has_left_word ? kept : 0);
}

std::string point_text(const glm::dvec3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

}  // namespace

std::optional<Shrunk> shrink(const Case& stress_case, const Measurement& measurement,
                             Arithmetic arithmetic) {
  const std::vector<std::size_t> worst = worst_pixels(measurement, arithmetic, 1);
  if (worst.empty()) return {};
  const std::size_t pixel = worst.front();
  if (excess_at(measurement, arithmetic, pixel) <= tolerance_of(arithmetic)) return {};
  Shrunk shrunk;
  shrunk.arithmetic = arithmetic;
  shrunk.x = static_cast<int>(pixel) % measurement.width;
  shrunk.y = static_cast<int>(pixel) / measurement.width;
  shrunk.li = measurement.errors[static_cast<std::size_t>(arithmetic)].li[pixel];
  shrunk.judge = measurement.judge[pixel];
  shrunk.sensitivity = measurement.sensitivities[pixel];
  shrunk.culprits = Shares(stress_case, arithmetic, pixel).all();
  shrunk.parts = shrunk.culprits.size();
  shrunk.sum = 1.0;
  for (const Culprit& culprit : shrunk.culprits) shrunk.sum += culprit.li;
  keep_fewest(shrunk);
  return shrunk;
}

std::string shrunk_text(const Shrunk& shrunk) {
  using Align = Table::Align;
  std::string text = fmt::format(
      "{}: pixel {},{} has LI {:.9f}, the judge {:.9f}; sensitivity {:.2e}, tolerance {:.2e}\n",
      name_of(shrunk.arithmetic), shrunk.x, shrunk.y, shrunk.li, shrunk.judge, shrunk.sensitivity,
      tolerance_of(shrunk.arithmetic));
  if (shrunk.culprits.empty()) {
    return text + fmt::format(
                      "no edge is to blame: all {} edges and polygons add up to {:.9f}, "
                      "which leaves LI's word\n",
                      shrunk.parts, shrunk.sum);
  }
  text += fmt::format("{} of {} edges and polygons alone pass the bar there:\n",
                      shrunk.culprits.size(), shrunk.parts);
  Table table;
  for (const char* title : {"wedge", "polygon", "LI share", "judge's", "error"}) {
    table.add_column(title, Align::right);
  }
  table.add_column("edge", Align::left);
  for (const Culprit& c : shrunk.culprits) {
    table.add_row({c.wedge ? std::to_string(*c.wedge) : "-",
                   c.polygon ? std::to_string(*c.polygon) : "-", fmt::format("{:.9f}", c.li),
                   fmt::format("{:.9f}", c.judge), fmt::format("{:.2e}", c.error()),
                   c.has_edge ? point_text(c.begin) + " to " + point_text(c.end) : ""});
  }
  return text + table.text(2);
}

}  // namespace wedgesim::reports::stress

#include "reports/stress/measure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"
#include "reports/stress/configurations.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/judged.h"
#include "reports/stress/jumps.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Frame;

class Measuring {
 public:
  explicit Measuring(const Case& stress_case)
      : case_(stress_case), frame_(frame_of(stress_case)), judged_(case_, frame_) {}

  Measurement run() {
    result_.width = frame_.window.width;
    result_.height = frame_.window.height;
    result_.wedges = frame_.trace.wedges.size();
    result_.degenerate_wedges = frame_.geometry.degenerate_wedges;
    result_.judged = judged_.pixels().size();
    result_.condition = condition();
    result_.judge_seconds = judged_.seconds();
    result_.judge.assign(frame_.trace.depth.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = 0; k < judged_.pixels().size(); ++k) {
      result_.judge[judged_.pixels()[k]] = judged_.li(k);
    }
    roundings_ = trace_roundings(frame_.trace.view(), method_of(frame_));
    // The exact datapath first: it says where penumbrae are.
    evaluate_datapath(Arithmetic::double_precision);
    evaluate_datapath(Arithmetic::fixed);
    evaluate_datapath(Arithmetic::float32);
    li_[index(Arithmetic::renderer)] = frame_.trace.expected_li;
    result_.errors[index(Arithmetic::renderer)].not_finite =
        static_cast<std::uint64_t>(std::ranges::count_if(
            frame_.trace.expected_li, [](double li) { return !std::isfinite(li); }));
    // It computes in double, too.
    result_.flagged[index(Arithmetic::renderer)] =
        result_.flagged[index(Arithmetic::double_precision)];
    refine();
    look_for_jumps();
    const std::vector<JudgedPixel> pixels = judged_pixels();
    for (const Arithmetic arithmetic : kArithmetics) hold(arithmetic, pixels);
    return std::move(result_);
  }

 private:
  static std::size_t index(Arithmetic arithmetic) { return static_cast<std::size_t>(arithmetic); }

  double condition() const {
    double worst = 1.0;
    const glm::dvec3 centre = case_.scene.light.centre - frame_.origin;
    const auto size = [&](const glm::dvec3& p) { return glm::length(p + frame_.origin); };
    for (const functional::ShadowWedge& wedge : frame_.geometry.wedges) {
      const glm::dvec3 a = wedge.begin - centre;
      const glm::dvec3 b = wedge.end - centre;
      const double largest = std::max({size(wedge.begin), size(wedge.end), size(centre)});
      const double area = glm::length(glm::cross(a, b));
      worst = std::max(worst, largest * (glm::length(a) + glm::length(b)) / area);
    }
    return worst;
  }

  void evaluate_datapath(Arithmetic arithmetic) {
    const traces::TraceView view = frame_.trace.view();
    const model::Datapath datapath = datapath_of(arithmetic, case_);
    Evaluation evaluation = evaluate(view, method_of(frame_), datapath);
    Errors& errors = result_.errors[index(arithmetic)];
    errors.signs = evaluation.signs;
    errors.wrong_signs = evaluation.wrong_signs;
    errors.not_finite = evaluation.not_finite;
    errors.saturated = evaluation.saturated;
    errors.visits = evaluation.visits;
    errors.seconds = evaluation.seconds;
    if (arithmetic == Arithmetic::fixed) {  // the others have wide words
      errors.overflowed = static_cast<std::uint64_t>(std::ranges::count_if(
          evaluation.sums, [&](std::int64_t sum) { return !datapath.li_holds(sum); }));
    }
    li_[index(arithmetic)] = li_of(evaluation.sums, datapath);
    const bool agree = configurations_agree(frame_, datapath, evaluation.sums);
    result_.configurations_agree = result_.configurations_agree && agree;
    if (arithmetic == Arithmetic::double_precision) exact_ = evaluation;
    result_.flagged[index(arithmetic)] = flag(view, datapath, evaluation, exact_, roundings_);
  }

  void refine() {
    std::vector<std::size_t> wanted;
    for (std::size_t k = 0; k < judged_.pixels().size(); ++k) {
      for (const Arithmetic arithmetic : kArithmetics) {
        const double error = li_[index(arithmetic)][judged_.pixels()[k]] - judged_.li(k);
        if (!(std::fabs(error) <= tolerance_of(arithmetic))) {
          wanted.push_back(k);
          break;
        }
      }
    }
    if (!wanted.empty()) judged_.refine(wanted);
    result_.sensitivities = judged_.sensitivities();
  }

  void look_for_jumps() {
    const auto jumps = largest_jumps(case_, frame_, judged_.pixels());
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      result_.errors[i].jump = jumps[i].largest;
      result_.errors[i].not_finite += jumps[i].not_finite;
    }
  }

  std::vector<JudgedPixel> judged_pixels() {
    std::vector<JudgedPixel> pixels;
    for (std::size_t k = 0; k < judged_.pixels().size(); ++k) {
      const std::size_t pixel = judged_.pixels()[k];
      pixels.push_back(
          {pixel, judged_.li(k), judged_.sensitivity(k), exact_.contributions[pixel] > 0});
      result_.in_penumbra += pixels.back().in_wedge && is_quiet(pixels.back()) ? 1 : 0;
    }
    return pixels;
  }

  void hold(Arithmetic arithmetic, const std::vector<JudgedPixel>& pixels) {
    Errors& errors = result_.errors[index(arithmetic)];
    errors.li = li_[index(arithmetic)];
    count_unflagged(arithmetic, compare(errors.li, pixels, result_.width, arithmetic, errors));
    errors.holds = holds(errors, arithmetic);
  }

  void count_unflagged(Arithmetic arithmetic, const std::vector<std::size_t>& beyond) {
    if (beyond.empty()) return;
    const auto wedges = wedges_at(frame_.trace.view(), beyond);
    const std::vector<Flagged>& flagged = result_.flagged[index(arithmetic)];
    const auto is_flagged = [&](std::uint32_t number, bool foreseen) {
      const auto at = std::ranges::lower_bound(flagged, number, {}, &Flagged::wedge);
      return at != flagged.end() && at->wedge == number && (!foreseen || at->foreseen);
    };
    Errors& errors = result_.errors[index(arithmetic)];
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      const auto& at_pixel = wedges[i];
      const auto none = [&](bool foreseen) {
        return std::ranges::none_of(
            at_pixel, [&](std::uint32_t number) { return is_flagged(number, foreseen); });
      };
      errors.unflagged += none(false) ? 1 : 0;
      errors.unforeseen += none(true) ? 1 : 0;
    }
  }

  const Case& case_;
  Measurement result_;
  Frame frame_;
  Judged judged_;
  std::array<std::vector<double>, kArithmetics.size()> li_;  // (height, width)
  Evaluation exact_;
  std::vector<TraceRounding> roundings_;
};

}  // namespace

Measurement measure(const Case& stress_case) {
  try {
    return Measuring(stress_case).run();
  } catch (const InputError& error) {
    Measurement refused;
    refused.refused = error.what();
    return refused;
  }
}

}  // namespace wedgesim::reports::stress

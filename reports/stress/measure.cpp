#include "reports/stress/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"
#include "model/count/count.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "reports/stress/judged.h"
#include "reports/stress/jumps.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Frame;

constexpr double kQuiet = 1.0 / 255.0;

struct Root {
  double sum = 0.0;
  std::uint64_t count = 0;
  void add(double x) {
    sum += x * x;
    ++count;
  }
  double value() const { return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)); }
};

// Pixels off by more than half beyond their sensitivity without such a pixel beside them.
std::uint64_t count_specks(const std::vector<bool>& off, int width, int height) {
  std::uint64_t specks = 0;
  const auto is_off = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height &&
           off[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!is_off(x, y)) continue;
      int beside = -1;  // itself
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) beside += is_off(x + dx, y + dy) ? 1 : 0;
      }
      specks += beside == 0 ? 1 : 0;
    }
  }
  return specks;
}

class Measuring {
 public:
  explicit Measuring(const Case& stress_case)
      : case_(stress_case), frame_(frame_of(stress_case)), judged_(timed_judge()) {}

  Measurement run() {
    result_.width = frame_.window.width;
    result_.height = frame_.window.height;
    result_.wedges = frame_.trace.wedges.size();
    result_.degenerate_wedges = frame_.geometry.degenerate_wedges;
    result_.judged = judged_.pixels().size();
    result_.condition = condition();
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
    const auto jumps = largest_jumps(case_, frame_, judged_.pixels());
    for (std::size_t i = 0; i < jumps.size(); ++i) result_.errors[i].jump = jumps[i];
    for (const Arithmetic arithmetic : kArithmetics) compare(arithmetic);
    return std::move(result_);
  }

 private:
  static std::size_t index(Arithmetic arithmetic) { return static_cast<std::size_t>(arithmetic); }

  Judged timed_judge() {
    const auto start = std::chrono::steady_clock::now();
    Judged judged(case_, frame_);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    result_.judge_seconds = spent.count();
    return judged;
  }

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
    check_configurations(datapath, evaluation.sums);
    if (arithmetic == Arithmetic::double_precision) exact_ = evaluation;
    result_.flagged[index(arithmetic)] = flag(view, datapath, evaluation, exact_, roundings_);
  }

  void check_configurations(const model::Datapath& datapath,
                            const std::vector<std::int64_t>& sums) {
    using namespace model;  // NOLINT: the vocabulary of configurations
    const std::array configs{
        CountConfig{Mode::three_pass, 2, Cull::none, UmbraCull::none},
        CountConfig{Mode::single_pass, 4, Cull::sat, UmbraCull::zmax, Accept::zmin, Share::all},
        CountConfig{Mode::single_pass, 8, Cull::both, UmbraCull::zmax},
        CountConfig{Mode::three_pass, 16, Cull::planes, UmbraCull::zmax, Accept::zmin},
        CountConfig{Mode::single_pass, 64, Cull::zmax, UmbraCull::none},
    };
    CountOptions options;
    options.threads = 1;
    options.maps = true;
    options.datapath = datapath;
    for (const CountResult& result : count(frame_.trace.view(), configs, options)) {
      const bool agrees = result.wrong_contributions == 0 && result.li == sums;
      result_.configurations_agree = result_.configurations_agree && agrees;
    }
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
    for (const std::size_t k : wanted) {
      result_.sensitivity = std::max(result_.sensitivity, judged_.sensitivity(k));
    }
  }

  void compare(Arithmetic arithmetic) {
    const std::vector<double>& li = li_[index(arithmetic)];
    Errors& errors = result_.errors[index(arithmetic)];
    Root all;
    Root penumbra;
    std::vector<bool> half_off(li.size(), false);
    std::vector<std::size_t> beyond;
    for (std::size_t k = 0; k < judged_.pixels().size(); ++k) {
      const std::size_t pixel = judged_.pixels()[k];
      const double error = std::fabs(li[pixel] - judged_.li(k));
      const double sensitivity = judged_.sensitivity(k);
      errors.max_error = std::max(errors.max_error, error);
      errors.max_excess = std::max(errors.max_excess, error - sensitivity);
      errors.off += error > 1.0 / 255.0 ? 1 : 0;
      const bool is_beyond = !(error <= tolerance_of(arithmetic) + sensitivity);
      if (is_beyond) beyond.push_back(pixel);
      half_off[pixel] = error > 0.5 + sensitivity;
      if (exact_.contributions[pixel] == 0 && error > 0.0 && sensitivity == 0.0 &&
          std::fabs(judged_.li(k) - std::nearbyint(judged_.li(k))) < 1e-12) {
        errors.leaks += std::fabs(li[pixel] - std::nearbyint(judged_.li(k))) > 0.0 ? 1 : 0;
      }
      if (sensitivity <= kQuiet) {
        all.add(error);
        if (exact_.contributions[pixel] > 0) penumbra.add(error);
      }
    }
    errors.beyond = beyond.size();
    errors.rms = all.value();
    errors.rms_penumbra = penumbra.value();
    result_.in_penumbra = penumbra.count;
    errors.specks = count_specks(half_off, result_.width, result_.height);
    errors.li = li;
    const bool wide = tolerance_of(arithmetic) > 1e-6;
    errors.holds = errors.beyond == 0 && errors.specks == 0 && errors.not_finite == 0 &&
                   errors.leaks == 0 && errors.jump <= largest_jump_of(arithmetic) &&
                   (!wide || (errors.rms <= kLargestRms && errors.rms_penumbra <= kLargestRms));
    count_unflagged(arithmetic, beyond);
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

#include "tests/reports/stress/random_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "functional/reference/judge.h"
#include "functional/scene/scene_check.h"
#include "reports/stress/configurations.h"
#include "reports/stress/errors.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/flag.h"
#include "reports/stress/frame.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Frame;

constexpr double kExact = tolerance_of(Arithmetic::double_precision);
constexpr double kFixed = tolerance_of(Arithmetic::fixed);
constexpr std::size_t kDescribed = 12;  // faults

class Probing {
 public:
  Probing(const Case& random_case, const Planted& planted) : case_(random_case) {
    functional::check_scene(case_.scene, case_.scene.place);
    frame_ = functional::make_frame(case_.scene, case_.options);
    renderer_ = frame_.trace.expected_li;
    exact_ = evaluate_with(model::DatapathKind::exact, exact_evaluation_);
    fixed_ = evaluate_with(model::DatapathKind::fixed, fixed_evaluation_);
    for (const auto& [name, li] :
         {std::pair{"renderer", &renderer_}, {"exact", &exact_}, {"fixed", &fixed_}}) {
      if (planted.arithmetic == name) li->at(planted.pixel) += planted.li;
    }
  }

  Probe run(bool judge_all) {
    result_.wedges = frame_.trace.wedges.size();
    check_finite();
    const std::uint32_t sky = traces::sky_word(frame_.depth.format);
    for (std::size_t i = 0; i < renderer_.size(); ++i) {
      const double li = renderer_[i];
      result_.penumbra += std::fabs(li - std::nearbyint(li)) > kExact ? 1.0 : 0.0;
      if (frame_.trace.depth[i] != sky && (judge_all || disagree(i))) pixels_.push_back(i);
    }
    result_.penumbra /= static_cast<double>(renderer_.size());
    result_.judged = pixels_.size();
    if (!pixels_.empty()) judge();
    excuse();
    return std::move(result_);
  }

 private:
  std::vector<double> evaluate_with(model::DatapathKind kind, Evaluation& evaluation) {
    const traces::TraceView view = frame_.trace.view();
    const model::Datapath datapath(kind);
    evaluation = evaluate(view, method_of(frame_), datapath);
    if (evaluation.not_finite > 0) {
      complain(kind, fmt::format("{} contributions are no number", evaluation.not_finite));
    }
    if (!configurations_agree(frame_, datapath, evaluation.sums)) {
      complain(kind, "configurations disagree");
    }
    std::vector<double> li;
    for (const std::int64_t sum : evaluation.sums) {
      if (!datapath.li_holds(sum)) complain(kind, "LI leaves its word");
      li.push_back(static_cast<double>(sum) / datapath.one());
    }
    return li;
  }

  void complain(model::DatapathKind kind, const std::string& what) {
    const std::string line = fmt::format("{}: {}", model::spelling(kind), what);
    if (std::ranges::find(result_.broken, line) == result_.broken.end()) {
      result_.broken.push_back(line);
    }
  }

  void check_finite() {
    const auto finite = [](double value) { return std::isfinite(value); };
    if (!std::ranges::all_of(renderer_, finite)) result_.broken.emplace_back("renderer: NaN");
    if (!std::ranges::all_of(frame_.trace.li_sensitivity, finite)) {
      result_.broken.emplace_back("renderer: sensitivity NaN");
    }
  }

  bool disagree(std::size_t i) const {
    const double sensitivity = frame_.trace.li_sensitivity[i];
    return !(std::fabs(exact_[i] - renderer_[i]) <= kExact + sensitivity) ||
           !(std::fabs(fixed_[i] - renderer_[i]) <= kFixed + sensitivity);
  }

  void judge() {
    const functional::Judgement judged =
        functional::judge_with_sensitivity(case_.scene, frame_, pixels_);
    for (std::size_t k = 0; k < pixels_.size(); ++k) {
      hold("renderer", renderer_, kExact, k, judged.li[k], judged.sensitivity[k]);
      hold("exact", exact_, kExact, k, judged.li[k], judged.sensitivity[k]);
      hold("fixed", fixed_, kFixed, k, judged.li[k], judged.sensitivity[k]);
    }
  }

  void hold(const char* arithmetic, const std::vector<double>& li, double tolerance, std::size_t k,
            double judged, double sensitivity) {
    const double own = li[pixels_[k]];
    if (std::fabs(own - judged) <= tolerance + sensitivity) return;
    result_.faults.push_back({arithmetic, pixels_[k], own, judged, sensitivity, false});
  }

  // A fault at a primitive that the arithmetic itself foresees to be in doubt is no surprise. The
  // renderer computes in double precision.
  void excuse() {
    if (result_.faults.empty()) return;
    const traces::TraceView view = frame_.trace.view();
    std::vector<std::size_t> pixels;
    for (const Fault& fault : result_.faults) pixels.push_back(fault.pixel);
    const auto primitives = wedges_at(view, pixels);
    const auto roundings = trace_roundings(view, method_of(frame_));
    const auto of_exact =
        flag(view, model::DatapathKind::exact, exact_evaluation_, exact_evaluation_, roundings);
    const auto of_fixed =
        flag(view, model::DatapathKind::fixed, fixed_evaluation_, exact_evaluation_, roundings);
    const auto is_foreseen = [&](std::size_t i, const std::vector<Flagged>& flags) {
      return std::ranges::any_of(primitives[i], [&](std::uint32_t primitive) {
        const auto at = std::ranges::find(flags, primitive, &Flagged::wedge);
        return at != flags.end() && at->foreseen;
      });
    };
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      Fault& fault = result_.faults[i];
      fault.foreseen = is_foreseen(i, fault.arithmetic == "fixed" ? of_fixed : of_exact);
    }
  }

  const Case& case_;
  Frame frame_;
  Evaluation exact_evaluation_, fixed_evaluation_;
  Probe result_;
  std::vector<double> renderer_, exact_, fixed_;  // (height, width)
  std::vector<std::size_t> pixels_;               // that the judge looks at
};

}  // namespace

Probe probe(const Case& random_case, bool judge_all, const Planted& planted) {
  std::optional<Probing> probing;
  try {
    probing.emplace(random_case, planted);
  } catch (const InputError& error) {
    Probe refused;
    refused.refused = error.what();
    return refused;
  }
  return probing->run(judge_all);
}

bool is_wrong(const Probe& probe) {
  return !probe.broken.empty() || !std::ranges::all_of(probe.faults, &Fault::foreseen);
}

std::string describe(const Probe& probe) {
  std::string text = fmt::format("{} faults\n", probe.faults.size());
  for (const std::string& line : probe.broken) text += line + '\n';
  for (std::size_t i = 0; i < std::min(probe.faults.size(), kDescribed); ++i) {
    const Fault& fault = probe.faults[i];
    text += fmt::format("{} at pixel {}, {}: LI {:.9g}, judge {:.9g}, sensitivity {:.3g}{}\n",
                        fault.arithmetic, fault.pixel % 8, fault.pixel / 8, fault.li, fault.judge,
                        fault.sensitivity, fault.foreseen ? ", foreseen" : "");
  }
  return text;
}

}  // namespace wedgesim::reports::stress

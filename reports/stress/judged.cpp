#include "reports/stress/judged.h"

#include "functional/reference/judge.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {

Judged::Judged(const Case& stress_case, const functional::Frame& frame)
    : case_(stress_case), frame_(frame) {
  const std::uint32_t sky = traces::sky_word(frame.depth.format);
  for (std::size_t i = 0; i < frame.trace.depth.size(); ++i) {
    if (frame.trace.depth[i] != sky) pixels_.push_back(i);
  }
  li_ = functional::judge_light_intensity(case_.scene, frame, pixels_, 0, &seconds_);
  sensitivity_.assign(frame.trace.li_sensitivity.begin(), frame.trace.li_sensitivity.end());
}

void Judged::refine(const std::vector<std::size_t>& wanted) {
  std::vector<std::size_t> at;
  for (const std::size_t k : wanted) at.push_back(pixels_[k]);
  const auto exact = functional::judge_with_sensitivity(case_.scene, frame_, at).sensitivity;
  for (std::size_t i = 0; i < at.size(); ++i) sensitivity_[at[i]] = exact[i];
}

}  // namespace wedgesim::reports::stress

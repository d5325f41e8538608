#include "reports/explain_check.h"

#include <cmath>

#include "model/count/contribution.h"

namespace wedgesim::reports {

bool held(const traces::TraceView& trace, const model::Explanation& explanation) {
  constexpr double kTolerance = 1e-6;  // of the exact datapath, as count has it
  if (!explanation.expected) return true;
  const bool trace_fails = trace.header.expected_z_method == traces::fb::ZMethod_fail;
  const bool same_method = trace_fails == (explanation.method == model::ZMethod::fail);
  if (explanation.sky && !same_method) return true;
  const auto pixel = static_cast<std::size_t>(explanation.y) * trace.header.width +
                     static_cast<std::size_t>(explanation.x);
  const double sensitivity =
      trace.li_sensitivity.empty() ? 0.0 : static_cast<double>(trace.li_sensitivity[pixel]);
  const double li = static_cast<double>(explanation.word) / model::word_one(model::LiFormat::exact);
  return std::abs(li - *explanation.expected) <= kTolerance + sensitivity;
}

}  // namespace wedgesim::reports

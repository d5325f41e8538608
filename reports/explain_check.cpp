#include "reports/explain_check.h"

#include "model/count/pixel_check.h"

namespace wedgesim::reports {

bool held(const traces::TraceView& trace, const model::Explanation& explanation) {
  const auto pixel = model::compare_pixel(trace, explanation.method, explanation.x, explanation.y,
                                          explanation.word, model::DatapathKind::exact);
  return !pixel || model::matches(*pixel, model::DatapathKind::exact);
}

}  // namespace wedgesim::reports

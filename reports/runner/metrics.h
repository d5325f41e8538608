#pragma once

#include <vector>

#include "model/count/count.h"
#include "reports/cycles.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// What a point's measurement gives, by name: every counter of the registry, the totals, the check
/// of the pixels, and for `cycles` the units, caches and memory.
Values metrics_of(const model::CountResult& result);
Values metrics_of(const CyclesReport& report);

/// Name, unit and meaning of every metric of `count`, of `cycles`, or of both.
std::vector<MetricInfo> metrics_of(bool count, bool cycles);

/// No pixel beyond its tolerance, and no contribution lost to a wrong test.
bool held(const PointRow& point);

}  // namespace wedgesim::reports

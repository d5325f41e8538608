#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/page/columns.h"

namespace wedgesim::reports::page {

/// Ratios of a metric between points that differ in one axis alone, `to` over `from`.
/// \param at  only points with this value of this column, if it is not null
std::vector<double> paired_ratios(const Columns& columns, const Column& metric, const Column& axis,
                                  const Value& from, const Value& to,
                                  const std::pair<const Column*, Value>& at = {});

// Findings from such pairs; none where the study has no such axis.

/// What single-pass changes against three-pass.
std::vector<std::string> mode_findings(const Columns& columns);
/// What the best culling leaves of the z reads, and how near it is to a perfect one.
std::vector<std::string> culling_findings(const Columns& columns);
/// Of each other axis the best value, and what the worst costs; what changes most comes first.
std::vector<std::string> setting_findings(const Columns& columns);

}  // namespace wedgesim::reports::page

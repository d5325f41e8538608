#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/page/columns.h"
#include "reports/page/statistics.h"

namespace wedgesim::reports::page {

/// What a study is judged by: the bits of varied widths, or cycles if it has them, else all bytes,
/// else accesses, else the first of its metrics that can be better or worse. Null if there is none.
const Column* judging_metric(const Columns& columns);

/// The configuration that is best over all frames.
struct Best {
  const Column* metric = nullptr;
  std::vector<std::pair<const Column*, Value>> settings;  // one an axis
  Spread value;                                           // of the metric, over frames
  Spread behind;  // times the best value of each frame, at least 1
};
/// Among the configurations measured on most frames, the one whose median distance to each frame's
/// best is least. Widths are judged by their pixels: of those with no pixel beyond its tolerance,
/// the narrowest.
std::optional<Best> find_best(const Columns& columns);

/// Up to `most` sentences, the weightiest first, each with its numbers.
std::vector<std::string> find_findings(const Columns& columns, std::size_t most = 3);

}  // namespace wedgesim::reports::page

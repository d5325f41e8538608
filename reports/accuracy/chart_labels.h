#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wedgesim::reports::accuracy {

/// The side of its mark that a label stands at.
enum class Side { right, left, above, below };

struct LabelledMark {
  double x = 0.0, y = 0.0;  // pixels in the chart, y downwards
  std::string text;
  bool on_front = false;
};

/// Where labels fit without covering a mark, an earlier label or the front's line, a stair from
/// each of its marks to the next, or leaving the chart. Marks that come first have the choice,
/// those on the front before all others, from left to right. None: a label fits nowhere.
std::vector<std::optional<Side>> place_labels(const std::vector<LabelledMark>& marks, double width,
                                              double height);

}  // namespace wedgesim::reports::accuracy

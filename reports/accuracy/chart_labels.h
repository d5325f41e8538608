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
  bool on_front = false;  // its line comes from above and leaves to the right
};

/// Where labels fit without covering a mark or an earlier label, or leaving the chart; those of
/// marks that come first have the choice. None: it fits nowhere.
std::vector<std::optional<Side>> place_labels(const std::vector<LabelledMark>& marks, double width,
                                              double height);

}  // namespace wedgesim::reports::accuracy

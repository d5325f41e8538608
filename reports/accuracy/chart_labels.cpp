#include "reports/accuracy/chart_labels.h"

#include <algorithm>
#include <array>

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kLetter = 6.2;  // width of one, pixels, at 11 pixels' height
constexpr double kLine = 12.0;   // height of a label
constexpr double kMark = 5.0;    // half the edge of a mark
constexpr double kGap = 3.0;     // between mark and label
constexpr double kStroke = 1.0;  // half the width of a line

using Sides = std::array<Side, 4>;
constexpr Sides kOnFront{Side::below, Side::left, Side::right, Side::above};
constexpr Sides kElsewhere{Side::right, Side::above, Side::left, Side::below};

struct Box {
  double left, top, right, bottom;
  bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

Box mark_box(const LabelledMark& mark) {
  return {mark.x - kMark, mark.y - kMark, mark.x + kMark, mark.y + kMark};
}

Box label_box(const LabelledMark& mark, Side side) {
  const auto letters = static_cast<double>(mark.text.size());
  const double width = kLetter * letters;
  const double away = kMark + kGap;
  switch (side) {
    case Side::right:
      return {mark.x + away, mark.y - kLine / 2, mark.x + away + width, mark.y + kLine / 2};
    case Side::left:
      return {mark.x - away - width, mark.y - kLine / 2, mark.x - away, mark.y + kLine / 2};
    case Side::above:
      return {mark.x - width / 2, mark.y - away - kLine, mark.x + width / 2, mark.y - away};
    case Side::below:
      return {mark.x - width / 2, mark.y + away, mark.x + width / 2, mark.y + away + kLine};
  }
  return {};
}

}  // namespace

std::vector<std::optional<Side>> place_labels(const std::vector<LabelledMark>& marks, double width,
                                              double height) {
  std::vector<Box> taken;
  for (const LabelledMark& mark : marks) taken.push_back(mark_box(mark));
  for (std::size_t i = 0; i + 1 < marks.size() && marks[i + 1].on_front; ++i) {
    const LabelledMark& a = marks[i];
    const LabelledMark& b = marks[i + 1];
    taken.push_back({a.x, a.y - kStroke, b.x, a.y + kStroke});
    taken.push_back({b.x - kStroke, a.y, b.x + kStroke, b.y});
  }
  std::vector<std::optional<Side>> sides;
  for (const LabelledMark& mark : marks) {
    std::optional<Side> found;
    for (const Side side : mark.on_front ? kOnFront : kElsewhere) {
      const Box box = label_box(mark, side);
      const bool inside =
          box.left >= 0.0 && box.right <= width && box.top >= 0.0 && box.bottom <= height;
      if (!inside || std::ranges::any_of(taken, [&](const Box& b) { return b.meets(box); })) {
        continue;
      }
      found = side;
      taken.push_back(box);
      break;
    }
    sides.push_back(found);
  }
  return sides;
}

}  // namespace wedgesim::reports::accuracy

#include "reports/sheet.h"

#include <algorithm>
#include <cmath>

namespace wedgesim::reports {
namespace {

constexpr int kGap = 4;  // between panels, pixels of the sheet
constexpr int kBox = 4;  // pixels drawn this large have a box
constexpr Colour kBlack{0.0F, 0.0F, 0.0F};
constexpr Colour kBetween{0.55F, 0.55F, 0.55F};

}  // namespace

Colour grey_of(double light) {
  if (!std::isfinite(light)) return kNoNumber;
  const auto grey = static_cast<float>(std::clamp(light, 0.0, 1.0));
  return {grey, grey, grey};
}

Colour difference_colour(double error, double saturation) {
  if (!std::isfinite(error)) return kNoNumber;
  const auto rest = static_cast<float>(1.0 - saturation);
  return error > 0.0 ? Colour{1.0F, rest, rest} : Colour{rest, rest, 1.0F};
}

Sheet::Sheet(int width, int height, int columns, int rows, int scale)
    : width_(width),
      height_(height),
      columns_(columns),
      scale_(scale),
      image_(extent(columns, width), extent(rows, height), 3) {
  for (int y = 0; y < image_.height; ++y) {
    for (int x = 0; x < image_.width; ++x) std::ranges::copy(kBetween, image_.pixel(x, y));
  }
}

void Sheet::add(const Panel& panel, const std::vector<bool>& boxed) {
  const int left = (count_ % columns_) * (width_ * scale_ + kGap);
  const int top = (count_ / columns_) * (height_ * scale_ + kGap);
  ++count_;
  const auto width = static_cast<std::size_t>(width_);
  for (std::size_t i = 0; i < panel.size(); ++i) {
    const int x = left + static_cast<int>(i % width) * scale_;
    const int y = top + static_cast<int>(i / width) * scale_;
    square(x, y, panel[i], !boxed.empty() && boxed[i] && scale_ >= kBox);
  }
}

int Sheet::extent(int panels, int pixels) const { return panels * (pixels * scale_ + kGap) - kGap; }

void Sheet::square(int left, int top, const Colour& colour, bool boxed) {
  for (int y = 0; y < scale_; ++y) {
    for (int x = 0; x < scale_; ++x) {
      const bool rim = x == 0 || y == 0 || x == scale_ - 1 || y == scale_ - 1;
      std::ranges::copy(boxed && rim ? kBlack : colour, image_.pixel(left + x, top + y));
    }
  }
}

}  // namespace wedgesim::reports

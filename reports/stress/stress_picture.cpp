#include "reports/stress/stress_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "reports/stress/replay.h"

namespace wedgesim::reports::stress {
namespace {

using Colour = std::array<float, 3>;
using Panel = std::vector<Colour>;  // (height, width) of the frame

constexpr int kGap = 4;             // between panels, pixels of the picture
constexpr int kVisible = 256;       // edge of a panel that is visible, pixels
constexpr int kBox = 4;             // pixels drawn this large have a box
constexpr int kLong = 8;            // frames this many times longer than high, or higher than long
constexpr float kMostWithin = 0.5;  // saturation at the bar
constexpr Colour kSky{0.30F, 0.35F, 0.42F};
constexpr Colour kNoNumber{1.0F, 0.0F, 1.0F};
constexpr Colour kBeyondBox{0.0F, 0.0F, 0.0F};
constexpr Colour kBetween{0.55F, 0.55F, 0.55F};

Panel li_panel(const Measurement& measurement, const std::vector<double>& li) {
  Panel panel;
  for (std::size_t i = 0; i < li.size(); ++i) {
    const auto grey = static_cast<float>(std::clamp(li[i], 0.0, 1.0));
    const Colour colour = std::isfinite(li[i]) ? Colour{grey, grey, grey} : kNoNumber;
    panel.push_back(std::isnan(measurement.judge[i]) ? kSky : colour);
  }
  return panel;
}

bool is_beyond(const Measurement& measurement, Arithmetic arithmetic, std::size_t pixel) {
  return !(excess_at(measurement, arithmetic, pixel) <= tolerance_of(arithmetic));
}

Panel difference_panel(const Measurement& measurement, Arithmetic arithmetic) {
  const std::vector<double>& li = measurement.errors[static_cast<std::size_t>(arithmetic)].li;
  Panel panel;
  for (std::size_t i = 0; i < li.size(); ++i) {
    const double error = li[i] - measurement.judge[i];
    const double bar = tolerance_of(arithmetic) + measurement.sensitivities[i];
    const bool beyond = is_beyond(measurement, arithmetic, i);
    const auto share = static_cast<float>(std::min(std::fabs(error) / bar, 1.0));
    const float rest = beyond ? 0.0F : 1.0F - kMostWithin * share;
    Colour colour = error > 0.0 ? Colour{1.0F, rest, rest} : Colour{rest, rest, 1.0F};
    if (!std::isfinite(error)) colour = kNoNumber;
    panel.push_back(std::isnan(measurement.judge[i]) ? kSky : colour);
  }
  return panel;
}

// Panels in columns and rows, each pixel a square.
class Sheet {
 public:
  Sheet(const Measurement& measurement, int columns, int rows, int scale)
      : measurement_(measurement),
        columns_(columns),
        scale_(scale),
        image_(extent(columns, measurement.width), extent(rows, measurement.height), 3) {
    for (int y = 0; y < image_.height; ++y) {
      for (int x = 0; x < image_.width; ++x) set(x, y, kBetween);
    }
  }

  /// \param boxed  pixels in a box; empty for none
  void add(const Panel& panel, const std::vector<bool>& boxed) {
    const int left = (count_ % columns_) * (measurement_.width * scale_ + kGap);
    const int top = (count_ / columns_) * (measurement_.height * scale_ + kGap);
    ++count_;
    for (std::size_t i = 0; i < panel.size(); ++i) {
      const auto width = static_cast<std::size_t>(measurement_.width);
      const int x = left + static_cast<int>(i % width) * scale_;
      const int y = top + static_cast<int>(i / width) * scale_;
      square(x, y, panel[i], !boxed.empty() && boxed[i] && scale_ >= kBox);
    }
  }
  Image take() { return std::move(image_); }

 private:
  int extent(int panels, int pixels) const { return panels * (pixels * scale_ + kGap) - kGap; }
  void set(int x, int y, const Colour& colour) { std::ranges::copy(colour, image_.pixel(x, y)); }
  void square(int left, int top, const Colour& colour, bool boxed) {
    for (int y = 0; y < scale_; ++y) {
      for (int x = 0; x < scale_; ++x) {
        const bool rim = x == 0 || y == 0 || x == scale_ - 1 || y == scale_ - 1;
        set(left + x, top + y, boxed && rim ? kBeyondBox : colour);
      }
    }
  }

  const Measurement& measurement_;
  int columns_;
  int scale_;
  int count_ = 0;
  Image image_;
};

}  // namespace

int visible_scale(const Measurement& measurement) {
  return std::max(1, kVisible / std::max(measurement.width, measurement.height));
}

Image picture_of(const Measurement& measurement, std::span<const Arithmetic> arithmetics,
                 int scale) {
  const int panels = 3 * static_cast<int>(arithmetics.size());
  int columns = 3;
  if (measurement.width >= kLong * measurement.height) columns = 1;
  if (measurement.height >= kLong * measurement.width) columns = panels;
  Sheet sheet(measurement, columns, panels / columns, scale);
  for (const Arithmetic arithmetic : arithmetics) {
    std::vector<bool> beyond;
    for (std::size_t i = 0; i < measurement.judge.size(); ++i) {
      beyond.push_back(is_beyond(measurement, arithmetic, i));
    }
    sheet.add(li_panel(measurement, measurement.judge), {});
    const auto& errors = measurement.errors[static_cast<std::size_t>(arithmetic)];
    sheet.add(li_panel(measurement, errors.li), {});
    sheet.add(difference_panel(measurement, arithmetic), beyond);
  }
  return sheet.take();
}

}  // namespace wedgesim::reports::stress

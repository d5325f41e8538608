#pragma once

#include <array>
#include <utility>
#include <vector>

#include "base/image.h"

namespace wedgesim::reports {

/// Values for a PNG, sRGB, [0, 1].
using Colour = std::array<float, 3>;
/// (height, width) pixels of one picture.
using Panel = std::vector<Colour>;

inline constexpr Colour kSky{0.30F, 0.35F, 0.42F};
inline constexpr Colour kNoNumber{1.0F, 0.0F, 1.0F};

/// Light, 0 to 1 and clamped, as grey; kNoNumber where it is none.
Colour grey_of(double light);
/// A difference as saturation of red (too light, positive) or blue (too dark); none is white.
/// \param saturation  0 to 1
Colour difference_colour(double error, double saturation);

/// Pictures of the same size in rows and columns, each pixel a square.
class Sheet {
 public:
  /// \param width, height  of a panel, pixels
  /// \param scale  a pixel's edge in the sheet
  Sheet(int width, int height, int columns, int rows, int scale);
  /// Adds the next panel, from left to right, row by row.
  /// \param boxed  (height, width) pixels in a black box, where they are drawn large enough; empty
  ///               for none
  void add(const Panel& panel, const std::vector<bool>& boxed = {});
  Image take() { return std::move(image_); }

 private:
  int extent(int panels, int pixels) const;
  void square(int left, int top, const Colour& colour, bool boxed);

  int width_, height_, columns_, scale_;
  int count_ = 0;
  Image image_;
};

}  // namespace wedgesim::reports

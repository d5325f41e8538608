#pragma once

#include <compare>
#include <cstdint>

namespace wedgesim::functional {

/// A point of a plane on an integer grid. Coordinates are at most kGridLimit in absolute value, so
/// that every predicate of this folder is exact in 64 bits. Vertices have even coordinates: the
/// middle of two of them is on the grid too.
struct GridPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  auto operator<=>(const GridPoint&) const = default;  // from left to right, then upwards
};
inline constexpr std::int32_t kGridLimit = 1 << 28;

/// Twice the signed area of a triangle: above 0 if a, b, c turn counter-clockwise.
inline std::int64_t turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
         (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

inline std::int64_t squared_distance(const GridPoint& a, const GridPoint& b) {
  const std::int64_t dx = std::int64_t{b.x} - a.x;
  const std::int64_t dy = std::int64_t{b.y} - a.y;
  return dx * dx + dy * dy;
}

}  // namespace wedgesim::functional

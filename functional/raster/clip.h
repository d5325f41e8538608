#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/limits.h"
#include "functional/raster/window.h"

namespace wedgesim::functional {

/// Polygons are clipped to this guard band in x and y, window pixels: two frames beyond each edge
/// of the largest, narrow enough that 24 bits and a sign hold 1/256 pixels.
inline constexpr double kGuardLow = -2.0 * kMaxFrameEdge;
inline constexpr double kGuardHigh = 3.0 * kMaxFrameEdge;

/// A window vertex before snapping: pixels and window depth.
using WindowPoint = glm::dvec3;

/// A vertex snapped to 1/256 pixel; z is its depth before snapping.
struct SnappedPoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
  double z = 0.0;
  bool operator==(const SnappedPoint&) const = default;
};

/// Clips a convex world polygon to the near plane and to a guard band around the frame, and
/// projects it. The far plane does not clip. Two polygons that share an edge get the same bits for
/// its clip vertices, whichever way round they name it.
/// \return window points in order around the outline; fewer than 3 if nothing is left
std::vector<WindowPoint> clip_to_window(const Window& window, std::span<const glm::dvec3> polygon);

/// Rounds to the nearest 1/256 pixel.
SnappedPoint snap(const WindowPoint& point);
std::vector<SnappedPoint> snap(std::span<const WindowPoint> points);

/// Twice the signed area in (1/256 pixel)², y down: negative when the outline is seen
/// counter-clockwise, that is when a polygon wound counter-clockwise outside faces the eye.
std::int64_t doubled_area(std::span<const SnappedPoint> polygon);

/// True if no corner of the snapped outline turns against the others.
bool is_convex(std::span<const SnappedPoint> polygon);

/// The outline without corners that fell together, in convex parts: snapping can make a convex
/// outline turn inwards, which then becomes a fan of triangles whose signed areas add up to its
/// own.
std::vector<std::vector<SnappedPoint>> convex_parts(std::vector<SnappedPoint> outline);

}  // namespace wedgesim::functional

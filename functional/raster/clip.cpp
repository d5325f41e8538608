#include "functional/raster/clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/limits.h"

namespace wedgesim::functional {
namespace {

// A side of what is clipped to: a coordinate of the window, or the distance, has a limit.
struct ClipPlane {
  glm::dvec4 plane;  // inside iff dot(plane, homogeneous window point) >= offset
  double offset = 0.0;
  int axis = 0;        // of the coordinate that the cut is at
  double limit = 0.0;  // there

  double distance(const glm::dvec4& p) const {
    return (plane.x * p.x + plane.y * p.y + plane.z * p.z + plane.w * p.w) - offset;
  }
};
constexpr int kDistance = 3;

// The near plane by w, the distance: z is the difference of two large terms where near is small.
std::array<ClipPlane, 5> clip_planes(double near) {
  return {ClipPlane{glm::dvec4(0, 0, 0, 1), near, kDistance, near},
          {glm::dvec4(1, 0, 0, -kGuardLow), 0.0, 0, kGuardLow},
          {glm::dvec4(-1, 0, 0, kGuardHigh), 0.0, 0, kGuardHigh},
          {glm::dvec4(0, 1, 0, -kGuardLow), 0.0, 1, kGuardLow},
          {glm::dvec4(0, -1, 0, kGuardHigh), 0.0, 1, kGuardHigh}};
}

// Between two points whose w differ by more than their digits rounding would leave nothing of the
// smaller one: what is known of the cut is set. Seen from the eye it is between its two ends.
void make_exact(const ClipPlane& plane, const glm::dvec4& in, const glm::dvec4& out,
                glm::dvec4& cut) {
  if (plane.axis == kDistance) {
    cut.z = 0.0;
    cut.w = plane.limit;
    return;
  }
  cut.w = std::max(cut.w, std::min(in.w, out.w));
  for (const int axis : {0, 1}) {
    const auto [low, high] = std::minmax({in[axis] / in.w, out[axis] / out.w});
    cut[axis] = std::clamp(cut[axis], low * cut.w, high * cut.w);
  }
  cut[plane.axis] = plane.limit * cut.w;
}

void clip(const ClipPlane& plane, std::vector<glm::dvec4>& polygon,
          std::vector<glm::dvec4>& scratch) {
  scratch.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec4& from = polygon[i];
    const glm::dvec4& to = polygon[(i + 1) % polygon.size()];
    const double d_from = plane.distance(from);
    const double d_to = plane.distance(to);
    if (d_from >= 0.0) scratch.push_back(from);
    if ((d_from >= 0.0) != (d_to >= 0.0)) {
      // Always from the inside to the outside end, so that a shared edge is cut once.
      const bool leaving = d_from >= 0.0;
      const glm::dvec4& in = leaving ? from : to;
      const glm::dvec4& out = leaving ? to : from;
      const double d_in = leaving ? d_from : d_to;
      const double d_out = leaving ? d_to : d_from;
      glm::dvec4 cut = in + (d_in / (d_in - d_out)) * (out - in);
      make_exact(plane, in, out, cut);
      scratch.push_back(cut);
    }
  }
  polygon.swap(scratch);
}

}  // namespace

std::vector<WindowPoint> clip_to_window(const Window& window, std::span<const glm::dvec3> polygon) {
  std::vector<glm::dvec4> points;
  points.reserve(polygon.size() + 5);
  for (const glm::dvec3& p : polygon) {
    points.push_back(window.window_from_world * glm::dvec4(p, 1.0));
  }
  std::vector<glm::dvec4> scratch;
  for (const ClipPlane& plane : clip_planes(view_distance(window, 0.0))) {
    for (const glm::dvec4& p : points) {
      if (plane.distance(p) < 0.0) {
        clip(plane, points, scratch);
        break;
      }
    }
    if (points.size() < 3) return {};
  }
  std::vector<WindowPoint> result;
  result.reserve(points.size());
  for (const glm::dvec4& p : points) result.emplace_back(glm::dvec3(p) / p.w);
  return result;
}

SnappedPoint snap(const WindowPoint& point) {
  // Clipping leaves nothing beyond the guard band but what is not a number.
  CHECK_LE(std::abs(point.x) + std::abs(point.y), 4.0 * kGuardHigh);
  return {static_cast<std::int32_t>(std::nearbyint(point.x * 256.0)),
          static_cast<std::int32_t>(std::nearbyint(point.y * 256.0)), point.z};
}

std::vector<SnappedPoint> snap(std::span<const WindowPoint> points) {
  std::vector<SnappedPoint> result;
  result.reserve(points.size());
  for (const WindowPoint& p : points) result.push_back(snap(p));
  return result;
}

std::int64_t doubled_area(std::span<const SnappedPoint> polygon) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SnappedPoint& p = polygon[i];
    const SnappedPoint& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    sum += std::int64_t{p.x} * q.y - std::int64_t{q.x} * p.y;
  }
  return sum;
}

bool is_convex(std::span<const SnappedPoint> polygon) {
  if (polygon.size() <= 3) return true;
  bool left = false;
  bool right = false;
  int x_turns = 0;  // a convex outline goes through x monotonically twice
  int last_sign = 0;
  int first_sign = 0;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const SnappedPoint& a = polygon[i];
    const SnappedPoint& b = polygon[(i + 1) % n];
    const SnappedPoint& c = polygon[(i + 2) % n];
    const std::int64_t turn = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - b.y) -
                              (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - b.x);
    left |= turn > 0;
    right |= turn < 0;
    // Lexicographic direction of the edge: two changes around a convex outline, more otherwise.
    const int sign = b.x != a.x ? (b.x > a.x ? 1 : -1) : (b.y > a.y ? 1 : (b.y < a.y ? -1 : 0));
    if (sign == 0) continue;
    if (last_sign != 0 && sign != last_sign) ++x_turns;
    if (first_sign == 0) first_sign = sign;
    last_sign = sign;
  }
  if (last_sign != first_sign) ++x_turns;
  return !(left && right) && x_turns <= 2;
}

std::vector<std::vector<SnappedPoint>> convex_parts(std::vector<SnappedPoint> outline) {
  const auto same_place = [](const SnappedPoint& a, const SnappedPoint& b) {
    return a.x == b.x && a.y == b.y;
  };
  outline.erase(std::unique(outline.begin(), outline.end(), same_place), outline.end());
  while (outline.size() > 1 && same_place(outline.front(), outline.back())) outline.pop_back();
  if (is_convex(outline)) return {std::move(outline)};
  std::vector<std::vector<SnappedPoint>> parts;
  for (std::size_t i = 2; i < outline.size(); ++i) {
    parts.push_back({outline[0], outline[i - 1], outline[i]});
  }
  return parts;
}

}  // namespace wedgesim::functional

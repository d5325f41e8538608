#include "functional/geometry/screen_builder.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "functional/geometry/hull.h"

namespace wedgesim::functional {
namespace {

// Snapping moves an edge by less than 1/256·√½ pixel; the outline grows by more than that.
constexpr double kGrow = 1.0 / 256.0;
constexpr double kMostGrow = 4.0;  // pixels, at the sharp corners of slivers
// Rounding of z at the ends of a wedge's interval.
constexpr double kDepthSlack = 1e-9;

using Outlines = std::vector<std::vector<WindowPoint>>;

// Moves the corners of the hull of all outlines outwards, so that each of its sides moves by kGrow.
void grow_hull(Outlines& outlines) {
  std::vector<glm::dvec2> points;
  for (const auto& outline : outlines) {
    for (const WindowPoint& p : outline) points.emplace_back(p);
  }
  const std::vector<glm::dvec2> hull = convex_hull(points);
  if (hull.size() < 2) return;
  std::map<std::pair<double, double>, glm::dvec2> moved;
  const std::size_t n = hull.size();
  const auto outward = [](const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 side = to - from;
    return glm::dvec2(side.y, -side.x) / glm::length(side);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 before = outward(hull[(i + n - 1) % n], hull[i]);
    const glm::dvec2 after = outward(hull[i], hull[(i + 1) % n]);
    const glm::dvec2 middle = before + after;
    const double scale = kGrow / std::max(1.0 + glm::dot(before, after), 1e-12);
    glm::dvec2 shift = scale * middle;
    const double length = glm::length(shift);
    if (length > kMostGrow) shift *= kMostGrow / length;
    if (length < kGrow) shift = kGrow * glm::normalize(hull[i] - hull[(i + 1) % n]);  // a segment
    moved[{hull[i].x, hull[i].y}] = hull[i] + shift;
  }
  for (auto& outline : outlines) {
    for (WindowPoint& p : outline) {
      const auto it = moved.find({p.x, p.y});
      if (it != moved.end()) p = WindowPoint(it->second, p.z);
    }
  }
}

std::pair<double, double> depth_range(std::span<const WindowPoint> points) {
  double low = points.front().z;
  double high = low;
  for (const WindowPoint& p : points) {
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  return {low, high};
}

}  // namespace

std::size_t ScreenBuilder::Hash::operator()(const SnappedPoint& p) const {
  std::uint64_t h = std::bit_cast<std::uint64_t>(p.z);
  h ^= (std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32U) | static_cast<std::uint32_t>(p.y);
  h *= 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(h ^ (h >> 29U));
}

std::uint32_t ScreenBuilder::plane_reference(const glm::dvec4& world_plane) {
  bool minus = false;
  for (int i = 0; i < 4; ++i) {
    if (world_plane[i] != 0.0) {
      minus = world_plane[i] < 0.0;
      break;
    }
  }
  const glm::dvec4 p = minus ? -world_plane : world_plane;
  const auto [it, added] =
      planes_.try_emplace({p.x, p.y, p.z, p.w}, static_cast<std::uint32_t>(trace_.planes.size()));
  if (added) {
    const glm::dvec4 w = window_plane(window_, p);
    trace_.planes.emplace_back(w.x, w.y, w.z, w.w);
  }
  return traces::plane_reference(it->second, minus);
}

std::uint32_t ScreenBuilder::vertex(const SnappedPoint& point) {
  const auto [it, added] =
      vertices_.try_emplace(point, static_cast<std::uint32_t>(trace_.vertices.size()));
  if (added) trace_.vertices.emplace_back(point.x, point.y, point.z);
  return it->second;
}

std::pair<std::uint32_t, std::uint32_t> ScreenBuilder::add_outline(
    std::span<const SnappedPoint> outline) {
  const auto first = static_cast<std::uint32_t>(trace_.indices.size());
  for (const SnappedPoint& p : outline) trace_.indices.push_back(vertex(p));
  return {first, static_cast<std::uint32_t>(outline.size())};
}

// A polygon that faces the eye has its inner side behind it, where depth grows.
bool ScreenBuilder::is_turned(std::span<const SnappedPoint> outline,
                              std::uint32_t reference) const {
  const double c = trace_.planes[traces::plane_index(reference)].c();
  const double inward = traces::is_minus(reference) ? -c : c;
  const std::int64_t area = doubled_area(outline);
  return area < 0 ? inward < 0.0 : (area > 0 && inward > 0.0);
}

std::uint32_t ScreenBuilder::add_umbra_polygon(std::span<const glm::dvec3> outline,
                                               std::uint32_t plane, std::uint32_t wedge,
                                               std::uint32_t caster, traces::fb::UmbraRole role,
                                               bool twisted) {
  const std::vector<WindowPoint> points = clip_to_window(window_, outline);
  if (points.empty()) return traces::kNone;
  const auto [z_min, z_max] = depth_range(points);
  std::vector<std::vector<SnappedPoint>> parts = convex_parts(snap(points));
  // The wedge's is the largest part; the others are slivers of a snapped outline.
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return std::abs(doubled_area(a)) > std::abs(doubled_area(b));
  });
  std::uint32_t result = traces::kNone;
  for (const auto& part : parts) {
    if (doubled_area(part) == 0) break;
    const auto [first, count] = add_outline(part);
    const bool is_first = result == traces::kNone;
    if (is_first) result = static_cast<std::uint32_t>(trace_.umbra_polygons.size());
    const bool turned = twisted && role != traces::fb::UmbraRole_cap && is_turned(part, plane);
    trace_.umbra_polygons.emplace_back(first, count, turned ? plane ^ 1U : plane,
                                       is_first ? wedge : traces::kNone, caster, role, z_min,
                                       z_max);
  }
  return result;
}

// Whether a corner of the near plane's visible part, guard band included, is inside a wedge.
bool ScreenBuilder::holds_near_corner(const WorldWedge& volume) const {
  const std::size_t deciding = std::min(volume.planes.size(), kMaxPlanes);
  const auto holds = [&](double x, double y) {
    const glm::dvec4 corner(world_point(window_, x, y, 0.0), 1.0);
    return std::all_of(volume.planes.begin(),
                       volume.planes.begin() + static_cast<std::ptrdiff_t>(deciding),
                       [&](const glm::dvec4& plane) { return glm::dot(plane, corner) >= 0.0; });
  };
  return holds(kGuardLow, kGuardLow) || holds(kGuardHigh, kGuardLow) ||
         holds(kGuardHigh, kGuardHigh) || holds(kGuardLow, kGuardHigh);
}

bool ScreenBuilder::add_faces(const WorldWedge& volume, traces::fb::Wedge& wedge) {
  Outlines outlines;
  std::vector<std::uint32_t> planes;  // of each outline
  double z_min = 1e300;
  double z_max = -1e300;
  for (const WedgeFace& face : volume.faces) {
    std::vector<glm::dvec3> corners;
    for (const std::uint32_t c : face.corners) corners.push_back(volume.vertices[c]);
    std::vector<WindowPoint> points = clip_to_window(window_, corners);
    if (points.empty()) continue;
    const auto [low, high] = depth_range(points);
    z_min = std::min(z_min, low);
    z_max = std::max(z_max, high);
    outlines.push_back(std::move(points));
    planes.push_back(plane_reference(volume.planes[face.plane]));
  }
  if (outlines.empty()) return false;
  // The nearest point of what is seen of a wedge is on a face or, with the eye in a wedge much
  // wider than the view, in a corner of the near plane.
  if (holds_near_corner(volume)) z_min = 0.0;
  z_min -= kDepthSlack;
  z_max += kDepthSlack;
  grow_hull(outlines);
  const auto first_face = static_cast<std::uint32_t>(trace_.faces.size());
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (const auto& part : convex_parts(snap(outlines[i]))) {
      if (part.size() < 3) continue;
      const auto [first, count] = add_outline(part);
      // The wedge's interval serves every face: a grown face may cover pixels of its neighbour.
      trace_.faces.emplace_back(first, count, planes[i], z_min, z_max);
    }
  }
  const auto face_count = static_cast<std::uint32_t>(trace_.faces.size()) - first_face;
  if (face_count == 0) return false;
  wedge.mutate_first_face(first_face);
  wedge.mutate_face_count(face_count);
  wedge.mutate_z_min(z_min);
  wedge.mutate_z_max(z_max);
  const std::size_t plane_count = std::min(volume.planes.size(), kMaxPlanes);
  wedge.mutate_plane_count(static_cast<std::uint8_t>(plane_count));
  for (std::size_t i = 0; i < plane_count; ++i) {
    wedge.mutable_planes()->Mutate(static_cast<flatbuffers::uoffset_t>(i),
                                   plane_reference(volume.planes[i]));
  }
  return true;
}

}  // namespace wedgesim::functional

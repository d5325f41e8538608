#include "functional/raster/light_map.h"

#include <tbb/blocked_range.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/check.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

constexpr double kMargin = 0.5;  // texels
constexpr std::size_t kTrianglesATask = 1024;

// Multiplies a view's window x by sx and adds tx, and so in y.
void rescale(LightView& view, double sx, double tx, double sy, double ty) {
  glm::dmat4 there(1.0);
  there[0][0] = sx;
  there[1][1] = sy;
  there[3][0] = tx;
  there[3][1] = ty;
  glm::dmat4 back(1.0);
  back[0][0] = 1.0 / sx;
  back[1][1] = 1.0 / sy;
  back[3][0] = -tx / sx;
  back[3][1] = -ty / sy;
  view.window_from_world = there * view.window_from_world;
  view.world_from_window = view.world_from_window * back;
  view.ray_from_window = view.ray_from_window * glm::dmat3(glm::dvec3(back[0]), glm::dvec3(back[1]),
                                                           glm::dvec3(back[3].x, back[3].y, 1.0));
}

// The corners as (x·w, y·w, w), each a column.
glm::dmat3 columns_of(const LightView& view, const std::array<glm::dvec3, 3>& corners) {
  const glm::dmat4& m = view.window_from_world;
  glm::dmat3 columns;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& p = corners[static_cast<std::size_t>(i)];
    for (int row = 0; row < 3; ++row) {
      const int from = row == 2 ? 3 : row;
      columns[i][row] = m[0][from] * p.x + m[1][from] * p.y + m[2][from] * p.z + m[3][from];
    }
  }
  return columns;
}

// Adds a part of a triangle's outline, unless it covers nothing.
void add_part(std::uint32_t index, const glm::dmat3& columns, double w_low, double w_high,
              std::span<const SnappedPoint> outline, std::vector<MapTriangle>& result) {
  const std::int64_t area = doubled_area(outline);
  if (area == 0) return;
  MapTriangle& triangle = result.emplace_back();
  triangle.index = index;
  triangle.faces_light = area < 0;
  CHECK_LE(outline.size(), triangle.outline.size());
  std::copy(outline.begin(), outline.end(), triangle.outline.begin());
  triangle.corners = static_cast<std::uint32_t>(outline.size());
  triangle.inverse_corners = glm::inverse(columns);
  triangle.inverse_w = triangle.over_w({1.0, 1.0, 1.0});
  triangle.w_low = w_low;
  triangle.w_high = w_high;
}

void prepare(const LightView& view, double near, std::uint32_t index,
             const std::array<glm::dvec3, 3>& corners, std::vector<MapTriangle>& result) {
  const glm::dmat3 columns = columns_of(view, corners);
  bool whole = true;  // neither near plane nor guard band cut it, as nearly always
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& p = columns[i];
    whole &= p.z >= near && p.x >= kGuardLow * p.z && p.x <= kGuardHigh * p.z &&
             p.y >= kGuardLow * p.z && p.y <= kGuardHigh * p.z;
  }
  if (whole) {
    std::array<SnappedPoint, 3> outline;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& p = columns[i];
      outline[static_cast<std::size_t>(i)] = snap({p.x / p.z, p.y / p.z, 0.0});
    }
    const auto [low, high] = std::minmax({columns[0].z, columns[1].z, columns[2].z});
    add_part(index, columns, low, high, outline, result);
    return;
  }
  const std::vector<WindowPoint> points = clip_to_window(view, corners);
  if (points.size() < 3) return;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  for (const std::vector<SnappedPoint>& part : convex_parts(snap(points))) {
    add_part(index, columns, view_distance(view, low->z), view_distance(view, high->z), part,
             result);
  }
}

}  // namespace

LightView make_light_view(const glm::dvec3& centre, const glm::dvec3& axis, double near,
                          std::span<const glm::dvec3> points, int resolution) {
  CHECK_GE(resolution, 2);
  const glm::dvec3 along = glm::normalize(axis);
  double far = 2.0 * near;
  for (const glm::dvec3& p : points) far = std::max(far, 2.0 * glm::dot(p - centre, along));
  Camera camera;
  camera.eye = centre;
  camera.target = centre + along;
  camera.up = Across(along).v;
  camera.field_of_view_degrees = 90.0;
  camera.near_plane = near;
  camera.far_plane = far;
  LightView view = make_window(camera, resolution, resolution);

  double x_low = 1e300, x_high = -1e300, y_low = 1e300, y_high = -1e300;
  for (const glm::dvec3& p : points) {
    const MapPlace place = place_in(view, p);
    if (!(place.w >= near)) continue;
    x_low = std::min(x_low, place.x);
    x_high = std::max(x_high, place.x);
    y_low = std::min(y_low, place.y);
    y_high = std::max(y_high, place.y);
  }
  if (x_low > x_high) return {};
  const double inside = resolution - 2.0 * kMargin;
  const double sx = inside / std::max(x_high - x_low, 1e-6);
  const double sy = inside / std::max(y_high - y_low, 1e-6);
  rescale(view, sx, kMargin - sx * x_low, sy, kMargin - sy * y_low);
  for (std::size_t i = 0; i < 4; ++i) {
    view.near_rectangle[i] =
        world_point(view, i == 1 || i == 2 ? resolution : 0.0, i >= 2 ? resolution : 0.0, 0.0);
  }
  return view;
}

MapPlace place_in(const LightView& view, const glm::dvec3& p) {
  const glm::dvec4 h = view.window_from_world * glm::dvec4(p, 1.0);
  return {h.x / h.w, h.y / h.w, h.w};
}

MapRays::MapRays(const LightView& view) {
  const auto ray = [&view](double x, double y) {
    return (world_point(view, x, y, 0.0) - view.eye) / view_distance(view, 0.0);
  };
  origin_ = ray(0.0, 0.0);
  dx_ = (ray(view.width, 0.0) - origin_) / static_cast<double>(view.width);
  dy_ = (ray(0.0, view.height) - origin_) / static_cast<double>(view.height);
}

TexelPlane MapTriangle::over_w(const std::array<double, 3>& values) const {
  const glm::dvec3 plane = glm::dvec3(values[0], values[1], values[2]) * inverse_corners;
  return {plane.x, plane.y, plane.z};
}

MapTriangles::MapTriangles(const LightView& view,
                           std::span<const std::array<glm::dvec3, 3>> triangles)
    : size_(view.width), box_{view.width, 0, view.width, 0} {
  const std::size_t tasks = (triangles.size() + kTrianglesATask - 1) / kTrianglesATask;
  std::vector<std::vector<MapTriangle>> of_task(tasks);
  const double near = tasks > 0 ? view_distance(view, 0.0) : 0.0;
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    const std::size_t end = std::min(triangles.size(), (task + 1) * kTrianglesATask);
    for (std::size_t t = task * kTrianglesATask; t < end; ++t) {
      prepare(view, near, static_cast<std::uint32_t>(t), triangles[t], of_task[task]);
    }
  });
  for (const auto& part : of_task) triangles_.insert(triangles_.end(), part.begin(), part.end());

  // Which triangles are in which band: counted, then filled in order.
  struct Rows {
    int begin = 0, end = 0;
  };
  std::vector<Rows> band_rows(triangles_.size());
  const int bands = (size_ + kBandRows - 1) / kBandRows;
  bands_begin_.assign(static_cast<std::size_t>(bands) + 1, 0);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const MapTriangle& triangle = triangles_[t];
    int x_low = size_, x_high = -1, y_low = size_, y_high = -1;
    for (std::uint32_t i = 0; i < triangle.corners; ++i) {
      const SnappedPoint& p = triangle.outline[i];
      x_low = std::min(x_low, std::max(0, p.x >> 8));
      x_high = std::max(x_high, std::min(size_ - 1, p.x >> 8));
      y_low = std::min(y_low, std::max(0, p.y >> 8));
      y_high = std::max(y_high, std::min(size_ - 1, p.y >> 8));
    }
    if (x_low > x_high || y_low > y_high) continue;
    box_ = {std::min(box_.x_begin, x_low), std::max(box_.x_end, x_high + 1),
            std::min(box_.y_begin, y_low), std::max(box_.y_end, y_high + 1)};
    band_rows[t] = {y_low / kBandRows, y_high / kBandRows + 1};
    for (int b = band_rows[t].begin; b < band_rows[t].end; ++b) {
      ++bands_begin_[static_cast<std::size_t>(b) + 1];
    }
  }
  for (std::size_t b = 1; b < bands_begin_.size(); ++b) bands_begin_[b] += bands_begin_[b - 1];
  bands_.resize(bands_begin_.back());
  std::vector<std::size_t> next(bands_begin_.begin(), bands_begin_.end() - 1);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    for (int b = band_rows[t].begin; b < band_rows[t].end; ++b) {
      bands_[next[static_cast<std::size_t>(b)]++] = static_cast<std::uint32_t>(t);
    }
  }
}

std::vector<float> draw_distances(const LightView& view,
                                  std::span<const std::array<glm::dvec3, 3>> triangles, Keep keep,
                                  float empty, Distances distances) {
  const auto size = static_cast<std::size_t>(view.width);
  const float none = keep == Keep::nearest ? HUGE_VALF : -HUGE_VALF;
  std::vector<float> map(size * size, none);
  const MapRays rays(view);
  const MapTriangles drawn(view, triangles);
  drawn.for_each_row([&](const MapTriangle& triangle, int y, int x_begin, int x_end) {
    std::array<double, 3> at_corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      at_corners[i] = glm::distance(triangles[triangle.index][i], view.eye);
    }
    const TexelPlane over_w = triangle.over_w(at_corners);
    float* texels = map.data() + static_cast<std::size_t>(y) * size;
    for (int x = x_begin; x < x_end; ++x) {
      const double w = triangle.w(x + 0.5, y + 0.5);
      const double factor = distances == Distances::exact ? rays.length(x + 0.5, y + 0.5)
                                                          : over_w.at(x + 0.5, y + 0.5);
      const auto distance = static_cast<float>(w * factor);
      texels[x] =
          keep == Keep::nearest ? std::min(texels[x], distance) : std::max(texels[x], distance);
    }
  });
  std::replace(map.begin(), map.end(), none, empty);
  return map;
}

}  // namespace wedgesim::functional

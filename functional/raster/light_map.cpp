#include "functional/raster/light_map.h"

#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "base/check.h"
#include "functional/raster/spans.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

constexpr double kMargin = 0.5;  // texels
constexpr std::size_t kTrianglesATask = 512;

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

bool is_finite(const glm::dmat3& m) {
  bool finite = true;
  for (int i = 0; i < 3; ++i) {
    finite &= std::isfinite(m[i].x) && std::isfinite(m[i].y) && std::isfinite(m[i].z);
  }
  return finite;
}

// Adds the triangles of a part's outline that may cover the centre of a texel.
void add_part(const MapTriangle& whole, int size, std::span<const SnappedPoint> outline,
              bool one_sided, std::vector<MapTriangle>& result) {
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const SnappedPoint& p = outline[0];
    const SnappedPoint& q = outline[i - 1];
    const SnappedPoint& r = outline[i];
    const std::int64_t area = (std::int64_t{q.x} - p.x) * (std::int64_t{r.y} - p.y) -
                              (std::int64_t{r.x} - p.x) * (std::int64_t{q.y} - p.y);
    const auto [x_low, x_high] = std::minmax({p.x, q.x, r.x});
    const auto [y_low, y_high] = std::minmax({p.y, q.y, r.y});
    const bool centre =
        std::max(0, (x_low + 127) >> 8) <= std::min(size - 1, (x_high - 128) >> 8) &&
        std::max(0, (y_low + 127) >> 8) <= std::min(size - 1, (y_high - 128) >> 8);
    if (area == 0 || !centre || (one_sided && area > 0)) continue;
    MapTriangle& triangle = result.emplace_back(whole);
    triangle.faces_light = area < 0;
    triangle.corners = {{{p.x, p.y}, {q.x, q.y}, {r.x, r.y}}};
  }
}

// f/w of a function f that is linear on a triangle, by its values at the corners.
TexelPlane over_w(const glm::dmat3& inverse_columns, const std::array<double, 3>& values) {
  const glm::dvec3 plane = glm::dvec3(values[0], values[1], values[2]) * inverse_columns;
  return {plane.x, plane.y, plane.z};
}

void prepare(const LightView& view, double near, const MapTriangles::Input& input,
             std::vector<MapTriangle>& result) {
  const glm::dmat3 columns = columns_of(view, input.corners);
  const auto [nearest, farthest] = std::minmax({columns[0].z, columns[1].z, columns[2].z});
  const glm::dmat3 inverse = glm::inverse(columns);
  MapTriangle triangle;
  triangle.tag = input.tag;
  triangle.inverse_low = 1.0 / farthest;
  triangle.inverse_high = 1.0 / nearest;
  if (is_finite(inverse)) {
    triangle.inverse_w = over_w(inverse, {1.0, 1.0, 1.0});
    triangle.value_over_w = over_w(inverse, input.value);
    triangle.other_over_w = over_w(inverse, input.other);
  } else {  // seen exactly edge-on
    triangle.inverse_w.c = triangle.inverse_low;
    triangle.value_over_w.c = triangle.inverse_low * input.value[0];
    triangle.other_over_w.c = triangle.inverse_low * input.other[0];
  }
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
    add_part(triangle, view.width, outline, input.one_sided, result);
    return;
  }
  const std::vector<WindowPoint> points = clip_to_window(view, input.corners);
  if (points.size() < 3) return;
  const auto [low, high] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
  triangle.inverse_low = 1.0 / view_distance(view, high->z);
  triangle.inverse_high = 1.0 / view_distance(view, low->z);
  for (const std::vector<SnappedPoint>& part : convex_parts(snap(points))) {
    add_part(triangle, view.width, part, input.one_sided, result);
  }
}

// Bands whose rows' centres a triangle may cover.
struct BandRange {
  std::size_t begin, end;
};
BandRange bands_of(const MapTriangle& triangle, int size) {
  const auto& [p, q, r] = triangle.corners;
  const auto [low, high] = std::minmax({p.y, q.y, r.y});
  const int first = std::max(0, (low + 127) >> 8);
  const int last = std::min(size - 1, (high - 128) >> 8);
  return {static_cast<std::size_t>(first / MapTriangles::kBandRows),
          static_cast<std::size_t>(last / MapTriangles::kBandRows) + 1};
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

MapTriangles::MapTriangles(const LightView& view, std::size_t count,
                           const std::function<Input(std::size_t)>& input) {
  if (count == 0) return;
  const double near = view_distance(view, 0.0);
  const auto bands = static_cast<std::size_t>(MapTriangles::bands(view.width));
  const std::size_t tasks = (count + kTrianglesATask - 1) / kTrianglesATask;
  triangles_.resize(tasks);
  // Of each band and task: the triangles, then where they begin among all in bands.
  std::vector<std::size_t> places(bands * tasks + 1, 0);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    const std::size_t end = std::min(count, (task + 1) * kTrianglesATask);
    triangles_[task].reserve(end - task * kTrianglesATask);
    for (std::size_t t = task * kTrianglesATask; t < end; ++t) {
      prepare(view, near, input(t), triangles_[task]);
    }
    for (const MapTriangle& triangle : triangles_[task]) {
      const BandRange range = bands_of(triangle, view.width);
      for (std::size_t b = range.begin; b < range.end; ++b) ++places[b * tasks + task];
    }
  });
  std::exclusive_scan(places.begin(), places.end(), places.begin(), std::size_t{0});
  for (std::size_t b = 0; b <= bands; ++b) begins_.push_back(places[b * tasks]);
  in_bands_.resize(begins_.back());
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    for (const MapTriangle& triangle : triangles_[task]) {
      const BandRange range = bands_of(triangle, view.width);
      for (std::size_t b = range.begin; b < range.end; ++b) {
        in_bands_[places[b * tasks + task]++] = &triangle;
      }
    }
  });
}

std::vector<float> draw_distances(const LightView& view,
                                  std::span<const std::array<glm::dvec3, 3>> triangles, Keep keep,
                                  float empty, Distances distances) {
  const auto size = static_cast<std::size_t>(view.width);
  const float none = keep == Keep::nearest ? HUGE_VALF : -HUGE_VALF;
  std::vector<float> map(size * size, none);
  const MapRays rays(view);
  const MapTriangles drawn(view, triangles.size(), [&](std::size_t t) {
    MapTriangles::Input input{triangles[t]};
    for (std::size_t i = 0; i < 3; ++i) input.value[i] = glm::distance(triangles[t][i], view.eye);
    return input;
  });
  tbb::parallel_for(0, MapTriangles::bands(view.width), [&](int band) {
    const int y_begin = band * MapTriangles::kBandRows;
    const int y_end = std::min(view.width, y_begin + MapTriangles::kBandRows);
    for (const MapTriangle* triangle : drawn.band(band)) {
      std::array<SnappedPoint, 3> outline;
      for (std::size_t i = 0; i < 3; ++i) {
        outline[i] = {triangle->corners[i].x, triangle->corners[i].y, 0.0};
      }
      for_each_span(outline, view.width, y_begin, y_end, [&](int y, int x_begin, int x_end) {
        float* texels = map.data() + static_cast<std::size_t>(y) * size;
        for (int x = x_begin; x < x_end; ++x) {
          const double w = 1.0 / std::clamp(triangle->inverse_w.at(x + 0.5, y + 0.5),
                                            triangle->inverse_low, triangle->inverse_high);
          const double factor = distances == Distances::exact
                                    ? rays.length(x + 0.5, y + 0.5)
                                    : triangle->value_over_w.at(x + 0.5, y + 0.5);
          const auto distance = static_cast<float>(w * factor);
          texels[x] =
              keep == Keep::nearest ? std::min(texels[x], distance) : std::max(texels[x], distance);
        }
      });
    }
  });
  std::replace(map.begin(), map.end(), none, empty);
  return map;
}

}  // namespace wedgesim::functional

#include "functional/methods/plane_canvas.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "functional/raster/clip.h"

namespace wedgesim::functional {
namespace {

constexpr int kBandRows = 16;
constexpr double kMargin = 0.25;  // pixels; far beyond the rounding of projections

// Left of a side; a point on its line is taken for one a little to the right, and much less above.
bool is_inside(const PlaneCell::Side& side, const GridPoint& p) {
  const std::int64_t value = turn(side[0], side[1], p);
  if (value != 0) return value > 0;
  return side[1].y != side[0].y ? side[1].y < side[0].y : side[1].x > side[0].x;
}

bool is_inside(const PlaneCell& cell, const GridPoint& p) {
  for (int i = 0; i < cell.side_count; ++i) {
    if (!is_inside(cell.sides[static_cast<std::size_t>(i)], p)) return false;
  }
  return true;
}

float intensity_at(const PlaneCell& cell, const GridPoint& p) {
  const double value = cell.at_corner + cell.gradient.x * (p.x - cell.corners[0].x) +
                       cell.gradient.y * (p.y - cell.corners[0].y);
  return std::clamp(static_cast<float>(value), cell.low, cell.high);
}

// First and one past the last pixel whose centre may be between two coordinates.
std::pair<int, int> centres_between(double low, double high, int size) {
  const double first = std::clamp(std::ceil(low - kMargin - 0.5), 0.0, double(size));
  const double last = std::clamp(std::floor(high + kMargin - 0.5), -1.0, size - 1.0);
  return {static_cast<int>(first), static_cast<int>(last) + 1};
}

class Painter {
 public:
  Painter(const MethodInput& input, const ReceiverPlane& plane, std::span<const PlaneCell> cells,
          Visibility& result)
      : input_(input), window_(input.window), plane_(plane), cells_(cells), result_(result) {}

  void run() {
    find_points();
    rows_.resize(cells_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells_.size(), 512), [&](const auto& r) {
      std::vector<glm::dvec2> outline;
      for (std::size_t i = r.begin(); i < r.end(); ++i) {
        find_outline(cells_[i], outline);
        rows_[i] = rows_of(outline);
      }
    });
    const int bands = (window_.height + kBandRows - 1) / kBandRows;
    std::vector<std::array<std::uint64_t, 2>> counts(static_cast<std::size_t>(bands));
    tbb::parallel_for(0, bands, [&](int band) {
      counts[static_cast<std::size_t>(band)] =
          draw_rows(band * kBandRows, std::min(window_.height, (band + 1) * kBandRows));
    });
    for (const auto& [reads, writes] : counts) {
      result_.accesses.z_reads += reads;
      result_.accesses.li_writes += writes;
      result_.accesses.bytes += 4 * (reads + writes);
    }
  }

 private:
  // The point of the plane behind a pixel's centre.
  struct Target {
    GridPoint point;
    bool on_plane = false;  // the view ray meets the plane, within the grid
    bool drawn = false;     // and a receiver is seen there
  };

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(window_.width) +
           static_cast<std::size_t>(x);
  }

  void find_points() {
    std::vector<char> receives;
    for (const Object& object : input_.scene.objects) {
      receives.insert(receives.end(), object.mesh.triangles.size(), object.casts ? 0 : 1);
    }
    const auto& near = window_.near_rectangle;
    const glm::dvec3 eye = plane_.from_world(window_.eye);
    const glm::dvec3 corner = plane_.from_world(near[0]);
    const glm::dvec3 right = (plane_.from_world(near[1]) - corner) / double(window_.width);
    const glm::dvec3 down = (plane_.from_world(near[3]) - corner) / double(window_.height);
    targets_.resize(input_.depth.words.size());
    tbb::parallel_for(0, window_.height, [&](int y) {
      for (int x = 0; x < window_.width; ++x) {
        const glm::dvec3 way = corner + (x + 0.5) * right + (y + 0.5) * down - eye;
        const double t = -eye.z / way.z;
        if (!(t >= 1.0)) continue;
        Target& target = targets_[index(x, y)];
        target.on_plane = plane_.locate({eye.x + t * way.x, eye.y + t * way.y}, target.point);
        const std::uint32_t triangle = input_.depth.triangle[index(x, y)];
        target.drawn = target.on_plane && triangle != DepthBuffer::kSky && receives[triangle] != 0;
      }
    });
  }

  // On the screen; empty if none of it is in front of the eye.
  void find_outline(const PlaneCell& cell, std::vector<glm::dvec2>& outline) const {
    outline.clear();
    std::array<glm::dvec3, 4> world;
    bool plain = true;
    const auto count = static_cast<std::size_t>(cell.side_count);
    for (std::size_t i = 0; i < count; ++i) {
      world[i] = plane_.to_world(plane_.unit * cell.corners[i]);
      const glm::dvec4 p = window_.window_from_world * glm::dvec4(world[i], 1.0);
      plain = plain && p.w >= view_distance(window_, 0.0);
      if (plain) outline.emplace_back(p.x / p.w, p.y / p.w);
    }
    if (plain) return;
    outline.clear();
    for (const WindowPoint& p : clip_to_window(window_, std::span(world).first(count))) {
      outline.emplace_back(p.x, p.y);
    }
  }

  std::pair<int, int> rows_of(const std::vector<glm::dvec2>& outline) const {
    if (outline.empty()) return {0, 0};
    const auto [left, right] = std::ranges::minmax_element(outline, {}, &glm::dvec2::x);
    const auto [x_begin, x_end] = centres_between(left->x, right->x, window_.width);
    if (x_begin >= x_end) return {0, 0};
    const auto [top, bottom] = std::ranges::minmax_element(outline, {}, &glm::dvec2::y);
    return centres_between(top->y, bottom->y, window_.height);
  }

  // The pixels of a row that an outline may cover.
  std::pair<int, int> columns_of(const std::vector<glm::dvec2>& outline, int y) const {
    const double y_low = y + 0.5 - kMargin;
    const double y_high = y + 0.5 + kMargin;
    double x_low = 1e300;
    double x_high = -1e300;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      glm::dvec2 a = outline[i];
      glm::dvec2 b = outline[(i + 1) % outline.size()];
      if (a.y > b.y) std::swap(a, b);
      if (a.y > y_high || b.y < y_low) continue;
      const double slope = a.y == b.y ? 0.0 : (b.x - a.x) / (b.y - a.y);
      const double x0 = a.y >= y_low ? a.x : a.x + slope * (y_low - a.y);
      const double x1 = b.y <= y_high ? b.x : a.x + slope * (y_high - a.y);
      x_low = std::min({x_low, x0, x1});
      x_high = std::max({x_high, x0, x1});
    }
    return centres_between(x_low, x_high, window_.width);
  }

  /// \return z reads and writes
  std::array<std::uint64_t, 2> draw_rows(int y_begin, int y_end) {
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    std::vector<glm::dvec2> outline;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const int first = std::max(y_begin, rows_[i].first);
      const int last = std::min(y_end, rows_[i].second);
      if (first >= last) continue;
      const PlaneCell& cell = cells_[i];
      find_outline(cell, outline);
      for (int y = first; y < last; ++y) {
        const auto [x_begin, x_end] = columns_of(outline, y);
        for (int x = x_begin; x < x_end; ++x) {
          const Target& target = targets_[index(x, y)];
          if (!target.on_plane || !is_inside(cell, target.point)) continue;
          ++reads;
          if (!target.drawn) continue;
          ++writes;
          result_.values[index(x, y)] = 1.0F - intensity_at(cell, target.point);
        }
      }
    }
    return {reads, writes};
  }

  const MethodInput& input_;
  const Window& window_;
  const ReceiverPlane& plane_;
  std::span<const PlaneCell> cells_;
  Visibility& result_;
  std::vector<Target> targets_;            // of each pixel
  std::vector<std::pair<int, int>> rows_;  // of each cell
};

}  // namespace

PlaneCell make_triangle(const std::array<GridPoint, 3>& corners,
                        const std::array<float, 3>& intensity) {
  PlaneCell cell;
  cell.side_count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    cell.sides[i] = {corners[i], corners[(i + 1) % 3]};
    cell.corners[i] = {corners[i].x, corners[i].y};
  }
  const auto [low, high] = std::ranges::minmax(intensity);
  cell.low = low;
  cell.high = high;
  cell.at_corner = intensity[0];
  const glm::dvec2 p = cell.corners[1] - cell.corners[0];
  const glm::dvec2 q = cell.corners[2] - cell.corners[0];
  const double area = p.x * q.y - p.y * q.x;
  const double dp = static_cast<double>(intensity[1]) - static_cast<double>(intensity[0]);
  const double dq = static_cast<double>(intensity[2]) - static_cast<double>(intensity[0]);
  if (area > 0.0) cell.gradient = glm::dvec2(dp * q.y - dq * p.y, dq * p.x - dp * q.x) / area;
  return cell;
}

PlaneCell make_trapezoid(const Trapezoid& trapezoid, float intensity) {
  const auto& [lower, upper] = std::tie(trapezoid.lower, trapezoid.upper);
  const std::int32_t x0 = trapezoid.x_begin;
  const std::int32_t x1 = trapezoid.x_end;
  PlaneCell cell;
  cell.side_count = 4;
  cell.sides = {lower, PlaneCell::Side{GridPoint{x1, 0}, GridPoint{x1, 1}},
                PlaneCell::Side{upper[1], upper[0]},
                PlaneCell::Side{GridPoint{x0, 1}, GridPoint{x0, 0}}};
  const auto at = [](const std::array<GridPoint, 2>& edge, double x) {
    const double t = (x - edge[0].x) / (static_cast<double>(edge[1].x) - edge[0].x);
    return glm::dvec2(x, edge[0].y + t * (static_cast<double>(edge[1].y) - edge[0].y));
  };
  cell.corners = {at(lower, x0), at(lower, x1), at(upper, x1), at(upper, x0)};
  cell.at_corner = intensity;
  cell.low = cell.high = intensity;
  return cell;
}

void draw_on_plane(const MethodInput& input, const ReceiverPlane& plane,
                   std::span<const PlaneCell> cells, Visibility& result) {
  Painter(input, plane, cells, result).run();
}

}  // namespace wedgesim::functional

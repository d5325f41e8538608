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

// The rectangle of pixels whose centres a cell may cover.
struct PixelBox {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;
};

class Painter {
 public:
  Painter(const MethodInput& input, const ReceiverPlane& plane, std::span<const PlaneCell> cells,
          Visibility& result)
      : input_(input), window_(input.window), plane_(plane), cells_(cells), result_(result) {
    const glm::dmat4& from_world = window_.window_from_world;
    const auto flat = [](const glm::dvec4& p) { return glm::dvec3(p.x, p.y, p.w); };
    at_x_ = flat(from_world * glm::dvec4(plane.unit * plane.x_axis, 0.0));
    at_y_ = flat(from_world * glm::dvec4(plane.unit * plane.y_axis, 0.0));
    at_origin_ = flat(from_world * glm::dvec4(plane.origin, 1.0));
    near_ = view_distance(window_, 0.0);
    const auto& rectangle = window_.near_rectangle;
    eye_ = plane.from_world(window_.eye);
    corner_ = plane.from_world(rectangle[0]) - eye_;
    right_ = (plane.from_world(rectangle[1]) - plane.from_world(rectangle[0])) /
             static_cast<double>(window_.width);
    down_ = (plane.from_world(rectangle[3]) - plane.from_world(rectangle[0])) /
            static_cast<double>(window_.height);
    for (const Object& object : input.scene.objects) {
      receives_.insert(receives_.end(), object.mesh.triangles.size(), object.casts ? 0 : 1);
    }
  }

  void run() {
    boxes_.resize(cells_.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells_.size(), 512), [&](const auto& r) {
      std::vector<glm::dvec2> outline;
      for (std::size_t i = r.begin(); i < r.end(); ++i) {
        find_outline(cells_[i], outline);
        boxes_[i] = box_of(outline);
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

  Target target_of(int x, int y) const {
    Target target;
    const glm::dvec3 way = corner_ + (x + 0.5) * right_ + (y + 0.5) * down_;
    const double t = -eye_.z / way.z;
    if (!(t >= 1.0)) return target;
    target.on_plane = plane_.locate({eye_.x + t * way.x, eye_.y + t * way.y}, target.point);
    const std::uint32_t triangle = input_.depth.triangle[index(x, y)];
    target.drawn = target.on_plane && triangle != DepthBuffer::kSky && receives_[triangle] != 0;
    return target;
  }

  // On the screen; empty if none of it is in front of the eye.
  void find_outline(const PlaneCell& cell, std::vector<glm::dvec2>& outline) const {
    outline.clear();
    const auto corners = std::span(cell.corners).first(static_cast<std::size_t>(cell.side_count));
    bool plain = true;
    for (const glm::dvec2& corner : corners) {
      const glm::dvec3 p = corner.x * at_x_ + corner.y * at_y_ + at_origin_;
      plain = plain && p.z >= near_;
      outline.emplace_back(p.x / p.z, p.y / p.z);
    }
    if (plain) return;
    std::vector<glm::dvec3> world;
    for (const glm::dvec2& corner : corners) world.push_back(plane_.to_world(plane_.unit * corner));
    outline.clear();
    for (const WindowPoint& p : clip_to_window(window_, world)) outline.emplace_back(p.x, p.y);
  }

  PixelBox box_of(const std::vector<glm::dvec2>& outline) const {
    PixelBox box;
    if (outline.empty()) return box;
    const auto [left, right] = std::ranges::minmax_element(outline, {}, &glm::dvec2::x);
    std::tie(box.x_begin, box.x_end) = centres_between(left->x, right->x, window_.width);
    const auto [top, bottom] = std::ranges::minmax_element(outline, {}, &glm::dvec2::y);
    std::tie(box.y_begin, box.y_end) = centres_between(top->y, bottom->y, window_.height);
    return box.x_begin < box.x_end ? box : PixelBox{};
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
    std::vector<std::size_t> here;
    PixelBox all{window_.width, 0, y_end, y_begin};
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const PixelBox& box = boxes_[i];
      if (box.y_begin >= y_end || box.y_end <= y_begin) continue;
      here.push_back(i);
      all = {std::min(all.x_begin, box.x_begin), std::max(all.x_end, box.x_end),
             std::min(all.y_begin, std::max(box.y_begin, y_begin)),
             std::max(all.y_end, std::min(box.y_end, y_end))};
    }
    const int width = all.x_end - all.x_begin;
    std::vector<Target> targets;
    targets.reserve(static_cast<std::size_t>(std::max(0, width * (all.y_end - all.y_begin))));
    for (int y = all.y_begin; y < all.y_end; ++y) {
      for (int x = all.x_begin; x < all.x_end; ++x) targets.push_back(target_of(x, y));
    }
    std::uint64_t reads = 0;
    std::uint64_t writes = 0;
    std::vector<glm::dvec2> outline;
    for (const std::size_t i : here) {
      const PlaneCell& cell = cells_[i];
      const PixelBox& box = boxes_[i];
      const bool small = (box.x_end - box.x_begin) * (box.y_end - box.y_begin) <= 8;
      if (!small) find_outline(cell, outline);
      for (int y = std::max(y_begin, box.y_begin); y < std::min(y_end, box.y_end); ++y) {
        const auto [x_begin, x_end] =
            small ? std::pair(box.x_begin, box.x_end) : columns_of(outline, y);
        for (int x = x_begin; x < x_end; ++x) {
          const Target& target =
              targets[static_cast<std::size_t>((y - all.y_begin) * width + x - all.x_begin)];
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
  glm::dvec3 at_x_, at_y_, at_origin_;  // homogeneous window x, y and w of the grid
  double near_ = 0.0;
  glm::dvec3 eye_, corner_, right_, down_;  // rays to the near rectangle, in the plane's axes
  std::vector<char> receives_;              // of each triangle of the scene
  std::vector<PixelBox> boxes_;             // of each cell
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

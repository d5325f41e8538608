#include "model/datapath/rectangle_coverage.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wedgesim::model::datapath {
namespace {

struct End {
  std::int64_t u, v, w;

  /// Inside the square's four sides, not negative each.
  std::array<std::int64_t, 4> sides() const { return {w - u, w + u, w - v, w + v}; }
};

struct Line {
  std::int64_t a, b, c;
};

// A point of the square, and the distance along the outline, from (1, 0) and counter-clockwise, of
// where the ray from the centre through it leaves the square: [-1, 7].
struct Point {
  double u = 0.0, v = 0.0, w = 1.0;
  double perimeter = 0.0;
};

double perimeter(bool sideways, double sign, double ratio, Rounder round) {
  if (sideways) return round((sign < 0.0 ? 4.0 : 0.0) + ratio);
  return round((sign < 0.0 ? 6.0 : 2.0) - ratio);
}

// The end itself; its ray leaves anywhere if it is the centre.
Point inner_point(const End& end, Rounder round) {
  Point p{round(end.u, 0), round(end.v, 0), round(end.w, 0)};
  const bool sideways = std::fabs(p.u) >= std::fabs(p.v);
  const double larger = sideways ? p.u : p.v;
  if (larger == 0.0) return p;
  p.perimeter = perimeter(sideways, larger, round((sideways ? p.v : p.u) / larger), round);
  return p;
}

// By which sides the line comes into the square, or goes out of it: u is 1 or -1 there, or v is.
struct Sides {
  int u, v;
  // The line goes along (b, -a): it comes in by the sides behind that direction.
  Sides(const Line& line, bool in)
      : u((line.b > 0) != in ? 1 : -1), v((line.a < 0) != in ? 1 : -1) {}

  // Of End::sides.
  std::array<std::size_t, 2> indices() const { return {u > 0 ? 0U : 1U, v > 0 ? 2U : 3U}; }
};

// Where the line crosses one of two sides; nothing if it misses the square.
std::optional<Point> crossing(const Line& line, const Sides& sides, Rounder round) {
  const auto size = [](std::int64_t x) { return x < 0 ? -x : x; };
  const auto [u, v] = sides;
  if (const std::int64_t at = line.c + u * line.a; line.b != 0 && size(at) <= size(line.b)) {
    const double across = -round(round(at, 0) / round(line.b, 0));
    return Point{static_cast<double>(u), across, 1.0, perimeter(true, u, u * across, round)};
  }
  if (const std::int64_t at = line.c + v * line.b; line.a != 0 && size(at) <= size(line.a)) {
    const double across = -round(round(at, 0) / round(line.a, 0));
    return Point{across, static_cast<double>(v), 1.0, perimeter(false, v, v * across, round)};
  }
  return std::nullopt;
}

}  // namespace

double coverage(const RectangleSetup& setup, const Place& at, Rounder round) {
  const auto end_at = [&](const RectangleSetup::End& end) {
    return End{end.u.at(at), end.v.at(at), end.w.at(at)};
  };
  const Line line{setup.line.a.at(at), setup.line.b.at(at), setup.line.c.at(at)};
  std::array<Point, 2> points;
  std::array<std::array<std::int64_t, 4>, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {
    const End end = end_at(setup.ends[i]);
    sides[i] = end.sides();
    if (std::all_of(sides[i].begin(), sides[i].end(), [](std::int64_t f) { return f >= 0; })) {
      points[i] = inner_point(end, round);
      continue;
    }
    // Where the line crosses the outline, if the end is beyond: else that is what lies behind the
    // point. By either side, as next to a corner the line's rounding picks the one, the end's the
    // other.
    const Sides by(line, i == 0);
    const auto crossed = crossing(line, by, round);
    const auto is_beyond = [&](std::size_t side) { return sides[i][side] < 0; };
    if (!crossed || std::ranges::none_of(by.indices(), is_beyond)) return 0.0;
    points[i] = *crossed;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (sides[0][k] < 0 && sides[1][k] < 0) return 0.0;
  }
  const auto& [p, q] = points;
  const double w = round(p.w * q.w);
  if (!(w > 0.0)) return 0.0;
  double turn = round(q.perimeter - p.perimeter);
  if (turn > 4.0) turn = round(turn - 8.0);
  if (turn < -4.0) turn = round(turn + 8.0);
  const double cross = round(round(p.u * q.v) - round(p.v * q.u));
  return std::min(0.125 * round(std::fabs(turn - round(cross / w))), 0.5);
}

}  // namespace wedgesim::model::datapath

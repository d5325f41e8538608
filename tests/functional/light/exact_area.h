#pragma once

#include <cmath>
#include <vector>

namespace wedgesim::functional {

/// Areas in the plane of a light, exact but for rounding: what coverage is measured against. It
/// clips polygons; the renderer never does.
struct LightPoint {
  long double x = 0.0L;
  long double y = 0.0L;
};
using LightPolygon = std::vector<LightPoint>;

/// The part of a polygon where a·x + b·y + c ≥ 0.
inline LightPolygon clip_half_plane(const LightPolygon& polygon, long double a, long double b,
                                    long double c) {
  LightPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LightPoint& p = polygon[i];
    const LightPoint& q = polygon[(i + 1) % polygon.size()];
    const long double at_p = a * p.x + b * p.y + c;
    const long double at_q = a * q.x + b * q.y + c;
    if (at_p >= 0.0L) kept.push_back(p);
    if ((at_p >= 0.0L) != (at_q >= 0.0L)) {
      const long double t = at_p / (at_p - at_q);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return kept;
}

inline LightPolygon square_of(long double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

/// Signed area.
inline long double area_of(const LightPolygon& polygon) {
  long double doubled = 0.0L;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LightPoint& p = polygon[i];
    const LightPoint& q = polygon[(i + 1) % polygon.size()];
    doubled += p.x * q.y - q.x * p.y;
  }
  return 0.5L * doubled;
}

/// Signed area of a polygon within the unit disc: along each side the parts inside the disc count
/// as triangles from the centre, those outside as sectors.
inline long double area_in_disc(const LightPolygon& polygon) {
  const auto triangle = [](const LightPoint& p, const LightPoint& q) {
    return 0.5L * (p.x * q.y - q.x * p.y);
  };
  const auto sector = [](const LightPoint& p, const LightPoint& q) {
    return 0.5L * std::atan2(p.x * q.y - q.x * p.y, p.x * q.x + p.y * q.y);
  };
  long double area = 0.0L;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LightPoint& p = polygon[i];
    const LightPoint& q = polygon[(i + 1) % polygon.size()];
    const long double dx = q.x - p.x;
    const long double dy = q.y - p.y;
    const long double length = std::sqrt(dx * dx + dy * dy);
    if (length == 0.0L) continue;
    const long double foot = -(p.x * dx + p.y * dy) / length;  // along the side, from p
    const long double off = (p.x * dy - p.y * dx) / length;
    const auto at = [&](long double s) {
      return LightPoint{p.x + s / length * dx, p.y + s / length * dy};
    };
    if (off * off >= 1.0L) {
      area += sector(p, q);
      continue;
    }
    const long double half = std::sqrt(1.0L - off * off);
    const long double enter = std::fmin(std::fmax(foot - half, 0.0L), length);
    const long double leave = std::fmin(std::fmax(foot + half, 0.0L), length);
    if (enter >= leave) {
      area += sector(p, q);
      continue;
    }
    if (enter > 0.0L) area += sector(p, at(enter));
    area += triangle(at(enter), at(leave));
    if (leave < length) area += sector(at(leave), q);
  }
  return area;
}

}  // namespace wedgesim::functional

#include "reports/accuracy/equal_error.h"

#include <algorithm>
#include <cmath>

#include "reports/accuracy/recommend.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr std::string_view kRays = "raytraced";

struct Point {
  double log_error = 0.0, log_seconds = 0.0;
};

// The largest error first, each error once.
std::vector<Point> points_of(const std::vector<Measured>& methods) {
  std::vector<Point> points;
  for (const Measured& measured : methods) {
    if (measured.refused || measured.choice.method->name != kRays) continue;
    if (error_of(measured) <= 0.0 || seconds_of(measured) <= 0.0) continue;
    points.push_back({std::log(error_of(measured)), std::log(seconds_of(measured))});
  }
  std::ranges::sort(points, std::ranges::greater(), &Point::log_error);
  const auto same = std::ranges::unique(points, {}, &Point::log_error);
  points.erase(same.begin(), same.end());
  return points;
}

}  // namespace

std::optional<RayTraced> ray_traced_for(const std::vector<Measured>& methods, double error) {
  const std::vector<Point> points = points_of(methods);
  if (points.size() < 2) return std::nullopt;
  const double at = std::log(error);
  std::size_t right = 1;  // of the line's two points, the one of smaller error
  while (right + 1 < points.size() && at < points[right].log_error) ++right;
  const Point& a = points[right - 1];
  const Point& b = points[right];
  const double share = (at - a.log_error) / (b.log_error - a.log_error);
  return RayTraced{std::exp(a.log_seconds + share * (b.log_seconds - a.log_seconds)),
                   share < 0.0 || share > 1.0};
}

std::optional<RayTraced> ray_traced_like(const std::vector<Measured>& methods,
                                         const Measured& choice) {
  if (choice.refused || choice.choice.method->name == kRays || !(error_of(choice) > 0.0)) {
    return std::nullopt;
  }
  return ray_traced_for(methods, error_of(choice));
}

}  // namespace wedgesim::reports::accuracy

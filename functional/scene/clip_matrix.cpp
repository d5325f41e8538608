#include "functional/scene/clip_matrix.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr double kTolerance = 1e-3;

}  // namespace

std::string camera_of_clip_matrix(const glm::dmat4& clip_from_world, double width_by_height,
                                  Camera& camera) {
  const glm::dmat4 rows = glm::transpose(clip_from_world);
  const glm::dvec3 x(rows[0]);
  const glm::dvec3 y(rows[1]);
  const glm::dvec3 w(rows[3]);
  const double scale = glm::length(w);
  if (!(scale > 0.0)) return "has no perspective: its last row is (0, 0, 0, 1) or the like";
  const glm::dvec3 ahead = w / scale;
  const double shift_x = glm::dot(x, ahead) / scale;
  const double shift_y = glm::dot(y, ahead) / scale;
  if (std::abs(shift_x) > kTolerance || std::abs(shift_y) > kTolerance) {
    return fmt::format("is off centre by {:.3g}, {:.3g} of half a frame", shift_x, shift_y);
  }
  const double zoom_x = glm::length(x) / scale;
  const double zoom_y = glm::length(y) / scale;
  if (!(zoom_x > 0.0 && zoom_y > 0.0)) return "has an empty row";
  if (std::abs(zoom_x * width_by_height / zoom_y - 1.0) > kTolerance) {
    return fmt::format("has pixels {:.3g} times as high as wide in a frame of this size",
                       zoom_x * width_by_height / zoom_y);
  }
  const glm::dvec3 right = x / glm::length(x);
  const glm::dvec3 up = y / glm::length(y);
  if (std::abs(glm::dot(right, up)) > kTolerance) return "is skewed: x is not across y";
  if (glm::dot(glm::cross(up, right), ahead) < 0.0) {
    return "is mirrored: seen along the view, x must point right where y points up";
  }
  // The eye is where x, y and w are all 0.
  const glm::dmat3 across = glm::transpose(glm::dmat3(x, y, w));
  camera.eye = glm::inverse(across) * -glm::dvec3(rows[0].w, rows[1].w, rows[3].w);
  camera.target = camera.eye + ahead;
  camera.up = up;
  camera.field_of_view_degrees = 2.0 * glm::degrees(std::atan(1.0 / zoom_y));
  return {};
}

}  // namespace wedgesim::functional

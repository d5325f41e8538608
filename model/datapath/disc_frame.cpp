#include "model/datapath/disc_frame.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::model::datapath {
namespace {

// Any direction across another.
glm::dvec3 across(const glm::dvec3& direction) {
  const glm::dvec3 axis = std::fabs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(direction, axis));
}

}  // namespace

DiscFrame disc_frame(const glm::dvec3& begin, const glm::dvec3& end) {
  DiscFrame frame;
  const glm::dvec3 edge = end - begin;
  frame.along = glm::normalize(edge == glm::dvec3(0.0) ? begin : edge);
  // The foot of the centre on the line, from the nearer end: the farther one would lose its digits.
  const bool begin_nearer = glm::dot(begin, begin) <= glm::dot(end, end);
  const glm::dvec3& nearer = begin_nearer ? begin : end;
  // Twice: the first time leaves a part along the line, rounding of the nearer end, which beside a
  // line close to the centre is not small.
  glm::dvec3 foot = nearer;
  for (int i = 0; i < 2; ++i) foot -= glm::dot(foot, frame.along) * frame.along;
  frame.distance = glm::length(foot);
  // A line through the centre is an edge that points at the light: any direction will do.
  frame.out = frame.distance > 0.0 ? foot / frame.distance : across(frame.along);
  frame.normal = glm::cross(frame.along, frame.out);
  frame.ends = {glm::dot(begin, frame.along), glm::dot(end, frame.along)};
  return frame;
}

}  // namespace wedgesim::model::datapath

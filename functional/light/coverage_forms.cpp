#include "functional/light/coverage_forms.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

CoverageForms rectangle_forms(const glm::dmat4& rows, const glm::dvec3& begin,
                              const glm::dvec3& end) {
  CoverageForms result;
  std::size_t i = 0;
  for (const glm::dvec3& e : {begin, end}) {
    result.forms[i++] = e.x * rows[2] - e.z * rows[0];
    result.forms[i++] = e.y * rows[2] - e.z * rows[1];
    result.forms[i++] = rows[2] - e.z * rows[3];
  }
  return result;
}

CoverageForms sphere_forms(const glm::dmat4& rows, const glm::dvec3& begin, const glm::dvec3& end) {
  const glm::dvec3 edge = end - begin;
  const glm::dvec3 along = glm::normalize(edge == glm::dvec3(0.0) ? begin : edge);
  // The foot of the centre on the line, from the nearer end: the farther one would lose its digits.
  const glm::dvec3& nearer = glm::dot(begin, begin) <= glm::dot(end, end) ? begin : end;
  // Twice: the first time leaves a part along the line, which beside a line close to the centre is
  // not small.
  glm::dvec3 foot = nearer;
  for (int i = 0; i < 2; ++i) foot -= glm::dot(foot, along) * along;
  const double distance = glm::length(foot);
  const glm::dvec3 out = distance > 0.0 ? foot / distance : Across(along).u;
  const auto component = [&](const glm::dvec3& axis) {
    return axis.x * rows[0] + axis.y * rows[1] + axis.z * rows[2];
  };
  CoverageForms result;
  result.forms = {component(along), component(out), component(glm::cross(along, out)), rows[3]};
  result.forms[4] = distance * rows[3] - result.forms[1];
  result.constants[0] = static_cast<float>(distance);
  for (std::size_t i = 0; i < 2; ++i) {
    const double place = glm::dot(i == 0 ? begin : end, along);
    result.forms[5 + i] = place * rows[3] - result.forms[0];
    result.constants[1 + i] = static_cast<float>(place);
  }
  return result;
}

}  // namespace

CoverageForms coverage_forms(LightShape shape, const glm::dmat4& light_from_window,
                             const glm::dvec3& begin, const glm::dvec3& end) {
  const glm::dmat4 rows = glm::transpose(light_from_window);
  return shape == LightShape::rectangle ? rectangle_forms(rows, begin, end)
                                        : sphere_forms(rows, begin, end);
}

CoverageForms cone_forms(const glm::dmat4& light_from_window, const glm::dvec3& begin,
                         const glm::dvec3& end) {
  const glm::dmat4 rows = glm::transpose(light_from_window);
  CoverageForms result;
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    result.forms[axis] = begin[i] * rows[3] - rows[i];
    result.forms[3 + axis] = end[i] * rows[3] - rows[i];
    result.constants[axis] = static_cast<float>(begin[i]);
  }
  result.forms[6] = rows[3];
  return result;
}

}  // namespace wedgesim::functional

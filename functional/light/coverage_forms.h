#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What an edge's coverage of a light is computed from, linear in window space.
struct CoverageForms {
  /// Rectangle: u, v and w of the edge's begin, then of its end, projected from a point onto the
  /// light's plane, in half axes. Sphere: the point along the edge, out from the light's centre to
  /// the edge's line and across both, its homogeneous w, then w·distance − out and, for both ends,
  /// w·end − along.
  std::array<glm::dvec4, 8> forms{};
  /// Sphere: the line's distance from the light's centre, the ends' places along it, in radii.
  std::array<float, 8> constants{};
};

/// \param light_from_window  homogeneous light space (coverage.h) from window space
/// \param begin, end         light space
CoverageForms coverage_forms(LightShape shape, const glm::dmat4& light_from_window,
                             const glm::dvec3& begin, const glm::dvec3& end);

/// What the cone from a point through a spherical light's disc clips (sector_simd.h): as forms the
/// way to the edge's begin and to its end, times w, and w; as constants its begin.
CoverageForms cone_forms(const glm::dmat4& light_from_window, const glm::dvec3& begin,
                         const glm::dvec3& end);

}  // namespace wedgesim::functional

#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Homogeneous light space from world space, w = 1. Rectangle: u and v in half axes, third the
/// distance from the light's plane in world units. Sphere: world axes about the centre, in radii;
/// point: in world units.
glm::dmat4 light_from_world(const Light& light);

/// An edge as a point sees it on a rectangular light: the ends of the part inside it, light space.
struct Chord {
  glm::dvec2 p{0.0}, q{0.0};
};

/// Projects an edge from a point onto a rectangular light and clips it there, in homogeneous
/// coordinates (Paper IV, 4.2.2).
/// \param point, begin, end  light space; begin and end in front of the light (third > 0)
/// \return the chord in the square [−1, 1]²; none if nothing of the edge is before the light
std::optional<Chord> project_edge(const glm::dvec3& point, const glm::dvec3& begin,
                                  const glm::dvec3& end);

/// Fraction of a rectangular light that the shadow quad of an edge hides: the part of the light
/// between the rays from its centre through the edge's ends, beyond the edge, all as seen from a
/// point and projected onto the light.
/// \param point, begin, end  light space; begin and end in front of the light (third > 0)
/// \return [0, 1/2]
/// Source: Paper III, 3.2.2, exact clipping; the area by its outline (shoelace).
double rectangle_coverage(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end);

/// The same for a spherical light: of the disc that the cone from the point, tangent to the
/// sphere, cuts from the plane through the centre across the cone's axis.
/// \param point, begin, end  light space (radii); all outside the sphere
/// \return [0, 1/2]; 0 if the point is not outside the sphere
/// Source: Paper IV, 4.2.1; the true tangent cone instead of its disc of the light's radius.
double sphere_coverage(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end);

/// Coverage by the light's shape; 0 for a point.
double coverage(LightShape shape, const glm::dvec3& point, const glm::dvec3& begin,
                const glm::dvec3& end);

}  // namespace wedgesim::functional

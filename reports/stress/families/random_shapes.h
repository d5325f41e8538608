#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace wedgesim::reports::stress {

/// A closed mesh: corners (x, up, z) in [-1, 1], triangles counter-clockwise from outside.
struct Shape {
  std::vector<glm::dvec3> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// 0 a tetrahedron, 1 an octahedron, 2 a prism of three sides, 3 a box, 4 two pyramids over a star,
/// else a twisted box: at most 8 corners and 12 triangles.
Shape shape_of(int number);

}  // namespace wedgesim::reports::stress

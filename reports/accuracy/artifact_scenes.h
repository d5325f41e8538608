#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::reports::accuracy {

// Scenes that show artifacts alone, 240x240 pixels unless built in.

/// At 960x640 pixels.
functional::Scene built_in_scene(const std::string& name);

/// A thin polygon over a floor, below a square light of half side `light` at height 10, seen from
/// above: a world unit of the floor is 40 pixels.
/// \param outline  x and z, counter-clockwise from above
functional::Scene thin_polygon(const std::vector<glm::dvec2>& outline, double height, double light);
/// A board of half sides `half`, turned by `turn` radians.
functional::Scene thin_board(const glm::dvec2& half, double turn, double height, double light);

/// As many thin bars, `gap` apart, in the place of the polygon.
functional::Scene fence(int bars, double width, double gap, double height, double light);

/// Boxes over a floor, below a spherical light at height 8, seen at an angle.
struct Box {
  glm::dvec3 size, position, turn_degrees{0.0};
};
functional::Scene boxes_below_sphere(const std::vector<Box>& boxes, double radius);
/// As many bars beside each other, `gap` apart.
functional::Scene comb_below_sphere(int bars, double width, double gap, double radius);

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <glm/vec2.hpp>

#include "functional/scene/primitives.h"
#include "functional/scene/scene.h"

namespace wedgesim::tests {

/// The frame of invariants/hand_worked_test.cpp, whose comment explains it: a thin triangular prism
/// over a floor, 16x16 pixels.
inline functional::Scene hand_worked_scene() {
  functional::Scene scene;
  scene.name = "hand-worked";
  scene.width = 16;
  scene.height = 16;
  scene.camera = {{0.0, 8.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 90.0, 2.0, 10.0};
  scene.light.centre = {-2.75, 8.0, -1.625};
  scene.light.half_u = {1.5, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.5};
  scene.objects.push_back({functional::make_plane({22.0, 20.0}, {1, 1})});
  functional::Object prism;
  prism.mesh.name = "prism";
  for (const double y : {4.0, 4.0 - 1.0 / 32.0}) {
    for (const glm::dvec2 pixel : {glm::dvec2(0.375, 3.0), {8.375, 3.0}, {0.375, 11.0}}) {
      prism.mesh.positions.emplace_back((pixel.x - 8.0) / 2.0, y, (pixel.y - 8.0) / 2.0);
    }
  }
  prism.mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                          {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  prism.casts = true;
  scene.objects.push_back(std::move(prism));
  return scene;
}

}  // namespace wedgesim::tests

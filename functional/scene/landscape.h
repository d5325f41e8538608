#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

struct LandscapeStyle {
  glm::dvec2 size{20.0};  // along x and z
  double height = 2.0;    // from the lowest point, at y = 0, to the highest
  int cells = 224;        // along x and z: 224 give 100,352 triangles
  int octaves = 6;        // of noise, each of twice the frequency and half the height
  double features = 3.0;  // wave lengths of the first octave along a side
  std::uint32_t seed = 1;
};

/// A fractal landscape: a grid raised by seeded value noise; the same on every machine. A receiver.
Mesh make_landscape(const LandscapeStyle& style);

}  // namespace wedgesim::functional

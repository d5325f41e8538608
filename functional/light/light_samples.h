#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Where the samples of a light are.
enum class SamplePattern {
  random,  // stratified, one in each row and each column, the outer ones on the border
  grid,    // rows and columns from border to border
  border,  // along the border alone, evenly
};

/// Points of the square [-1, 1]²; a single one is in the middle.
/// \param count  at least 1; a grid takes the next lower square number
std::vector<glm::dvec2> square_samples(int count, SamplePattern pattern, std::uint64_t seed = 1);

/// Points of a light: of a rectangle, or of the disc that a sphere is seen as; of a light without
/// extent its centre alone.
/// \param seen_from  world point outside the light that the disc faces
/// Source: the rings' paper, 3.3.1: randomly distributed, the border preferred.
std::vector<glm::dvec3> light_samples(const Light& light, int count, SamplePattern pattern,
                                      const glm::dvec3& seen_from, std::uint64_t seed = 1);

}  // namespace wedgesim::functional

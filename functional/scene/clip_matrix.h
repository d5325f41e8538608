#pragma once

#include <glm/mat4x4.hpp>
#include <string>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The camera of a matrix that takes world points (x, y, z, 1) to clip space: x right and y up
/// over w, in [-1, 1] within the frame. Its row of z is not used.
/// \param camera          keeps its near and far planes
/// \param width_by_height of the frame; pixels are square
/// \return                why it is no such camera; nothing if it is
/// Accuracy: refuses what departs from a symmetric perspective of square pixels by more than 1e-3.
std::string camera_of_clip_matrix(const glm::dmat4& clip_from_world, double width_by_height,
                                  Camera& camera);

}  // namespace wedgesim::functional

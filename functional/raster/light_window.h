#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The square window through which a spherical light's centre sees every caster and every penumbra
/// of theirs; its homogeneous w is the depth from the light.
/// \param centre  of the light; \param radius of it, world units, 0 for a point
/// \param size    texels along an edge
/// \throws InputError if the casters, or their penumbrae, span a half-space about the light
Window make_light_window(std::span<const Object> objects, const glm::dvec3& centre, double radius,
                         int size);

/// Texels at depth 1 of one world unit across the axis.
double focal_length(const Window& light_window);

}  // namespace wedgesim::functional

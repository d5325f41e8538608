#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A box that stands on y = 0, centred on the y axis: 8 vertices, 12 triangles.
/// \param size  edge lengths, world units, above 0
Mesh make_box(glm::dvec3 size);

/// A horizontal grid at y = 0 that faces up, centred on the origin; not closed: a receiver.
/// \param size   lengths along x and z
/// \param cells  cells along x and z, two triangles each
Mesh make_plane(glm::dvec2 size, glm::ivec2 cells);

/// A thin horizontal polygon at y = 0: two opposite faces over the same vertices, their inner
/// edges different, so that it is a closed two-manifold of no volume.
/// \param points  (n) x and z, n >= 4, convex and counter-clockwise seen from above, checked
Mesh make_thin_polygon(const std::vector<glm::dvec2>& points);

/// A ring of tube radius `tube` round the y axis, centred on the origin.
Mesh make_torus(double radius, double tube, int segments, int tube_segments);

/// A sphere round the origin with its poles on the y axis.
/// \param segments  round the axis, at least 3
/// \param rings     from pole to pole, at least 2
Mesh make_sphere(double radius, int segments, int rings);

}  // namespace wedgesim::functional

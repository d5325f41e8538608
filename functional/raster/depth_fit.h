#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "functional/raster/depth_buffer.h"

namespace wedgesim::functional {

/// How a frame's depth agrees with the meshes that it should show. Pixels at the meshes' outline
/// are not judged, as renderers draw edges differently, only counted; each of the others is one of
/// the three.
struct DepthFit {
  std::size_t outline = 0;         // pixels that the meshes cover, but not all their neighbours
  std::size_t outline_behind = 0;  // those of them where one sees through the mesh
  std::size_t meshes = 0;          // pixels that the meshes cover with all their neighbours
  std::size_t agree = 0;           // within the tolerance of the mesh
  std::size_t hidden = 0;          // something else is in front
  std::size_t behind = 0;          // one sees through the mesh: the frame cannot be of this scene
  std::optional<std::array<int, 2>> first_behind;  // x, y

  static constexpr double kMostBehind = 0.01;  // of the meshes' pixels: inner edges
  bool fits() const {
    return static_cast<double>(behind) <= kMostBehind * static_cast<double>(meshes);
  }
};

/// Compares distances along the view direction. A pixel agrees within the span of the mesh's
/// distances in its 3x3 neighbourhood, widened by a part of the distance.
/// \param depth     of the frame, as large as the window
/// \param meshes    of the meshes alone, with triangles
/// \param tolerance part of the distance, above 0
DepthFit fit_depth(const Window& window, const DepthBuffer& depth, const DepthBuffer& meshes,
                   double tolerance);

}  // namespace wedgesim::functional

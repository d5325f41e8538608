#pragma once

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "functional/raster/window.h"

namespace wedgesim::functional {

/// From the eye's window to a window seen from a light, both homogeneous.
struct LightFromEye {
  LightFromEye(const Window& light, const Window& eye)
      : place(light.window_from_world * eye.world_from_window),
        scale(eye.world_from_window[0][3], eye.world_from_window[1][3], eye.world_from_window[2][3],
              eye.world_from_window[3][3]) {}
  glm::dmat4 place;
  glm::dvec4 scale;  // of a point's homogeneous world
};

/// Where pixels that stand side by side in a row are in the light's window.
struct LightPlaces {
  static constexpr int kPixels = 64;
  static constexpr float kNowhere = -1e30F;
  std::array<float, kPixels> x, y;           // x is kNowhere behind the light and in the sky
  std::array<float, kPixels> inverse_depth;  // 1/w of the light's window
};

}  // namespace wedgesim::functional

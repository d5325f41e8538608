#pragma once

#include <vector>

#include "base/image.h"
#include "functional/methods/method.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What the eye sees of a scene and how much of the light reaches it.
struct View {
  Window window;
  DepthBuffer depth;
  Visibility visibility;                     // of `Scene::light`
  std::vector<Visibility> other_visibility;  // of each of `Scene::other_lights`
};

/// Renders the depth of a scene and, by one method that is called once a light, the visibility of
/// its lights.
/// \throws InputError if the method cannot render the scene
View render_view(const Scene& scene, const MethodChoice& choice,
                 traces::fb::DepthFormat format = traces::fb::DepthFormat_float32);

/// Lights a view by all its lights: each triangle diffusely from a light's centre, times that
/// light's power and its visibility clamped to [0, 1], and evenly from a sky above.
/// \return (height, width, 3) linear colour, [0, 1]
Image shade(const Scene& scene, const View& view);

/// The same by `scene.light` alone.
/// \param visibility  (height, width), or (height, width, 3) for each colour
Image shade(const Scene& scene, const Window& window, const DepthBuffer& depth,
            const std::vector<float>& visibility);

/// Linear colour as the sRGB curve encodes it for 8-bit files; values clamped to [0, 1].
Image encode_srgb(const Image& linear);

}  // namespace wedgesim::functional

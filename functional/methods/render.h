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
  Visibility visibility;
};

/// Renders the depth of a scene and, by one method, the visibility of its light.
/// \throws InputError if the method cannot render the scene
View render_view(const Scene& scene, const MethodChoice& choice,
                 traces::fb::DepthFormat format = traces::fb::DepthFormat_float32);

/// Lights a view: each triangle diffusely from the light's centre, times the visibility clamped to
/// [0, 1], and evenly from a sky above.
/// \param visibility  (height, width)
/// \return (height, width, 3) linear colour, [0, 1]
Image shade(const Scene& scene, const Window& window, const DepthBuffer& depth,
            const std::vector<float>& visibility);

/// Linear colour as the sRGB curve encodes it for 8-bit files; values clamped to [0, 1].
Image encode_srgb(const Image& linear);

}  // namespace wedgesim::functional

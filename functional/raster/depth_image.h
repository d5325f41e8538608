#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "base/image.h"
#include "functional/raster/depth_buffer.h"

namespace wedgesim::functional {

/// What the values of a depth image mean.
enum class DepthMeaning {
  window,    // [0, 1], 0 near: what Direct3D, Vulkan and OpenGL store
  reversed,  // [0, 1], 1 near
  ndc,       // [-1, 1], -1 near: OpenGL before the depth range
  view,      // distance along the view direction, world units; the far plane and beyond: sky
  distance,  // distance from the eye, world units; as above
};

/// Their names.
inline constexpr std::array<std::pair<std::string_view, DepthMeaning>, 5> kDepthMeanings{
    {{"window", DepthMeaning::window},
     {"reversed", DepthMeaning::reversed},
     {"ndc", DepthMeaning::ndc},
     {"view", DepthMeaning::view},
     {"distance", DepthMeaning::distance}}};

/// Turns one channel of another renderer's depth image into stored depth.
/// \param image   as large as the window
/// \param place   the file, as errors name it
/// \return        words of `format`; no triangles
/// \throws InputError if the size differs or a value is no depth: NaN, or out of the meaning's
/// range
DepthBuffer depth_of_image(const Image& image, std::size_t channel, DepthMeaning meaning,
                           const Window& window, traces::fb::DepthFormat format,
                           const std::string& place);

/// The channel of a name, or, without one, the only channel, Z or depth.
/// \throws InputError naming the channels there are
std::size_t depth_channel(const Image& image, const std::string& name, const std::string& place);

/// The image turned upside down.
Image flipped(const Image& image);

}  // namespace wedgesim::functional

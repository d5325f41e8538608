#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>

#include "base/image.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A picture of a burning fire: turbulence that rises through a flame, black around it, red, orange
/// and yellow in it.
/// \param frame   of `frames`, after which the fire repeats
/// \param side    texels each way, at least 2
/// \return        (side, side, 3), linear, [0, 1]; the flame's tip in the first row
Image make_fire(int frame, int frames, int side, std::uint32_t seed);

/// Reads a texture: linear from EXR, along the sRGB curve from other formats; grey, RGB or RGBA,
/// whose alpha is dropped.
/// \return (height, width, 3), 1 to 256 texels each way
/// \throws InputError if it is no such image, or emits less than nothing, or nothing at all
Image read_light_texture(const std::filesystem::path& path);

/// What each texel emits of the light's power, colour by colour.
/// \param texture  (height, width, 3), 0 and above
/// \return         the same shape; each colour sums to 1, evenly spread if no texel emits it
Image emission_shares(const Image& texture);

/// The power of a light in each colour: its colour, times the mean of its texture.
glm::dvec3 light_power(const Light& light);

}  // namespace wedgesim::functional

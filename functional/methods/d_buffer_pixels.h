#pragma once

#include <cstdint>
#include <vector>

#include "functional/methods/d_buffer_map.h"
#include "functional/methods/facing.h"
#include "functional/methods/method.h"

namespace wedgesim::functional {

/// How a D-buffer's distances become the visible part of the light.
struct DBufferPixels {
  /// What an edge leaves of the disk whose diameter it leaves the part t of: 3t² − 2t³, √t, or the
  /// disk's area beside a straight line.
  enum class Falloff { smooth, sqrt, exact };
  /// t as it follows from similar triangles, or as the paper prints it (docs/methods.md).
  enum class Parameter { derived, printed };

  Falloff falloff = Falloff::smooth;
  Parameter parameter = Parameter::derived;
  bool bilinear = false;  // of four texels' visibilities
};

/// Looks pixels up in a D-buffer; outside of it and in the sky all of the light is visible.
/// \param facings  of each triangle of the scene, to the disk's centre
/// \param values   of each pixel
/// \return texels looked up
std::uint64_t look_up_pixels(const MethodInput& input, const DBuffer& map,
                             const std::vector<Facing>& facings, const DBufferPixels& options,
                             std::vector<float>& values);

}  // namespace wedgesim::functional

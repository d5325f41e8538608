#pragma once

#include <vector>

#include "functional/raster/volume_raster.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The kernel of Paper IV's shader for a light's shape: clipping, then its tables
/// (shader_tables.h). A sphere's wedges have cone_forms (coverage_forms.h).
DrawRow table_kernel(LightShape shape);

/// Kernels for words over four 8-bit components (split_word.h). Three channels: what wedges add and
/// what they take, each a float whose bits are the four components, blended component by
/// component up to 255; and the umbra.
/// \param tables  as table_kernel; else exact clipping
DrawRow split_kernel(LightShape shape, bool tables);
/// What these channels say.
/// \param planes  (3, height, width) as drawn
/// \return (height, width)
std::vector<float> merged_split_words(const std::vector<float>& planes);

}  // namespace wedgesim::functional

#pragma once

#include <cstdint>

#include "traces/trace.h"

namespace wedgesim::traces {

/// A small sound trace, 4x3 pixels, with something in every section: wedges[0] is `coverage` with
/// two faces and umbra_polygons[0], wedges[1] is `linear` with one face and no umbra polygon;
/// umbra_polygons[1] is a bottom, [2] a cap; lights[0] a textured rectangle, [1] a point.
Trace sample_trace();

/// A sound trace of random content, the same for the same seed; some with nothing in some sections.
Trace random_trace(std::uint64_t seed);

}  // namespace wedgesim::traces

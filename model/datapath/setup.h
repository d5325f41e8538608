#pragma once

#include <variant>

#include "model/datapath/disc_coverage.h"
#include "model/datapath/formats.h"
#include "model/datapath/inside_test.h"
#include "model/datapath/linear_intensity.h"
#include "model/datapath/rectangle_coverage.h"
#include "traces/trace.h"

namespace wedgesim::model::datapath {

/// The constants of one wedge's light intensity or coverage.
using LightSetup = std::variant<LinearSetup, RectangleSetup, DiscSetup>;

/// What the driver of the block prepares, in double precision, and rounds once into the formats.
LightSetup light_setup(const traces::TraceView& trace, const traces::fb::Wedge& wedge,
                       const ZSteps& steps, const Formats& formats);

/// A trace's plane for inside and box tests, the same for all that refer to it.
/// \param reference  2 * index + sign
FixedPlane plane_setup(const traces::TraceView& trace, std::uint32_t reference, const ZSteps& steps,
                       const Formats& formats);

/// The light intensity or coverage of a wedge at a point inside it.
/// \return      [0, 1] for `linear`, [0, 0.5] for `coverage`
double contribution(const LightSetup& setup, const Place& at, Rounder round);

}  // namespace wedgesim::model::datapath

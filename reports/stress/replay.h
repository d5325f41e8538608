#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/stress/case_name.h"
#include "reports/stress/measure.h"

namespace wedgesim::reports::stress {

/// How far a pixel is off beyond its sensitivity; not finite LI is off without end.
double excess_at(const Measurement& measurement, Arithmetic arithmetic, std::size_t pixel);

/// The pixels that are farthest off, beyond their sensitivity, the worst first; none that is right.
/// \return indices into the frame, at most `most`
std::vector<std::size_t> worst_pixels(const Measurement& measurement, Arithmetic arithmetic,
                                      std::size_t most);

/// The first arithmetic with a pixel beyond its bar.
std::optional<Arithmetic> first_beyond(const Measurement& measurement);

/// One case in words: every error of every arithmetic, flagged wedges, the worst pixels.
std::string replay_text(const CaseName& name, const Measurement& measurement);

/// Is there no silent pixel, do modes, cullings and tile sizes agree, and is no frame refused that
/// must not be?
bool replay_holds(const CaseName& name, const Measurement& measurement);

}  // namespace wedgesim::reports::stress

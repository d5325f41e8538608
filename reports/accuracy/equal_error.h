#pragma once

#include <optional>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {

/// What ray tracing would take for an error.
struct RayTraced {
  double seconds = 0.0;       // on all threads
  bool extrapolated = false;  // the error is none between those that were measured
};

/// Read off the choices of `raytraced`: straight lines between neighbours, and beyond the ends,
/// where both error and run time are logarithms.
/// \param error  RMSE on receivers, above 0
/// \return nothing with fewer than two choices of `raytraced`
std::optional<RayTraced> ray_traced_for(const std::vector<Measured>& methods, double error);

/// The same for a choice's error; nothing for `raytraced` itself, what was refused, and a choice
/// without error.
std::optional<RayTraced> ray_traced_like(const std::vector<Measured>& methods,
                                         const Measured& choice);

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reports/stress/errors.h"
#include "reports/stress/family.h"
#include "reports/stress/flag.h"

namespace wedgesim::reports::stress {

struct Measurement {
  std::optional<std::string> refused;  // why there is no frame
  int width = 0, height = 0;
  std::size_t wedges = 0, degenerate_wedges = 0, judged = 0;
  /// Of the judged pixels those inside a wedge of sensitivity <= 1/255: those of rms_penumbra.
  std::size_t in_penumbra = 0;
  /// Of the plane of a shadow quad: its normal's relative change for a relative change of the
  /// input's coordinates, at most.
  double condition = 1.0;
  /// Modes, cullings and tile sizes give the same words as the plain evaluation.
  bool configurations_agree = true;
  std::array<Errors, kArithmetics.size()> errors;
  std::array<std::vector<Flagged>, kArithmetics.size()> flagged;  // each by number
  std::vector<double> judge;          // (height, width) LI; of the sky NaN
  std::vector<double> sensitivities;  // (height, width), the judge's where a pixel may be off
  double judge_seconds = 0.0;         // of one thread, for the judge's LI alone
};

/// Makes a case's frame and holds every arithmetic against the judge.
Measurement measure(const Case& stress_case);

}  // namespace wedgesim::reports::stress

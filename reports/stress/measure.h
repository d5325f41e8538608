#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "functional/methods/frame.h"
#include "model/count/config.h"
#include "reports/stress/family.h"
#include "reports/stress/flag.h"

namespace wedgesim::reports::stress {

/// What a frame is computed in: the block's datapaths, and the renderer, which wrote the expected
/// LI in double precision.
enum class Arithmetic { fixed, float32, double_precision, renderer };
inline constexpr std::array kArithmetics{Arithmetic::fixed, Arithmetic::float32,
                                         Arithmetic::double_precision, Arithmetic::renderer};
inline constexpr std::array<std::string_view, 4> kArithmeticNames{"fixed", "float32", "double",
                                                                  "renderer"};
constexpr std::string_view name_of(Arithmetic arithmetic) {
  return kArithmeticNames[static_cast<std::size_t>(arithmetic)];
}
/// How far a pixel may be off besides its own sensitivity, units of full light.
constexpr double tolerance_of(Arithmetic arithmetic) {
  const bool wide = arithmetic == Arithmetic::fixed || arithmetic == Arithmetic::float32;
  return wide ? 2.0 / 255.0 : 1e-6;
}
/// How far LI's step across a plane may be off: as far as the pixels on both its sides.
constexpr double largest_jump_of(Arithmetic arithmetic) { return 2.0 * tolerance_of(arithmetic); }
/// RMS over the frame, and over its penumbrae, of the pixels of sensitivity <= 1/255.
inline constexpr double kLargestRms = 0.25 / 255.0;

/// One arithmetic's LI beside the judge's. Errors in units of full light; sky pixels are left out.
struct Errors {
  double max_error = 0.0;
  double max_excess = 0.0;    // of |error| - sensitivity, not below 0
  double rms = 0.0;           // over pixels of sensitivity <= 1/255
  double rms_penumbra = 0.0;  // over those of them inside a wedge
  std::uint64_t off = 0;      // pixels off by more than 1/255
  std::uint64_t beyond = 0;   // off by more than tolerance and sensitivity
  std::uint64_t specks = 0;   // off by more than 1/2 and sensitivity, and none beside is
  std::uint64_t leaks = 0;    // away from penumbrae, and not the exact whole number
  std::uint64_t signs = 0, wrong_signs = 0;  // of planes at the pixels their wedge covers
  std::uint64_t not_finite = 0, saturated = 0, overflowed = 0;
  /// Largest error of LI's step from one side of a plane of a wedge to the other, beyond the
  /// sensitivity of both; not looked for in the renderer.
  double jump = 0.0;
  std::uint64_t unflagged = 0;  // of `beyond`, pixels that belong to no wedge that is flagged
  /// Of `beyond`, those at no wedge that the arithmetic itself foresees: what flags by comparison
  /// say does not count.
  std::uint64_t unforeseen = 0;
  std::uint64_t visits = 0;  // contributions evaluated, in
  double seconds = 0.0;      // of one thread
  std::vector<double> li;    // (height, width), for pictures
  bool holds = false;        // the bar
};

struct Measurement {
  std::optional<std::string> refused;  // why there is no frame
  int width = 0, height = 0;
  std::size_t wedges = 0, degenerate_wedges = 0, judged = 0;
  /// Of the judged pixels those inside a wedge of sensitivity <= 1/255: those of rms_penumbra.
  std::size_t in_penumbra = 0;
  /// Of the plane of a shadow quad: its normal's relative change for a relative change of the
  /// input's coordinates, at most.
  double condition = 1.0;
  double sensitivity = 0.0;  // the largest of a judged pixel whose sensitivity was asked for
  /// Modes, cullings and tile sizes give the same words as the plain evaluation.
  bool configurations_agree = true;
  std::array<Errors, kArithmetics.size()> errors;
  std::array<std::vector<Flagged>, kArithmetics.size()> flagged;
  std::vector<double> judge;          // (height, width) LI; of the sky NaN
  std::vector<double> sensitivities;  // (height, width), the judge's where a pixel may be off
  double judge_seconds = 0.0;         // a pixel and wedge at a time, one thread's share
};

/// Makes a case's frame and holds every arithmetic against the judge.
Measurement measure(const Case& stress_case);

}  // namespace wedgesim::reports::stress

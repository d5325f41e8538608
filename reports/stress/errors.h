#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

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

/// The largest error of LI's step from one side of a plane of a wedge to the other, beyond the
/// sensitivity of both.
struct Jump {
  double excess = 0.0;
  std::size_t pixel = 0;
  std::uint32_t wedge = 0;
};

/// One arithmetic's LI beside the judge's. Errors in units of full light, infinite where LI is no
/// number; sky pixels are left out.
struct Errors {
  double max_error = 0.0;
  double max_excess = 0.0;    // of |error| - sensitivity, not below 0
  double rms = 0.0;           // over pixels of sensitivity <= 1/255
  double rms_penumbra = 0.0;  // over those of them inside a wedge
  std::uint64_t off = 0;      // pixels off by more than 1/255
  std::uint64_t beyond = 0;   // off by more than tolerance and sensitivity
  std::uint64_t specks = 0;   // off by more than 1/2 and sensitivity, and none beside is
  std::uint64_t leaks = 0;    // away from penumbrae, and not the exact whole number
  std::uint64_t signs = 0, wrong_signs = 0;  // of planes at the pixels they are asked at
  std::uint64_t not_finite = 0, saturated = 0, overflowed = 0;
  /// None where it was not looked for: of the renderer, and where there are too many wedges.
  std::optional<Jump> jump;
  std::uint64_t unflagged = 0;  // of `beyond`, pixels that belong to no wedge that is flagged
  /// Of `beyond`, those at no wedge that the arithmetic itself foresees: what flags by comparison
  /// say does not count.
  std::uint64_t unforeseen = 0;
  std::uint64_t visits = 0;               // contributions evaluated, in
  double seconds = 0.0;                   // of one thread
  std::vector<double> li;                 // (height, width), for pictures
  std::optional<std::size_t> first_leak;  // pixel
  bool holds = false;                     // the bar
};

/// What the judge says of a pixel.
struct JudgedPixel {
  std::size_t pixel = 0;  // row-major
  double li = 0.0, sensitivity = 0.0;
  bool in_wedge = false;
};

/// Fills in what is said of pixels: the errors, `off`, `beyond`, `specks`, `leaks`, `first_leak`.
/// \param li  (height, width)
/// \return    the pixels that are beyond
std::vector<std::size_t> compare(const std::vector<double>& li, std::span<const JudgedPixel> judged,
                                 int width, Arithmetic arithmetic, Errors& errors);

/// The bar, from all that is filled in.
bool holds(const Errors& errors, Arithmetic arithmetic);

/// Of a sensitivity of at most 1/255: pixels that RMS errors are taken over.
bool is_quiet(const JudgedPixel& pixel);

}  // namespace wedgesim::reports::stress

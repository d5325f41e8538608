#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "functional/methods/frame.h"
#include "functional/scene/scene.h"
#include "model/datapath/formats.h"

namespace wedgesim::reports::stress {

/// What kind of wedge a case has; its seed decides.
enum class Variant { rectangle, sphere, linear };
inline constexpr std::uint64_t kVariants = 3;
constexpr Variant variant_of(std::uint64_t seed) { return static_cast<Variant>(seed % kVariants); }

/// One frame of a family at one difficulty.
struct Case {
  functional::Scene scene;
  functional::FrameOptions options;  // kind and depth format; `depth` is not used
  /// Stored depths in the place of the rendered ones, for points that no scene would hit exactly.
  std::shared_ptr<const functional::DepthBuffer> depth;
  model::datapath::Formats formats;  // of the fixed datapath
};

/// Cases of one kind, from harmless to past breaking.
struct Family {
  std::string_view name;       // as in --replay
  std::string_view parameter;  // what the difficulty is, for readers
  std::string_view unit;       // of the difficulty: "rad", "", "pixels", ...
  std::vector<double> levels;  // difficulties, the harmless first; they rise or fall throughout
  /// The hardest level up to which the bar must hold; none: it is only reported.
  struct Required {
    std::optional<double> fixed, double_precision;
  } required;
  /// The same seed and difficulty give the same case. Difficulties between the levels work, too,
  /// if they are multiples of `step`.
  Case (*make)(std::uint64_t seed, double difficulty);
  /// A frame that is refused with a reason is an answer, too, at every level.
  bool may_refuse = false;
  /// Difficulties are multiples of this: those that count something. 0: any number.
  double step = 0.0;
  /// Of the levels that must hold those that cannot have a pixel in a penumbra.
  std::vector<double> empty_levels{};
  /// Whether the seed changes anything; if not, a level is one case.
  bool seeded = true;
};

/// All families, in the order of the report.
std::span<const Family> families();

}  // namespace wedgesim::reports::stress

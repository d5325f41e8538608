#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "reports/stress/family.h"
#include "reports/stress/measure.h"

namespace wedgesim::reports::stress {

struct RunOptions {
  std::vector<std::string> families;  // names; empty: all
  std::uint64_t seeds = kVariants;    // 0 ... seeds - 1
};

/// One family's measurements.
struct FamilyResult {
  const Family* family = nullptr;
  /// [level][seed]; of families without seeds one each. Only the first failure of each arithmetic
  /// keeps its pictures.
  std::vector<std::vector<Measurement>> levels;

  /// Of the levels up to here each is right, or refused where that is an answer.
  /// \return how many levels from the first
  std::size_t levels_held(Arithmetic arithmetic) const;
  /// The hardest level up to which the bar holds, not one beyond which none has a pixel in a
  /// penumbra that could be wrong; none: not even the first.
  std::optional<double> holds_to(Arithmetic arithmetic) const;
  /// Whether that is the last level.
  bool holds_throughout(Arithmetic arithmetic) const;
  /// Whether it holds to where it must.
  bool meets_required(Arithmetic arithmetic) const;
  /// How many levels from the first up to one of them.
  std::size_t levels_up_to(double difficulty) const;
  /// The hardest level that must hold, of an arithmetic that has one.
  std::optional<double> required(Arithmetic arithmetic) const;
  /// The seed of a level's first measurement beyond the bar.
  std::optional<std::uint64_t> first_failure(Arithmetic arithmetic, std::size_t level) const;
  /// Of the levels that must hold those without a pixel in a penumbra.
  std::vector<double> empty_levels() const;
  /// What is wrong with it: nothing if it is as it must be.
  std::vector<std::string> complaints() const;
};

using Progress = std::function<void(const Family& family, std::size_t place, std::size_t count)>;

/// Measures families at all levels and seeds, many cases at a time; the result does not depend on
/// how many.
/// \param progress  told each family before it is measured, its place from 0 and their count
/// \throws InputError naming a family that is not there
std::vector<FamilyResult> run(const RunOptions& options, const Progress& progress);

}  // namespace wedgesim::reports::stress

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// An arithmetic's LI at a pixel that is not the judge's.
struct Fault {
  std::string arithmetic;
  std::size_t pixel = 0;  // row-major
  double li = 0.0, judge = 0.0, sensitivity = 0.0;
  bool foreseen = false;  // belongs to a primitive that the arithmetic itself flags
};

/// What the renderer and the model make of one frame.
struct Probe {
  std::optional<std::string> refused;
  std::size_t wedges = 0, judged = 0;  // pixels
  double penumbra = 0.0;               // share of the pixels that are neither lit nor dark
  std::vector<Fault> faults;
  std::vector<std::string> broken;  // an invariant: no NaN, all configurations the same words
};

/// An error to be found.
struct Planted {
  std::string arithmetic;  // empty: none
  std::size_t pixel = 0;
  double li = 0.0;
};

/// Renders a case and has the model compute it, exact and fixed. Where they disagree the judge says
/// who is wrong.
/// \param judge_all  judge the other pixels, too
Probe probe(const Case& random_case, bool judge_all, const Planted& planted = {});

/// Whether there is a fault that the arithmetic itself does not foresee, or a broken invariant.
bool is_wrong(const Probe& probe);

/// One line for each of the first faults.
std::string describe(const Probe& probe);

}  // namespace wedgesim::reports::stress

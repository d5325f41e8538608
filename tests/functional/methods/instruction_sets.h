#pragma once

#include "hwy/highway.h"
#include "hwy/targets.h"

namespace wedgesim::functional {

/// Calls check(name) once for every instruction set that the program has and the CPU knows, with
/// the library's kernels limited to it.
template <typename Check>
void for_each_instruction_set(Check&& check) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    check(hwy::TargetName(target));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace wedgesim::functional

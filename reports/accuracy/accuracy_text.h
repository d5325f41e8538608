#pragma once

#include <string>

#include "reports/accuracy/measure.h"
#include "reports/accuracy/recommend.h"

namespace wedgesim::reports::accuracy {

/// A table of a scene: each choice with its errors, run times, accesses; those on the Pareto front
/// are marked. Below it what was refused and, if there is a wish, what is recommended and why.
std::string accuracy_text(const SceneResult& result, const Wish* wish);

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "reports/accuracy/measure.h"
#include "reports/claims/claim_file.h"
#include "reports/runner/results.h"

namespace wedgesim::reports::accuracy {

/// What claims need measured: by scene (a built-in one, or a view), the choices of method.
using ClaimWork = std::map<std::string, std::set<std::string>>;
ClaimWork work_of(const ClaimFile& claims);

/// Scenes as claims read them: a frame each, a point for each choice that was not refused, with the
/// metrics of claims.toml.
/// \param scenes  each named as claims name it
Results claim_results(const std::vector<SceneResult>& scenes);

}  // namespace wedgesim::reports::accuracy

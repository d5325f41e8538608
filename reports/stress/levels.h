#pragma once

#include <optional>
#include <vector>

#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// The worst of a level's seeds, counts added up; refused ones are left out. It holds if all hold.
Errors worst_of(const std::vector<Measurement>& seeds, Arithmetic arithmetic);

/// The largest condition number of a level's seeds, at least 1; may be infinite.
double condition_of(const std::vector<Measurement>& seeds);

/// The upper median of some values.
double median_of(std::vector<double> values);

/// The median over a family's cases of the time that one contribution takes, nanoseconds of one
/// thread; none for the renderer, or where no case has a contribution.
std::optional<double> nanoseconds_of(const FamilyResult& result, Arithmetic arithmetic);
/// The same of the judge, for as many contributions as double precision has there.
std::optional<double> judge_nanoseconds_of(const FamilyResult& result);

}  // namespace wedgesim::reports::stress

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {

/// The error that choices are ranked by: RMSE on receivers, which every method treats, or on all
/// surfaces where no receiver is seen.
double error_of(const Measured& measured);

/// Which choices no other one beats in both error and run time on all threads, fastest first.
/// \return indices into the scene's methods
std::vector<std::size_t> pareto_front(const std::vector<Measured>& methods);

/// What a choice costs.
using Cost = double (*)(const Measured&);
double seconds_of(const Measured& measured);  // run time on all threads
double bytes_of(const Measured& measured);    // of all its accesses
/// The same for any cost, the cheapest first, of the choices that have it: more than 0.
std::vector<std::size_t> pareto_front(const std::vector<Measured>& methods, Cost cost);

/// What is asked of a method; at least one is given.
struct Wish {
  std::optional<double> max_error;       // RMSE on receivers, units of full light
  std::optional<double> budget_seconds;  // of a frame on all threads
};

struct Recommendation {
  std::optional<std::size_t> method;  // index; none if no method meets the wish
  std::string why;                    // one sentence
};

/// The fastest method within the largest error, or the most exact one within the budget; with both,
/// the fastest within both.
Recommendation recommend(const std::vector<Measured>& methods, const Wish& wish);

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/claims/claim_file.h"
#include "reports/document.h"
#include "reports/runner/spread.h"

namespace wedgesim::reports {

enum class Verdict { reproduced, depends, not_reproduced, not_measured };
std::string_view spelling(Verdict verdict);

/// The values of one measurement over frames and configurations.
struct Measured {
  std::vector<double> values;
  Spread spread;        // of them, if there are any
  double most = 0.0;    // the largest
  double within = 0.0;  // the part of them in the paper's band, [0, 1]
};

/// What became of a claim.
struct ClaimResult {
  const Claim* claim = nullptr;
  std::vector<Measured> measured;  // as Claim::measured
  Verdict verdict = Verdict::not_measured;
  std::string because;  // what it depends on, or what is missing; empty if nothing is to be said
};

/// Holds every claim against a study's results. A claim is reproduced if its first measurement's
/// median (or largest value) is in the band; it depends if that of another convention is, or if the
/// band is met by some of the values between the 5th and the 95th percentile.
/// \param file  outlives the results
std::vector<ClaimResult> judge_claims(const ClaimFile& file, const Results& results);

/// The table of all claims.
Document claims_table(std::span<const ClaimResult> claims);
/// That table, and each claim with every way it was measured: docs/claims.md.
Document claims_page(std::span<const ClaimResult> claims, const Results& results);

}  // namespace wedgesim::reports

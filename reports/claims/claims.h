#pragma once

#include <map>
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
  std::size_t count = 0;
  Spread spread;        // if there are any
  double most = 0.0;    // the largest
  double within = 0.0;  // the part of them in the paper's band, [0, 1]
};

/// What became of a claim.
struct ClaimResult {
  const Claim* claim = nullptr;
  /// As Claim::measured: each by the kind of the frames' wedges.
  std::vector<std::map<std::string, Measured>> measured;
  Verdict verdict = Verdict::not_measured;
  std::string because;  // what it depends on, or what is missing; empty if nothing is to be said

  /// The claim as it is written, on the paper's wedges.
  Measured literal() const;
};

/// Holds every claim against a study's results. A claim is reproduced if its literal median (or
/// largest value) is in the band. It depends if that of another convention, or of the other kind of
/// wedges, is; if at least a quarter of the values of one is; or if the band is met by some literal
/// values between the 5th and the 95th percentile.
/// \param file  outlives the results
std::vector<ClaimResult> judge_claims(const ClaimFile& file, const Results& results);

/// "30 to 60 %": what the paper says.
std::string band_text(const Claim& claim);
/// "9.0 (4.6 to 22.5)": median, or the largest value where the paper says up to, and percentiles.
std::string value_text(const Claim& claim, const Measured& measured);

/// The table of all claims.
Document claims_table(std::span<const ClaimResult> claims);
/// That table, and each claim with every way it was measured: docs/claims.md.
Document claims_page(std::span<const ClaimResult> claims, const Results& results);

}  // namespace wedgesim::reports

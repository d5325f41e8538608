#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports {

/// A sum of metrics, each with a factor: "z_reads + 2 tile_visits".
struct Sum {
  struct Term {
    double factor = 1.0;
    std::string metric;
  };
  std::vector<Term> terms;

  /// Nothing if the point lacks one of the metrics.
  std::optional<double> of(const PointRow& point) const;
};

/// What is computed of two points, `from` and `to`, of one frame.
enum class ClaimKind { saved, more, ratio, share, value, best };

/// One way to take a claim at its word; reports/claims.toml says what each means.
struct Measurement {
  std::string definition;
  ClaimKind kind = ClaimKind::saved;
  std::string measure;                              // "count", "cycles" or "accuracy"
  Sum metric, of;                                   // of `to`, of `from`
  std::string over;                                 // best: the key whose value is looked for
  std::map<std::string, std::vector<Value>> where;  // keys with all that they take
  Values from, to;                                  // keys that differ from the defaults
};

/// What a paper claims.
struct Claim {
  std::string id, paper, section, says, unit;
  double low = 0.0, high = 0.0;  // the paper's band
  bool most = false;             // the largest value counts, not the median
  std::string wedges;       // the kind that the paper has: "linear" or "coverage"; of methods, none
  bool of_methods = false;  // measured by `accuracy`, not by a study
  std::vector<std::string> scenes;    // empty: all
  std::string needs;                  // why it cannot be measured yet; else empty
  std::string likely;                 // why it does not hold here, if it does not; or empty
  std::vector<Measurement> measured;  // the literal one first
};

struct ClaimFile {
  Values defaults;
  std::vector<Claim> claims;
};

/// \param file  the name that errors give
/// \throws InputError at FILE:LINE
ClaimFile parse_claims(std::string_view text, const std::string& file);

/// reports/claims.toml, compiled in: the claims that studies measure, and those that `accuracy`
/// does.
const ClaimFile& study_claims();
const ClaimFile& method_claims();
struct BuiltInClaims {
  std::string_view name, text;
};
std::span<const BuiltInClaims> built_in_claim_files();

}  // namespace wedgesim::reports

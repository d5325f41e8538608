#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "reports/cycles.h"
#include "reports/runner/configuration.h"
#include "traces/reader.h"

namespace wedgesim::reports {

/// Measures points on one trace, which it keeps mapped; on one thread. What several points have in
/// common is done once: a count's walk, a block's values.
class Measurer {
 public:
  /// \throws InputError if the file is not a sound trace
  explicit Measurer(const std::filesystem::path& trace) : trace_(trace) {}

  /// The metrics of each configuration: of one if it is `cycles`, else of several that have the
  /// same common_part.
  /// \throws InputError if a configuration is wrong for this trace, std::runtime_error if the block
  ///         blocks itself
  std::vector<Values> measure(const std::vector<const Configuration*>& configurations);

 private:
  std::vector<Values> count(const std::vector<const Configuration*>& configurations) const;
  Values run_block(const Configuration& configuration);

  traces::TraceFile trace_;
  std::optional<CheckedFrame> frame_;  // of the block last run
  std::optional<model::datapath::Formats> formats_;
};

/// What of a configuration is done once for all that have the same: the walk (count), or a block's
/// values (cycles).
std::vector<int> common_part(const Configuration& configuration);

}  // namespace wedgesim::reports

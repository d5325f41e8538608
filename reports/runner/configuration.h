#pragma once

#include <string>
#include <vector>

#include "model/block/config.h"
#include "model/count/operands.h"
#include "reports/runner/axes.h"

namespace wedgesim::reports {

/// How a point is measured: accesses counted, or the block run in time.
enum class Measure { count, cycles };
std::string_view spelling(Measure measure);
/// \throws InputError at `place`
Measure parse_measure(const std::string& place, std::string_view text);

/// What is measured: a block, and for `count` its datapath.
struct Configuration {
  Measure measure = Measure::count;
  model::BlockConfig block;
  model::DatapathKind datapath = model::DatapathKind::exact;
  Values values;  // all of it that has an effect on the measure, by dotted keys

  model::Datapath count_datapath() const;
  std::string measure_name() const { return std::string(spelling(measure)); }
};

/// The configuration of some settings, of which the last of a key holds: those of a block's
/// configuration file (model/block/config.h), `preset` and, for count, `datapath`.
/// \param file  the study's, which errors name with the setting's line
/// \throws InputError for a key that is unknown, out of range, or, beyond the first `shared`
///         settings, without effect on the measure
Configuration make_configuration(const std::string& file, Measure measure, const Settings& settings,
                                 std::size_t shared);

/// The hash of all that a point's result depends on besides the program.
/// \param checksum  of the trace
std::string point_key(const Configuration& configuration, std::uint64_t checksum);

/// The keys whose values differ, in the order of `order`, which holds all of interest.
std::vector<std::string> differing_keys(const std::vector<Configuration>& configurations,
                                        const std::vector<std::string>& order);

}  // namespace wedgesim::reports

#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/count/count.h"
#include "model/count/wedge_check.h"
#include "traces/trace.h"

namespace wedgesim::reports {

/// Keys stay in the order in which they are set.
using Json = nlohmann::ordered_json;

/// What results say of the trace they come from.
struct TraceInfo {
  std::string name;
  std::uint64_t checksum = 0;
  std::uint32_t width = 0, height = 0;
  std::size_t wedges = 0;
};
TraceInfo info_of(const traces::TraceView& trace);

/// Every width by its key.
Json to_json(model::datapath::Formats formats);
Json to_json(const TraceInfo& trace);
/// One element of "configs". Nothing in it varies between identical runs but "timing".
Json to_json(const model::CountResult& result, const model::Datapath& datapath);
/// The effective "configuration" of a set: each option's values, in the order of their first use.
Json to_json(const std::vector<model::CountConfig>& configs, const model::Datapath& datapath);

/// The result of `count`, schema wedgesim.count/1.
/// \param flagged  model::flag_wedges of the trace
Json count_json(const TraceInfo& trace, const std::vector<model::CountResult>& results,
                const model::Datapath& datapath, std::span<const model::WedgeFlag> flagged);

/// Writes a file, whole or not at all.
void write_json(const std::filesystem::path& path, const Json& json);

}  // namespace wedgesim::reports

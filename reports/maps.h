#pragma once

#include <filesystem>
#include <string>

#include "model/count/count.h"
#include "traces/trace.h"

namespace wedgesim::reports {

/// What the brightest colour of each map stands for.
struct MapScales {
  float z_reads = 0.0F;     // accesses of a pixel
  float li_writes = 0.0F;   // accesses of a pixel
  float difference = 0.0F;  // |LI - expected LI|, units of full light
};
std::string to_text(const MapScales& scales);

/// LI of the finished frame, 1 = fully lit, not clamped.
/// \param result  counted with maps
/// \return (height, width)
std::vector<float> light_of(const model::CountResult& result, const model::Datapath& datapath);

/// Writes PREFIX_z_reads, PREFIX_li_writes, PREFIX_li and, if the trace holds an expected LI,
/// PREFIX_difference, each as .png and .exr.
/// \param result  counted with maps
/// \throws InputError if a file cannot be written
MapScales write_maps(const std::string& prefix, const traces::TraceView& trace,
                     const model::CountResult& result, const model::Datapath& datapath);

}  // namespace wedgesim::reports

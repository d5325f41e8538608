#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "traces/trace.h"

namespace wedgesim::model::datapath {

/// A trace of one `coverage` wedge whose forms are constants: from any pixel the point is where it
/// is put, in light coordinates (the square [-1, 1]^2 or the unit sphere at the origin).
struct OnePoint {
  traces::Trace trace;
  traces::fb::Wedge wedge;

  OnePoint(traces::fb::LightShape shape, const glm::dvec3& point, double w, const glm::dvec3& begin,
           const glm::dvec3& end) {
    std::array<double, 16> columns{};
    columns[12] = w * point.x;
    columns[13] = w * point.y;
    columns[14] = w * point.z;
    columns[15] = w;
    trace.header.lights.resize(1);
    trace.header.lights[0].shape = shape;
    trace.header.lights[0].light_from_window =
        traces::fb::Matrix4(flatbuffers::span<const double, 16>(columns));
    wedge.mutate_kind(traces::fb::WedgeKind_coverage);
    wedge.mutable_edge_begin() = {begin.x, begin.y, begin.z};
    wedge.mutable_edge_end() = {end.x, end.y, end.z};
  }
};

}  // namespace wedgesim::model::datapath

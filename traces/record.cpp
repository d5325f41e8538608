#include "traces/record.h"

#include <algorithm>
#include <span>
#include <vector>

#include "base/check.h"

namespace wedgesim::traces {
namespace {

// Adds a polygon's vertices to `vertices`; returns the bytes of its indices.
template <typename Polygon>
std::uint64_t gather(const TraceView& trace, const Polygon& polygon,
                     std::vector<std::uint32_t>& vertices) {
  const auto indices = trace.indices.subspan(polygon.first_index(), polygon.index_count());
  vertices.insert(vertices.end(), indices.begin(), indices.end());
  return sizeof(std::uint32_t) * indices.size();
}

}  // namespace

std::uint64_t wedge_record_bytes(const TraceView& trace, std::uint32_t wedge) {
  CHECK_LT(wedge, trace.wedges.size());
  const fb::Wedge& record = trace.wedges[wedge];
  std::vector<std::uint32_t> vertices;
  std::uint64_t bytes = sizeof(fb::Wedge) + record.plane_count() * sizeof(fb::Plane);
  for (const fb::Face& face : trace.faces.subspan(record.first_face(), record.face_count())) {
    bytes += sizeof(fb::Face) + gather(trace, face, vertices);
  }
  if (record.umbra() != kNone) {
    const fb::UmbraPolygon& umbra = trace.umbra_polygons[record.umbra()];
    bytes += sizeof(fb::UmbraPolygon) + gather(trace, umbra, vertices);
  }
  std::sort(vertices.begin(), vertices.end());
  const auto distinct = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  return bytes + kVertexRecordBytes * static_cast<std::uint64_t>(distinct);
}

}  // namespace wedgesim::traces

#include "reports/stress/frame_parts.h"

#include <set>

namespace wedgesim::reports::stress {
namespace {

namespace fb = traces::fb;

fb::Wedge with_umbra(const fb::Wedge& w, std::uint32_t umbra) {
  std::array<std::uint32_t, 8> planes{};
  std::array<double, 6> factors{};
  for (std::uint16_t i = 0; i < planes.size(); ++i) planes[i] = (*w.planes())[i];
  for (std::uint16_t i = 0; i < factors.size(); ++i) factors[i] = (*w.linear_factors())[i];
  return {flatbuffers::span<const std::uint32_t, 8>(planes),
          w.plane_count(),
          w.kind(),
          w.first_face(),
          w.face_count(),
          umbra,
          w.umbra_plane(),
          w.light(),
          w.caster(),
          w.z_min(),
          w.z_max(),
          w.edge_begin(),
          w.edge_end(),
          flatbuffers::span<const double, 6>(factors)};
}

}  // namespace

std::vector<Part> parts_of(const functional::Frame& frame) {
  std::vector<Part> parts;
  std::set<std::uint32_t> taken;  // polygons
  const auto polygon = [&taken](std::uint32_t umbra) -> std::optional<std::uint32_t> {
    if (umbra == traces::kNone) return {};
    taken.insert(umbra);
    return umbra;
  };
  for (std::uint32_t w = 0; w < frame.trace.wedges.size(); ++w) {
    parts.push_back({w, {}, polygon(frame.trace.wedges[w].umbra())});
  }
  for (std::uint32_t b = 0; b < frame.geometry.bare_edges.size(); ++b) {
    parts.push_back({{}, b, polygon(frame.geometry.bare_edges[b].umbra)});
  }
  for (std::uint32_t i = 0; i < frame.trace.umbra_polygons.size(); ++i) {
    if (!taken.contains(i)) parts.push_back({{}, {}, i});
  }
  return parts;
}

PartFrame::PartFrame(const functional::Frame& whole) : whole_(whole), frame_(whole) {}

void PartFrame::add_polygon(std::uint32_t polygon, std::uint32_t wedge) {
  const fb::UmbraPolygon& p = whole_.trace.umbra_polygons[polygon];
  frame_.trace.umbra_polygons.emplace_back(p.first_index(), p.index_count(), p.plane(), wedge,
                                           p.caster(), p.role(), p.z_min(), p.z_max());
  frame_.geometry.umbra_planes.push_back(whole_.geometry.umbra_planes[polygon]);
  frame_.geometry.umbra_sources.push_back(whole_.geometry.umbra_sources[polygon]);
}

const functional::Frame& PartFrame::only(const Part& part) {
  frame_.trace.wedges.clear();
  frame_.trace.umbra_polygons.clear();
  frame_.geometry.wedges.clear();
  frame_.geometry.umbra_planes.clear();
  frame_.geometry.umbra_sources.clear();
  frame_.geometry.bare_edges.clear();
  if (part.polygon) add_polygon(*part.polygon, part.wedge ? 0U : traces::kNone);
  const std::uint32_t umbra = part.polygon ? 0U : traces::kNone;
  if (part.wedge) {
    frame_.trace.wedges.push_back(with_umbra(whole_.trace.wedges[*part.wedge], umbra));
    frame_.geometry.wedges.push_back(whole_.geometry.wedges[*part.wedge]);
  }
  if (part.bare) {
    frame_.geometry.bare_edges.push_back(whole_.geometry.bare_edges[*part.bare]);
    frame_.geometry.bare_edges.back().umbra = umbra;
  }
  return frame_;
}

}  // namespace wedgesim::reports::stress

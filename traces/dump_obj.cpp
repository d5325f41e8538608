#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "traces/dump.h"

namespace wedgesim::traces {
namespace {

/// The world position of a screen vertex, or nothing where the matrix gives none.
std::optional<std::array<double, 3>> world_position(const fb::Matrix4& world_from_window,
                                                    const fb::ScreenVertex& vertex) {
  const std::array<double, 4> window = {vertex.x() / 256.0, vertex.y() / 256.0, vertex.z(), 1.0};
  std::array<double, 4> world{};
  for (std::uint16_t column = 0; column < 4; ++column) {
    for (std::uint16_t row = 0; row < 4; ++row) {
      const auto element = static_cast<std::uint16_t>(4 * column + row);
      world[row] += (*world_from_window.columns())[element] * window[column];
    }
  }
  if (!(world[3] > 0.0)) return std::nullopt;
  const std::array<double, 3> position = {world[0] / world[3], world[1] / world[3],
                                          world[2] / world[3]};
  const bool finite = std::all_of(position.begin(), position.end(),
                                  [](double value) { return std::isfinite(value); });
  return finite ? std::optional(position) : std::nullopt;
}

/// Writes all vertices, so that the mesh's numbers are the trace's plus one.
/// \return  which of them have a place in the world
std::vector<bool> put_vertices(std::ostream& out, const TraceView& trace) {
  std::vector<bool> placed;
  placed.reserve(trace.vertices.size());
  for (const fb::ScreenVertex& vertex : trace.vertices) {
    const auto position = world_position(trace.header.camera.world_from_window, vertex);
    placed.push_back(position.has_value());
    const auto [x, y, z] = position.value_or(std::array<double, 3>{});
    fmt::print(out, "v {} {} {}\n", x, y, z);
  }
  return placed;
}

void put_face(std::ostream& out, std::span<const std::uint32_t> indices) {
  out << 'f';
  for (const std::uint32_t index : indices) fmt::print(out, " {}", std::uint64_t{index} + 1);
  out << '\n';
}

}  // namespace

void dump_obj(std::ostream& out, const TraceView& trace) {
  fmt::print(out, "# {} wedges in world space\n", trace.wedges.size());
  const std::vector<bool> placed = put_vertices(out, trace);
  for (std::size_t i = 0; i < trace.wedges.size(); ++i) {
    const fb::Wedge& wedge = trace.wedges[i];
    fmt::print(out, "g wedge_{}\n", i);
    for (const fb::Face& face : trace.faces.subspan(wedge.first_face(), wedge.face_count())) {
      const auto indices = trace.indices.subspan(face.first_index(), face.index_count());
      if (std::all_of(indices.begin(), indices.end(),
                      [&](std::uint32_t index) { return placed[index]; })) {
        put_face(out, indices);
      } else {
        out << "# a face left out: a vertex of it has no place in the world\n";
      }
    }
  }
}

}  // namespace wedgesim::traces

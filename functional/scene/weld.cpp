#include "functional/scene/weld.h"

#include <bit>
#include <unordered_map>

namespace wedgesim::functional {
namespace {

struct PositionHash {
  std::size_t operator()(const glm::dvec3& p) const {
    std::uint64_t hash = 0;
    for (const double coordinate : {p.x, p.y, p.z}) {
      // Adding 0.0 turns -0.0 into 0.0, which compares equal and must hash equal.
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29U;
    }
    return hash;
  }
};

}  // namespace

Mesh welded(const Mesh& mesh) {
  Mesh out;
  out.name = mesh.name;
  out.triangles = mesh.triangles;
  std::unordered_map<glm::dvec3, std::uint32_t, PositionHash> index_of;
  index_of.reserve(mesh.positions.size());
  for (auto& triangle : out.triangles) {
    for (std::uint32_t& index : triangle) {
      const glm::dvec3& position = mesh.positions[index];
      const auto [found, is_new] =
          index_of.try_emplace(position, static_cast<std::uint32_t>(out.positions.size()));
      if (is_new) {
        out.positions.push_back(position);
      }
      index = found->second;
    }
  }
  return out;
}

}  // namespace wedgesim::functional

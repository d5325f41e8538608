#include "functional/scene/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "functional/scene/fill_holes.h"
#include "functional/scene/orient.h"
#include "functional/scene/transform.h"
#include "functional/scene/weld.h"

namespace wedgesim::functional {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct Notes {
  std::vector<std::string>& lines;
  const std::string& mesh;

  void add(std::size_t count, const std::string& what) {
    if (count > 0) {
      lines.push_back(fmt::format("repair of '{}': {}", mesh, what));
    }
  }
};

/// Vertices by cells as large as the reach, so that near ones are in neighbouring cells.
class VertexGrid {
 public:
  explicit VertexGrid(double reach) : reach_(reach) {}

  /// The earliest vertex within reach, or null.
  const std::uint32_t* near(const std::vector<glm::dvec3>& positions, glm::dvec3 p) const {
    const std::uint32_t* best = nullptr;
    const Cell middle = cell_of(p);
    for (std::int64_t i = 0; i < 27; ++i) {
      const auto [x, y, z] = middle;
      const auto found = cells_.find({x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1});
      if (found == cells_.end()) {
        continue;
      }
      for (const std::uint32_t& vertex : found->second) {
        if (glm::distance(positions[vertex], p) <= reach_ && (!best || vertex < *best)) {
          best = &vertex;
        }
      }
    }
    return best;
  }

  void add(glm::dvec3 p, std::uint32_t vertex) { cells_[cell_of(p)].push_back(vertex); }

 private:
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

  Cell cell_of(glm::dvec3 p) const {
    return {std::llround(p.x / reach_), std::llround(p.y / reach_), std::llround(p.z / reach_)};
  }

  double reach_;
  std::map<Cell, std::vector<std::uint32_t>> cells_;
};

/// Moves each vertex to the first one within reach of it.
std::size_t weld_near(Mesh& mesh, double reach) {
  if (!(reach > 0.0)) {
    return 0;
  }
  std::size_t count = 0;
  VertexGrid grid(reach);
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    if (const std::uint32_t* first = grid.near(mesh.positions, mesh.positions[i])) {
      mesh.positions[i] = mesh.positions[*first];
      ++count;
    } else {
      grid.add(mesh.positions[i], i);
    }
  }
  mesh = welded(mesh);
  return count;
}

std::size_t drop_degenerate(Mesh& mesh) {
  return std::erase_if(mesh.triangles, [](const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  });
}

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

/// Rotated so that equal triangles of equal orientation are equal arrays.
Triangle rotated(Triangle t) {
  std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  return t;
}

/// Drops later triangles on the vertices of an earlier one, unless the two are the opposite sides
/// of a sheet: then neither has another neighbour.
std::size_t drop_duplicates(Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  std::set<Triangle> seen;
  const auto edge = [](const Triangle& t, std::size_t k) {
    return std::minmax({t[k], t[(k + 1) % 3]});
  };
  const auto count = std::erase_if(mesh.triangles, [&](const Triangle& t) {
    if (!seen.insert(rotated(t)).second) {
      return true;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[edge(t, k)];
    }
    return false;
  });
  std::set<Triangle> kept;
  return count + std::erase_if(mesh.triangles, [&](const Triangle& t) {
           const bool crowded =
               uses[edge(t, 0)] > 2 || uses[edge(t, 1)] > 2 || uses[edge(t, 2)] > 2;
           return !kept.insert(sorted(t)).second && crowded;
         });
}

}  // namespace

Mesh repaired(const Mesh& original, std::vector<std::string>& lines, const RepairLimits& limits) {
  Mesh mesh = welded(original);
  Notes notes{lines, original.name};
  const auto [low, high] = bounds_of(mesh);
  const double diagonal = glm::distance(low, high);

  const std::size_t moved = weld_near(mesh, limits.weld * diagonal);
  notes.add(moved,
            fmt::format("welded {} vertices to others within {:g}", moved, limits.weld * diagonal));
  const std::size_t degenerate = drop_degenerate(mesh);
  notes.add(degenerate, fmt::format("dropped {} degenerate triangles", degenerate));
  const std::size_t duplicate = drop_duplicates(mesh);
  notes.add(duplicate, fmt::format("dropped {} duplicate triangles", duplicate));
  const std::size_t turned = orient_alike(mesh);
  notes.add(turned, fmt::format("turned {} triangles the way their neighbours run", turned));
  const FilledHoles filled = fill_planar_holes(mesh, limits.planar * diagonal);
  notes.add(filled.holes, fmt::format("closed {} planar holes with {} triangles", filled.holes,
                                      filled.triangles));
  const std::size_t outward = orient_outwards(mesh);
  notes.add(outward, fmt::format("turned {} components outwards", outward));
  return mesh;
}

}  // namespace wedgesim::functional

#include "functional/scene/orient.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "functional/scene/manifold.h"

namespace wedgesim::functional {
namespace {

struct Neighbour {
  std::uint32_t triangle;
  bool agrees;  // runs along the common edge in the opposite direction
};

using Neighbours = std::vector<std::vector<Neighbour>>;

Neighbours neighbours_of(const Mesh& mesh) {
  struct Use {
    std::uint32_t triangle;
    bool forward;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Use>> edges;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      edges[std::minmax({from, to})].push_back({i, from < to});
    }
  }
  Neighbours neighbours(mesh.triangles.size());
  for (const auto& [edge, uses] : edges) {
    if (uses.size() == 2) {
      const bool agrees = uses[0].forward != uses[1].forward;
      neighbours[uses[0].triangle].push_back({uses[1].triangle, agrees});
      neighbours[uses[1].triangle].push_back({uses[0].triangle, agrees});
    }
  }
  return neighbours;
}

/// A component's triangles, each with whether it runs against the first one.
using Component = std::vector<std::pair<std::uint32_t, bool>>;

std::vector<Component> components_of(const Mesh& mesh) {
  const Neighbours neighbours = neighbours_of(mesh);
  std::vector<bool> reached(mesh.triangles.size(), false);
  std::vector<Component> components;
  for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
    if (reached[seed]) {
      continue;
    }
    Component& component = components.emplace_back(Component{{seed, false}});
    reached[seed] = true;
    for (std::size_t next = 0; next < component.size(); ++next) {
      const auto [triangle, against] = component[next];
      for (const Neighbour& neighbour : neighbours[triangle]) {
        if (!reached[neighbour.triangle]) {
          reached[neighbour.triangle] = true;
          component.emplace_back(neighbour.triangle, against == neighbour.agrees);
        }
      }
    }
  }
  return components;
}

void turn(Mesh& mesh, std::uint32_t triangle) {
  std::swap(mesh.triangles[triangle][1], mesh.triangles[triangle][2]);
}

}  // namespace

std::size_t orient_alike(Mesh& mesh) {
  std::size_t turned = 0;
  for (const Component& component : components_of(mesh)) {
    const auto against = static_cast<std::size_t>(
        std::ranges::count_if(component, [](const auto& member) { return member.second; }));
    const bool turn_those = 2 * against <= component.size();
    for (const auto& [triangle, is_against] : component) {
      if (is_against == turn_those) {
        turn(mesh, triangle);
        ++turned;
      }
    }
  }
  return turned;
}

std::size_t orient_outwards(Mesh& mesh) {
  std::size_t turned = 0;
  for (const Component& component : components_of(mesh)) {
    Mesh part;
    part.positions = mesh.positions;
    for (const auto& [triangle, against] : component) {
      part.triangles.push_back(mesh.triangles[triangle]);
    }
    if (signed_volume(part) < 0.0) {
      for (const auto& [triangle, against] : component) {
        turn(mesh, triangle);
      }
      ++turned;
    }
  }
  return turned;
}

}  // namespace wedgesim::functional

#include "functional/geometry/polyhedron.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

namespace wedgesim::functional {
namespace {

struct Facet {
  glm::dvec4 plane;
  std::vector<std::uint32_t> corners;  // counter-clockwise seen from outside
};

// A convex polyhedron whose facets share their vertices, so that it stays closed while it is cut.
class Solid {
 public:
  explicit Solid(const Bounds& box) {
    for (int i = 0; i < 8; ++i) {
      vertices_.emplace_back((i & 1) != 0 ? box.high.x : box.low.x,
                             (i & 2) != 0 ? box.high.y : box.low.y,
                             (i & 4) != 0 ? box.high.z : box.low.z);
    }
    facets_ = {{{1, 0, 0, -box.low.x}, {0, 4, 6, 2}}, {{-1, 0, 0, box.high.x}, {1, 3, 7, 5}},
               {{0, 1, 0, -box.low.y}, {0, 1, 5, 4}}, {{0, -1, 0, box.high.y}, {2, 6, 7, 3}},
               {{0, 0, 1, -box.low.z}, {0, 2, 3, 1}}, {{0, 0, -1, box.high.z}, {4, 5, 7, 6}}};
  }

  // Keeps what is inside a plane.
  void cut(const glm::dvec4& plane) {
    distance_.clear();
    for (const glm::dvec3& p : vertices_) {
      distance_.push_back(glm::dot(glm::dvec3(plane), p) + plane.w);
    }
    const auto any = [&](auto holds) {
      return std::any_of(facets_.begin(), facets_.end(), [&](const Facet& facet) {
        return std::any_of(facet.corners.begin(), facet.corners.end(),
                           [&](std::uint32_t v) { return holds(distance_[v]); });
      });
    };
    if (!any([](double d) { return d < 0.0; })) return;
    std::vector<Facet> kept;
    if (any([](double d) { return d > 0.0; })) {
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings;
      for (const Facet& facet : facets_) {
        std::vector<std::uint32_t> corners = clipped(facet.corners, crossings);
        if (!corners.empty()) kept.push_back({facet.plane, std::move(corners)});
      }
      std::vector<std::uint32_t> lid = open_outline(kept);
      if (lid.size() >= 3) kept.push_back({plane, std::move(lid)});
    }
    facets_ = std::move(kept);
  }

  const std::vector<glm::dvec3>& vertices() const { return vertices_; }
  const std::vector<Facet>& facets() const { return facets_; }

 private:
  // The corners of a facet inside the plane, none if it has only points on it. The vertex where an
  // edge crosses the plane is made once, for both facets.
  std::vector<std::uint32_t> clipped(
      const std::vector<std::uint32_t>& corners,
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& crossings) {
    std::vector<std::uint32_t> kept;
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t a = corners[i];
      const std::uint32_t b = corners[(i + 1) % corners.size()];
      const double da = distance_[a];
      const double db = distance_[b];
      inside |= da > 0.0;
      if (da >= 0.0) kept.push_back(a);
      if (!((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0))) continue;
      const auto [crossing, added] =
          crossings.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices_.size()));
      if (added)
        vertices_.push_back(vertices_[a] + (da / (da - db)) * (vertices_[b] - vertices_[a]));
      kept.push_back(crossing->second);
    }
    if (!inside) kept.clear();
    return kept;
  }

  // The outline of the hole that facets leave open, the way round that closes it.
  static std::vector<std::uint32_t> open_outline(const std::vector<Facet>& facets) {
    std::map<std::uint32_t, std::vector<std::uint32_t>> following;
    for (const Facet& facet : facets) {
      for (std::size_t i = 0; i < facet.corners.size(); ++i) {
        const std::uint32_t a = facet.corners[i];
        const std::uint32_t b = facet.corners[(i + 1) % facet.corners.size()];
        std::vector<std::uint32_t>& from_a = following[a];
        const auto opposite = std::find(from_a.begin(), from_a.end(), b);
        if (opposite != from_a.end()) {
          from_a.erase(opposite);
        } else {
          following[b].push_back(a);
        }
      }
    }
    std::vector<std::uint32_t> outline;
    for (const auto& [first, next] : following) {
      if (next.empty()) continue;
      for (std::uint32_t v = first; !following[v].empty();) {
        outline.push_back(v);
        v = std::exchange(following[v], {}).front();
      }
      break;
    }
    return outline;
  }

  std::vector<glm::dvec3> vertices_;
  std::vector<Facet> facets_;
  std::vector<double> distance_;  // of each vertex from the plane that cuts
};

}  // namespace

WorldWedge intersect_half_spaces(std::span<const glm::dvec4> planes, const Bounds& box) {
  Solid solid(box);
  for (const glm::dvec4& plane : planes) solid.cut(plane);
  WorldWedge result;
  result.planes.assign(planes.begin(), planes.end());
  std::map<std::uint32_t, std::uint32_t> used;
  for (const Facet& facet : solid.facets()) {
    WedgeFace face;
    const auto known = std::find(result.planes.begin(), result.planes.end(), facet.plane);
    face.plane = static_cast<std::uint32_t>(known - result.planes.begin());
    if (known == result.planes.end()) result.planes.push_back(facet.plane);
    for (const std::uint32_t v : facet.corners) {
      const auto [at, added] =
          used.try_emplace(v, static_cast<std::uint32_t>(result.vertices.size()));
      if (added) result.vertices.push_back(solid.vertices()[v]);
      face.corners.push_back(at->second);
    }
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace wedgesim::functional

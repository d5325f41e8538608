#include "functional/geometry/polyhedron.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

namespace wedgesim::functional {
namespace {

// Twice the digits of a double, at two to three times the time.
__extension__ using Quad = __float128;

// How far vertices are moved by rounding, in parts of the way to the box's farthest corner.
template <typename Real>
constexpr double kRounding = 0x1p-48;
template <>
constexpr double kRounding<Quad> = 0x1p-108;

double reach_of(const Bounds& box) {
  const glm::dvec3 farthest = glm::max(glm::abs(box.low), glm::abs(box.high));
  return std::max({farthest.x, farthest.y, farthest.z});
}

struct Facet {
  glm::dvec4 plane;
  std::vector<std::uint32_t> corners;  // counter-clockwise seen from outside
};

// A convex polyhedron whose facets share their vertices, so that it stays closed while it is cut.
template <typename Real>
class Solid {
 public:
  explicit Solid(const Bounds& box) : rounding_(kRounding<Real> * reach_of(box)) {
    for (int i = 0; i < 8; ++i) {
      vertices_.push_back({(i & 1) != 0 ? box.high.x : box.low.x,
                           (i & 2) != 0 ? box.high.y : box.low.y,
                           (i & 4) != 0 ? box.high.z : box.low.z});
    }
    facets_ = {{{1, 0, 0, -box.low.x}, {0, 4, 6, 2}}, {{-1, 0, 0, box.high.x}, {1, 3, 7, 5}},
               {{0, 1, 0, -box.low.y}, {0, 1, 5, 4}}, {{0, -1, 0, box.high.y}, {2, 6, 7, 3}},
               {{0, 0, 1, -box.low.z}, {0, 2, 3, 1}}, {{0, 0, -1, box.high.z}, {4, 5, 7, 6}}};
  }

  // Keeps what is inside a plane. What is on it but for rounding is on it: a plane given twice
  // would cut the first cut's corners at random.
  void cut(const glm::dvec4& plane) {
    places_.assign(vertices_.size(), {});
    bool some_inside = false, some_outside = false;
    for (const Facet& facet : facets_) {
      for (const std::uint32_t v : facet.corners) {
        if (places_[v].known) continue;
        const Point& p = vertices_[v];
        const Real distance = plane.x * p[0] + plane.y * p[1] + plane.z * p[2] + plane.w;
        places_[v] = {true, distance > rounding_ ? 1 : (distance < -rounding_ ? -1 : 0), distance};
        some_inside |= places_[v].side > 0;
        some_outside |= places_[v].side < 0;
        is_sure_ &= places_[v].side != 0;
      }
    }
    if (!some_outside) return;
    std::vector<Facet> kept;
    if (some_inside) {
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

  glm::dvec3 vertex(std::uint32_t i) const {
    const Point& p = vertices_[i];
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
  const std::vector<Facet>& facets() const { return facets_; }
  // Whether no vertex was on a plane that cut, but for rounding: then the facets close.
  bool is_sure() const { return is_sure_; }

 private:
  using Point = std::array<Real, 3>;
  struct Place {
    bool known = false;
    int side = 0;  // the sign of the distance; 0 on the plane
    Real distance = 0;
  };

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
      const Place& of_a = places_[a];
      const Place& of_b = places_[b];
      inside |= of_a.side > 0;
      if (of_a.side >= 0) kept.push_back(a);
      if (of_a.side * of_b.side >= 0) continue;
      const auto [crossing, added] =
          crossings.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(vertices_.size()));
      if (added) {
        const Real share = of_a.distance / (of_a.distance - of_b.distance);
        vertices_.push_back(between(vertices_[a], vertices_[b], share));
      }
      kept.push_back(crossing->second);
    }
    if (!inside) kept.clear();
    return kept;
  }

  static Point between(const Point& a, const Point& b, Real share) {
    Point p;
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = a[i] + share * (b[i] - a[i]);
    return p;
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

  Real rounding_;  // of distances
  bool is_sure_ = true;
  std::vector<Point> vertices_;
  std::vector<Facet> facets_;
  std::vector<Place> places_;  // of each vertex, to the plane that cuts
};

template <typename Real>
Solid<Real> cut_box(std::span<const glm::dvec4> planes, const Bounds& box) {
  Solid<Real> solid(box);
  for (const glm::dvec4& plane : planes) solid.cut(plane);
  return solid;
}

template <typename Real>
WorldWedge volume_of(const Solid<Real>& solid, std::span<const glm::dvec4> planes) {
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
      if (added) result.vertices.push_back(solid.vertex(v));
      face.corners.push_back(at->second);
    }
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace

WorldWedge intersect_half_spaces(std::span<const glm::dvec4> planes, const Bounds& box,
                                 double accuracy) {
  if (kRounding<double> * reach_of(box) <= accuracy) {
    const Solid<double> solid = cut_box<double>(planes, box);
    if (solid.is_sure()) return volume_of(solid, planes);
  }
  return volume_of(cut_box<Quad>(planes, box), planes);
}

}  // namespace wedgesim::functional

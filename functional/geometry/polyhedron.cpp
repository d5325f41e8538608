#include "functional/geometry/polyhedron.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace wedgesim::functional {
namespace {

struct Facet {
  glm::dvec4 plane;
  std::vector<glm::dvec3> outline;  // counter-clockwise seen from outside
};

double distance(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

std::vector<Facet> box_facets(const Bounds& box) {
  const auto corner = [&](int i) {
    return glm::dvec3((i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                      (i & 4) != 0 ? box.high.z : box.low.z);
  };
  return {{{1, 0, 0, -box.low.x}, {corner(0), corner(4), corner(6), corner(2)}},
          {{-1, 0, 0, box.high.x}, {corner(1), corner(3), corner(7), corner(5)}},
          {{0, 1, 0, -box.low.y}, {corner(0), corner(1), corner(5), corner(4)}},
          {{0, -1, 0, box.high.y}, {corner(2), corner(6), corner(7), corner(3)}},
          {{0, 0, 1, -box.low.z}, {corner(0), corner(2), corner(3), corner(1)}},
          {{0, 0, -1, box.high.z}, {corner(4), corner(5), corner(7), corner(6)}}};
}

std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& outline, const glm::dvec4& plane,
                                std::vector<glm::dvec3>& cut) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec3& a = outline[i];
    const glm::dvec3& b = outline[(i + 1) % outline.size()];
    const double da = distance(plane, a);
    const double db = distance(plane, b);
    if (da >= 0.0) kept.push_back(a);
    if ((da >= 0.0) != (db >= 0.0)) {
      const glm::dvec3 p = a + (da / (da - db)) * (b - a);
      kept.push_back(p);
      cut.push_back(p);
    } else if (da == 0.0) {
      cut.push_back(a);
    }
  }
  return kept;
}

// The new face where the plane cuts the polyhedron: its corners around their middle.
std::vector<glm::dvec3> around(std::vector<glm::dvec3> points, const glm::dvec3& inward) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  const glm::dvec3 out = -glm::normalize(inward);
  const glm::dvec3 helper = std::abs(out.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(helper, out));
  const glm::dvec3 v = glm::cross(out, u);
  const auto angle = [&](const glm::dvec3& p) {
    return std::atan2(glm::dot(p - middle, v), glm::dot(p - middle, u));
  };
  std::sort(points.begin(), points.end(),
            [&](const glm::dvec3& a, const glm::dvec3& b) { return angle(a) < angle(b); });
  return points;
}

}  // namespace

WorldWedge intersect_half_spaces(std::span<const glm::dvec4> planes, const Bounds& box) {
  std::vector<Facet> facets = box_facets(box);
  for (const glm::dvec4& plane : planes) {
    std::vector<glm::dvec3> cut;
    std::vector<Facet> kept;
    for (Facet& facet : facets) {
      facet.outline = clipped(facet.outline, plane, cut);
      if (facet.outline.size() >= 3) kept.push_back(std::move(facet));
    }
    if (cut.size() >= 3 && !kept.empty()) {
      kept.push_back({plane, around(std::move(cut), glm::dvec3(plane))});
    }
    facets = std::move(kept);
  }
  WorldWedge result;
  result.planes.assign(planes.begin(), planes.end());
  for (const Facet& facet : facets) {
    WedgeFace face;
    const auto known = std::find(result.planes.begin(), result.planes.end(), facet.plane);
    face.plane = static_cast<std::uint32_t>(known - result.planes.begin());
    if (known == result.planes.end()) result.planes.push_back(facet.plane);
    for (const glm::dvec3& p : facet.outline) {
      const auto same = std::find(result.vertices.begin(), result.vertices.end(), p);
      face.corners.push_back(static_cast<std::uint32_t>(same - result.vertices.begin()));
      if (same == result.vertices.end()) result.vertices.push_back(p);
    }
    result.faces.push_back(std::move(face));
  }
  return result;
}

}  // namespace wedgesim::functional

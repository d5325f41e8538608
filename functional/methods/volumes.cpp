#include "functional/methods/volumes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "base/error.h"
#include "functional/geometry/hull.h"
#include "functional/geometry/near_pyramid.h"
#include "functional/geometry/segment.h"
#include "functional/geometry/wedge.h"
#include "functional/light/clearance.h"
#include "functional/light/coverage.h"
#include "functional/light/coverage_forms.h"
#include "functional/methods/shadow_geometry.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

constexpr std::size_t kChunk = 32;  // edges or triangles that one task takes

// Calls body(begin, end, chunk) for all chunks of n items in parallel.
template <typename Body>
void for_each_chunk(std::size_t n, std::size_t chunk, const Body& body) {
  tbb::parallel_for(std::size_t{0}, (n + chunk - 1) / chunk,
                    [&](std::size_t i) { body(i * chunk, std::min(n, (i + 1) * chunk), i); });
}

class Builder {
 public:
  Builder(const Window& window, const Light& light)
      : window_(window),
        light_(light),
        pyramid_(window),
        axes_(light_from_world(light)),
        light_from_window_(light_from_world(light) * window.world_from_window),
        soft_(has_extent(light)) {}

  std::vector<ScreenSide> volume(const ShadowCaster& caster, ZChoice z) const {
    const std::vector<SilhouetteEdge> edges = all_edges(caster.silhouette);
    std::vector<std::vector<ScreenSide>> parts((edges.size() + kChunk - 1) / kChunk);
    std::atomic<bool> meets = false;
    for_each_chunk(edges.size(), kChunk, [&](std::size_t begin, std::size_t end, std::size_t i) {
      for (; begin < end; ++begin) {
        if (add_side(caster, edges[begin], parts[i])) meets = true;
      }
    });
    const bool needed = meets || eye_in_umbra(caster);
    if (needed && z == ZChoice::pass) {
      throw InputError(caster.mesh->name,
                       "z-pass is wrong where a shadow volume meets the near pyramid",
                       "z-fail or auto");
    }
    const bool z_fail = z == ZChoice::fail || (z == ZChoice::automatic && needed);
    std::vector<ScreenSide> sides;
    for (std::vector<ScreenSide>& part : parts) {
      std::move(part.begin(), part.end(), std::back_inserter(sides));
    }
    if (z_fail) {
      add_caps(caster, sides);
      add_bottoms(caster, sides);
      for (ScreenSide& side : sides) side.umbra.z_fail = true;
    }
    return sides;
  }

 private:
  static std::vector<SilhouetteEdge> all_edges(const Silhouette& silhouette) {
    std::vector<SilhouetteEdge> edges;
    for (const auto& loop : silhouette.loops) edges.insert(edges.end(), loop.begin(), loop.end());
    return edges;
  }

  // Adds an edge's side, and umbra polygons alone if its own snapped into several. True if z-pass
  // would be wrong with them.
  bool add_side(const ShadowCaster& caster, const SilhouetteEdge& edge,
                std::vector<ScreenSide>& sides) const {
    const glm::dvec3& begin = caster.mesh->positions[edge.begin];
    const glm::dvec3& end = caster.mesh->positions[edge.end];
    const glm::dvec3 far_begin = caster.end_plane.reach(light_.centre, begin);
    const glm::dvec3 far_end = caster.end_plane.reach(light_.centre, end);
    const std::array<glm::dvec3, 4> quad{end, begin, far_begin, far_end};
    const SidedPlane plane(quad_plane(light_.centre, begin, end));
    const std::size_t first = sides.size();
    add_umbra(quad, plane, fb::UmbraRole_side, sides);
    if (soft_) {
      ScreenWedge wedge = screen_wedge(begin, end, caster.end_plane);
      if (!wedge.hull.empty()) {
        if (sides.size() == first) {
          sides.push_back(bare_side(plane));
        }
        ScreenSide& side = sides[first];
        touch_rows(wedge.hull, side);
        side.wedge = std::move(wedge);
      }
    }
    return pyramid_.meets(quad);
  }

  ScreenSide bare_side(const SidedPlane& plane) const {
    ScreenSide side;
    side.plane = window_plane(window_, plane.plane);
    side.minus = plane.minus;
    side.y_begin = window_.height;
    return side;
  }

  // The largest of the convex parts that an outline snaps into comes first.
  void add_umbra(std::span<const glm::dvec3> outline, const SidedPlane& plane, fb::UmbraRole role,
                 std::vector<ScreenSide>& sides) const {
    const std::vector<WindowPoint> points = clip_to_window(window_, outline);
    if (points.empty()) return;
    const auto [near, far] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.z < b.z; });
    const std::size_t first = sides.size();
    std::int64_t largest = 0;
    for (std::vector<SnappedPoint>& part : convex_parts(snap(points))) {
      const std::int64_t area = doubled_area(part);
      if (area == 0) continue;
      ScreenSide side = bare_side(plane);
      side.umbra.role = role;
      side.umbra.eye_facing = area < 0;
      side.umbra.z_min = near->z;
      side.umbra.z_max = far->z;
      // A bottom of a loop that is not convex may be wound against its plane, which turns with it.
      const double inward = side.minus ? -side.plane.z : side.plane.z;
      if (role == fb::UmbraRole_bottom && (area < 0 ? inward < 0.0 : inward > 0.0)) {
        side.minus = !side.minus;
      }
      const auto [low, high] = std::minmax_element(
          part.begin(), part.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
      side.y_begin = std::max(0, (low->y - 128) >> 8);
      side.y_end = std::min(window_.height, ((high->y - 128) >> 8) + 1);
      side.umbra.outline = std::move(part);
      if (std::abs(area) > largest) {
        largest = std::abs(area);
        sides.insert(sides.begin() + static_cast<std::ptrdiff_t>(first), std::move(side));
      } else {
        sides.push_back(std::move(side));
      }
    }
  }

  ScreenWedge screen_wedge(const glm::dvec3& begin, const glm::dvec3& end,
                           const EndPlane& end_plane) const {
    const WorldWedge volume = coverage_wedge(light_, begin, end, end_plane);
    ScreenWedge wedge;
    std::vector<glm::dvec2> points;
    for (const WedgeFace& face : volume.faces) {
      std::vector<glm::dvec3> corners;
      for (const std::uint32_t c : face.corners) corners.push_back(volume.vertices[c]);
      for (const WindowPoint& p : clip_to_window(window_, corners)) points.emplace_back(p);
    }
    wedge.hull = convex_hull(points);
    if (wedge.hull.empty()) return wedge;
    for (const glm::dvec4& plane : volume.planes) {
      wedge.planes.push_back(window_plane(window_, plane));
    }
    // By their distance from the light: the matrix's translation would round small lights away.
    const CoverageForms coverage =
        coverage_forms(light_.shape, light_from_window_, axes_ * (begin - light_.centre),
                       axes_ * (end - light_.centre));
    wedge.forms = coverage.forms;
    wedge.constants = coverage.constants;
    return wedge;
  }

  void touch_rows(const std::vector<glm::dvec2>& hull, ScreenSide& side) const {
    const auto [low, high] = std::minmax_element(
        hull.begin(), hull.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    side.y_begin = std::min(side.y_begin, std::max(0, static_cast<int>(std::floor(low->y)) - 1));
    side.y_end =
        std::max(side.y_end, std::min(window_.height, static_cast<int>(std::ceil(high->y)) + 1));
  }

  // The end of a volume: fans over the far corners of its loops.
  void add_bottoms(const ShadowCaster& caster, std::vector<ScreenSide>& sides) const {
    const SidedPlane plane(caster.end_plane.plane);
    for (const auto& loop : caster.silhouette.loops) {
      const auto far = [&](std::size_t i) {
        return caster.end_plane.reach(light_.centre, caster.mesh->positions[loop[i].begin]);
      };
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const std::array<glm::dvec3, 3> outline{far(0), far(i + 1), far(i)};
        add_umbra(outline, plane, fb::UmbraRole_bottom, sides);
      }
    }
  }

  // The light-facing triangles count the same at every pixel as any surface with their outline, so
  // fans over the loops serve; unless the near plane cuts them, which would cut those elsewhere.
  void add_caps(const ShadowCaster& caster, std::vector<ScreenSide>& sides) const {
    const std::vector<glm::dvec3>& p = caster.mesh->positions;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      add_umbra(std::array<glm::dvec3, 3>{p[a], p[b], p[c]}, SidedPlane(), fb::UmbraRole_cap,
                sides);
    };
    const double near = view_distance(window_, 0.0);
    const bool before_near = std::any_of(p.begin(), p.end(), [&](const glm::dvec3& q) {
      return (window_.window_from_world * glm::dvec4(q, 1.0)).w < near;
    });
    if (before_near) {
      for (std::size_t t = 0; t < caster.mesh->triangles.size(); ++t) {
        const auto& corner = caster.mesh->triangles[t];
        if (caster.silhouette.light_facing[t]) add(corner[0], corner[1], corner[2]);
      }
      return;
    }
    for (const auto& loop : caster.silhouette.loops) {
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        add(loop[0].begin, loop[i].begin, loop[i + 1].begin);
      }
    }
  }

  // The eye sees the light's centre through a light-facing triangle.
  bool eye_in_umbra(const ShadowCaster& caster) const {
    const Mesh& mesh = *caster.mesh;
    std::atomic<bool> found = false;
    for_each_chunk(mesh.triangles.size(), 4096,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (; begin < end && !found; ++begin) {
                       if (!caster.silhouette.light_facing[begin]) continue;
                       const auto& c = mesh.triangles[begin];
                       if (segment_triangle(pyramid_.eye(), light_.centre, mesh.positions[c[0]],
                                            mesh.positions[c[1]], mesh.positions[c[2]])) {
                         found = true;
                       }
                     }
                   });
    return found;
  }

  const Window& window_;
  const Light& light_;
  NearPyramid pyramid_;
  glm::dmat3 axes_;
  glm::dmat4 light_from_window_;
  bool soft_;
};

}  // namespace

std::vector<ShadowCaster> find_casters(const Scene& scene, const Light& light) {
  const Bounds bounds = bounds_of(scene.objects);
  std::vector<ShadowCaster> casters;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    try {
      check_light_is_clear(object.mesh, light);
      ShadowCaster caster;
      caster.mesh = &object.mesh;
      caster.silhouette = find_silhouette(object.mesh, light.centre);
      if (caster.silhouette.loops.empty()) continue;
      caster.end_plane =
          choose_end_plane(object.mesh, caster.silhouette, light, bounds, std::nullopt);
      casters.push_back(std::move(caster));
    } catch (const InputError& error) {
      throw InputError(scene.place, error.what());
    }
  }
  return casters;
}

std::vector<ScreenSide> build_volumes(const Scene& scene, const Window& window, const Light& light,
                                      const std::vector<ShadowCaster>& casters, ZChoice z) {
  const Builder builder(window, light);
  std::vector<ScreenSide> sides;
  for (const ShadowCaster& caster : casters) {
    try {
      std::vector<ScreenSide> volume = builder.volume(caster, z);
      std::move(volume.begin(), volume.end(), std::back_inserter(sides));
    } catch (const InputError& error) {
      throw InputError(scene.place, error.what());
    }
  }
  return sides;
}

}  // namespace wedgesim::functional

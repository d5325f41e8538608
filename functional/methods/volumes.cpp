#include "functional/methods/volumes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "base/error.h"
#include "functional/geometry/loop_groups.h"
#include "functional/geometry/loose_wedge.h"
#include "functional/geometry/segment.h"
#include "functional/geometry/wedge.h"
#include "functional/light/clearance.h"
#include "functional/light/coverage.h"
#include "functional/light/coverage_forms.h"
#include "functional/methods/screen_sides.h"

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
  Builder(const Window& window, const Light& light, const VolumeChoices& choices)
      : window_(window),
        light_(light),
        pyramid_(window),
        axes_(light_from_world(light)),
        light_from_window_(light_from_world(light) * window.world_from_window),
        soft_(has_extent(light)),
        tight_wedges_(choices.tight_wedges),
        in_halves_(choices.in_halves),
        cone_forms_(choices.cone_forms && light.shape == LightShape::sphere),
        sides_(window) {}

  /// \param groups  of each loop, as the sides get them
  std::vector<ScreenSide> volume(const ShadowCaster& caster,
                                 const std::vector<std::uint32_t>& groups, ZChoice z) const {
    const std::vector<LoopEdge> edges = all_edges(caster.silhouette, groups);
    std::vector<std::vector<ScreenSide>> parts((edges.size() + kChunk - 1) / kChunk);
    std::atomic<bool> meets = false;
    for_each_chunk(edges.size(), kChunk, [&](std::size_t begin, std::size_t end, std::size_t i) {
      for (; begin < end; ++begin) {
        const std::size_t first = parts[i].size();
        if (add_side(caster, edges[begin].edge, parts[i])) meets = true;
        set_group(parts[i], first, edges[begin].group);
      }
    });
    const bool needed = meets || ends_need_z_fail(caster, light_.centre, pyramid_);
    if (needed && z == ZChoice::pass) refuse_z_pass(caster.mesh->name);
    const bool z_fail = z == ZChoice::fail || (z == ZChoice::automatic && needed);
    std::vector<ScreenSide> sides;
    for (std::vector<ScreenSide>& part : parts) {
      std::move(part.begin(), part.end(), std::back_inserter(sides));
    }
    if (z_fail) {
      add_caps(caster, groups, sides);
      add_bottoms(caster, groups, sides);
      for (ScreenSide& side : sides) side.umbra.z_fail = true;
    }
    return sides;
  }

 private:
  struct LoopEdge {
    SilhouetteEdge edge;
    std::uint32_t group;
  };

  static std::vector<LoopEdge> all_edges(const Silhouette& silhouette,
                                         const std::vector<std::uint32_t>& groups) {
    std::vector<LoopEdge> edges;
    for (std::size_t i = 0; i < silhouette.loops.size(); ++i) {
      for (const SilhouetteEdge& edge : silhouette.loops[i]) edges.push_back({edge, groups[i]});
    }
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
    sides_.add_umbra(quad, plane, fb::UmbraRole_side, false, sides);
    if (soft_) {
      const WorldWedge volume = world_wedge(begin, end, caster.end_plane);
      ScreenWedge* wedge = sides_.add_wedge(volume, plane, first, sides);
      if (wedge != nullptr) set_forms(begin, end, *wedge);
      if (wedge != nullptr && in_halves_) sides_.split_wedge(volume, plane, *wedge);
    }
    return pyramid_.meets(quad);
  }

  WorldWedge world_wedge(const glm::dvec3& begin, const glm::dvec3& end,
                         const EndPlane& end_plane) const {
    if (!tight_wedges_) {
      if (const auto loose = loose_wedge(light_, begin, end, end_plane)) return *loose;
    }
    return coverage_wedge(light_, begin, end, end_plane);
  }

  // Its forms: what coverage is computed from.
  void set_forms(const glm::dvec3& begin, const glm::dvec3& end, ScreenWedge& wedge) const {
    // By their distance from the light: the matrix's translation would round small lights away.
    const glm::dvec3 from = axes_ * (begin - light_.centre);
    const glm::dvec3 to = axes_ * (end - light_.centre);
    const CoverageForms coverage = cone_forms_
                                       ? cone_forms(light_from_window_, from, to)
                                       : coverage_forms(light_.shape, light_from_window_, from, to);
    wedge.forms = coverage.forms;
    wedge.constants = coverage.constants;
  }

  // The end of a volume: fans over the far corners of its loops.
  void add_bottoms(const ShadowCaster& caster, const std::vector<std::uint32_t>& groups,
                   std::vector<ScreenSide>& sides) const {
    const SidedPlane plane(caster.end_plane.plane);
    for (std::size_t l = 0; l < groups.size(); ++l) {
      const auto& loop = caster.silhouette.loops[l];
      const std::size_t first = sides.size();
      const auto far = [&](std::size_t i) {
        return caster.end_plane.reach(light_.centre, caster.mesh->positions[loop[i].begin]);
      };
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const std::array<glm::dvec3, 3> outline{far(0), far(i + 1), far(i)};
        sides_.add_umbra(outline, plane, fb::UmbraRole_bottom, true, sides);
      }
      set_group(sides, first, groups[l]);
    }
  }

  // The light-facing triangles count the same at every pixel as any surface with their outline, so
  // fans over the loops serve; unless the near plane cuts them, which would cut those elsewhere.
  void add_caps(const ShadowCaster& caster, const std::vector<std::uint32_t>& groups,
                std::vector<ScreenSide>& sides) const {
    const std::vector<glm::dvec3>& p = caster.mesh->positions;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      sides_.add_umbra(std::array<glm::dvec3, 3>{p[a], p[b], p[c]}, SidedPlane(), fb::UmbraRole_cap,
                       false, sides);
    };
    const double near = view_distance(window_, 0.0);
    const bool before_near = std::any_of(p.begin(), p.end(), [&](const glm::dvec3& q) {
      return (window_.window_from_world * glm::dvec4(q, 1.0)).w < near;
    });
    if (before_near) {
      const std::size_t first = sides.size();
      for (std::size_t t = 0; t < caster.mesh->triangles.size(); ++t) {
        const auto& corner = caster.mesh->triangles[t];
        if (caster.silhouette.light_facing[t]) add(corner[0], corner[1], corner[2]);
      }
      set_group(sides, first, groups.front());
      return;
    }
    for (std::size_t l = 0; l < groups.size(); ++l) {
      const auto& loop = caster.silhouette.loops[l];
      const std::size_t first = sides.size();
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        add(loop[0].begin, loop[i].begin, loop[i + 1].begin);
      }
      set_group(sides, first, groups[l]);
    }
  }

  const Window& window_;
  const Light& light_;
  NearPyramid pyramid_;
  glm::dmat3 axes_;
  glm::dmat4 light_from_window_;
  bool soft_;
  bool tight_wedges_;
  bool in_halves_;
  bool cone_forms_;
  ScreenSides sides_;
};

}  // namespace

bool ends_need_z_fail(const ShadowCaster& caster, const glm::dvec3& light_centre,
                      const NearPyramid& pyramid) {
  // What is seen lies before the end plane, and so does all the way there from an eye before it.
  if (!caster.end_plane.is_before(pyramid.eye())) return true;
  const Mesh& mesh = *caster.mesh;
  std::atomic<bool> found = false;
  for_each_chunk(mesh.triangles.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (; begin < end && !found; ++begin) {
      if (caster.silhouette.light_facing[begin] == 0) continue;
      const auto& corner = mesh.triangles[begin];
      const std::array<glm::dvec3, 3> p{mesh.positions[corner[0]], mesh.positions[corner[1]],
                                        mesh.positions[corner[2]]};
      if (segment_triangle(pyramid.eye(), light_centre, p[0], p[1], p[2]) || pyramid.meets(p)) {
        found = true;
      }
    }
  });
  return found;
}

void refuse_z_pass(const std::string& place) {
  throw InputError(place,
                   "z-pass is wrong where a shadow volume meets the near pyramid or ends before "
                   "the eye",
                   "z-fail or auto");
}

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
                                      const std::vector<ShadowCaster>& casters,
                                      const VolumeChoices& choices) {
  const Builder builder(window, light, choices);
  std::vector<ScreenSide> sides;
  std::uint32_t group_count = 0;
  for (const ShadowCaster& caster : casters) {
    try {
      std::vector<std::uint32_t> groups(caster.silhouette.loops.size(), 0);
      if (choices.by_groups) {
        groups = loop_groups(*caster.mesh, caster.silhouette, light.centre);
        for (std::uint32_t& group : groups) group += group_count;
        group_count = *std::ranges::max_element(groups) + 1;
      }
      std::vector<ScreenSide> volume = builder.volume(caster, groups, choices.z);
      std::move(volume.begin(), volume.end(), std::back_inserter(sides));
    } catch (const InputError& error) {
      throw InputError(scene.place, error.what());
    }
  }
  if (choices.by_groups) std::ranges::stable_sort(sides, {}, &ScreenSide::group);
  return sides;
}

}  // namespace wedgesim::functional

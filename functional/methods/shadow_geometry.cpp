#include "functional/methods/shadow_geometry.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "functional/geometry/linear_wedge.h"
#include "functional/geometry/screen_builder.h"
#include "functional/geometry/silhouette.h"
#include "functional/light/clearance.h"
#include "functional/light/coverage.h"
#include "functional/methods/volumes.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

fb::Vec3 to_fb(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

class Builder {
 public:
  Builder(const Scene& scene, const Window& window, fb::WedgeKind kind,
          std::optional<double> length, const Bounds& receivers, traces::Trace& trace)
      : light_(scene.light),
        kind_(kind),
        length_(length),
        trace_(trace),
        screen_(window, trace),
        pyramid_(window),
        to_light_(light_from_world(scene.light)),
        bounds_(receivers),
        soft_(has_extent(scene.light)) {
    geometry_.kind = kind;
    geometry_.end_sides.resize(scene.objects.size());
  }

  void add_caster(const Mesh& mesh, std::uint32_t object) {
    object_ = object;
    check_light_is_clear(mesh, light_);
    caster_ = static_cast<std::uint32_t>(trace_.header.casters.size());
    trace_.header.casters.push_back(
        {mesh.name, static_cast<std::uint32_t>(mesh.triangles.size()), false});
    ShadowCaster caster{&mesh, find_silhouette(mesh, light_.centre), {}};
    const Silhouette& silhouette = caster.silhouette;
    if (silhouette.loops.empty()) return;
    caster.end_plane = choose_end_plane(mesh, silhouette, light_, bounds_, length_);
    geometry_.end_sides[object] = caster.end_plane.side;
    for (const auto& loop : silhouette.loops) {
      std::vector<glm::dvec3> corners;
      for (const SilhouetteEdge& edge : loop) corners.push_back(mesh.positions[edge.begin]);
      if (soft_ && kind_ == fb::WedgeKind_linear) {
        add_linear_loop(loop, corners, caster.end_plane);
      } else {
        add_loop(loop, corners, caster.end_plane);
      }
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!silhouette.light_facing[t]) continue;
      const auto& c = mesh.triangles[t];
      geometry_.caps.push_back({mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]});
      const auto& cap = geometry_.caps.back();
      add_umbra({cap.begin(), cap.end()}, glm::dvec4(0.0), traces::kNone, fb::UmbraRole_cap, {});
    }
    if (ends_need_z_fail(caster, light_.centre, pyramid_)) need_z_fail();
  }

  ShadowGeometry take() { return std::move(geometry_); }

 private:
  void add_loop(const std::vector<SilhouetteEdge>& loop, const std::vector<glm::dvec3>& corners,
                const EndPlane& end_plane) {
    std::vector<glm::dvec3> far;
    for (const glm::dvec3& p : corners) far.push_back(end_plane.reach(light_.centre, p));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t j = (i + 1) % corners.size();
      ShadowWedge shadow;
      shadow.begin = corners[i];
      shadow.end = corners[j];
      shadow.source = {object_, loop[i].begin, loop[i].end};
      shadow.umbra = {corners[j], corners[i], far[i], far[j]};
      const glm::dvec4 quad = quad_plane(light_.centre, shadow.begin, shadow.end);
      std::uint32_t wedge = traces::kNone;
      if (soft_) {
        wedge =
            add_wedge(coverage_wedge(light_, shadow.begin, shadow.end, end_plane), quad, shadow);
      }
      const std::uint32_t umbra = add_umbra({shadow.umbra.begin(), shadow.umbra.end()}, quad, wedge,
                                            fb::UmbraRole_side, {UmbraPlane::quad, shadow.source});
      if (soft_ && wedge == traces::kNone) {
        geometry_.bare_edges.push_back(
            {shadow.source, SidedPlane(quad), {SidedPlane(end_plane.plane)}, umbra});
      }
    }
    add_bottoms(far, end_plane);
  }

  void add_linear_loop(const std::vector<SilhouetteEdge>& loop,
                       const std::vector<glm::dvec3>& corners, const EndPlane& end_plane) {
    Bounds bounds = bounds_;
    bounds.grow(light_.centre);
    std::vector<glm::dvec3> far;
    const std::vector<LinearWedge> wedges = linear_wedges(light_, corners, end_plane, bounds);
    LinearLoop kept{object_, {}, {}};
    for (const LinearWedge& linear : wedges) {
      kept.vertices.push_back(loop[linear.corner.place].begin);
      kept.corners.push_back(linear.corner);
    }
    const auto loop_index = static_cast<std::uint32_t>(geometry_.linear_loops.size());
    geometry_.linear_loops.push_back(kept);
    for (std::uint32_t i = 0; i < wedges.size(); ++i) {
      const LinearWedge& linear = wedges[i];
      ShadowWedge shadow;
      shadow.source = {object_, kept.vertices[i], kept.vertices[(i + 1) % wedges.size()],
                       loop_index, i};
      shadow.begin = linear.begin;
      shadow.end = linear.end;
      shadow.factors = linear.factors;
      shadow.umbra = linear.umbra;
      const glm::dvec4 front = linear.volume.planes[0];
      const std::uint32_t wedge = add_wedge(linear.volume, front, shadow);
      const std::uint32_t umbra = add_linear_umbra(linear.umbra, front, wedge, shadow.source);
      if (wedge == traces::kNone) {
        BareEdge bare{shadow.source, SidedPlane(front), {}, umbra};
        for (std::size_t k = 0; k < kLinearPlanes; ++k) {
          bare.planes.emplace_back(linear.volume.planes[k]);
        }
        geometry_.bare_edges.push_back(std::move(bare));
      }
      far.push_back(linear.umbra[2]);
    }
    add_bottoms(far, end_plane);
  }

  // The front face of a linear wedge; where its rays had to leave the front plane it is two
  // triangles in planes of their own.
  std::uint32_t add_linear_umbra(const std::array<glm::dvec3, 4>& outline, const glm::dvec4& front,
                                 std::uint32_t wedge, const EdgeSource& source) {
    const auto off_plane = [&](const glm::dvec3& p) {
      return std::abs(glm::dot(glm::dvec3(front), p) + front.w);
    };
    const double tolerance = 1e-9 * glm::distance(outline[0], outline[2]);
    if (off_plane(outline[2]) <= tolerance && off_plane(outline[3]) <= tolerance) {
      return add_umbra({outline.begin(), outline.end()}, front, wedge, fb::UmbraRole_side,
                       {UmbraPlane::front, source});
    }
    std::uint32_t first = traces::kNone;
    for (const std::size_t i : {1U, 2U}) {
      const glm::dvec3 outward = glm::cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
      const std::uint32_t umbra = add_umbra(
          {outline[0], outline[i], outline[i + 1]}, {-outward, glm::dot(outward, outline[0])},
          i == 1 ? wedge : traces::kNone, fb::UmbraRole_side,
          {i == 1 ? UmbraPlane::near_half : UmbraPlane::far_half, source});
      if (i == 1) first = umbra;
    }
    return first;
  }

  // The end of a volume: a fan over the far corners of its loop, all in the end plane. A triangle
  // may be wound the other way where the loop is not convex, or snapped so where it is thin; its
  // plane then turns with it.
  void add_bottoms(const std::vector<glm::dvec3>& far, const EndPlane& end_plane) {
    for (std::size_t i = 1; i + 1 < far.size(); ++i) {
      add_umbra({far[0], far[i + 1], far[i]}, end_plane.plane, traces::kNone, fb::UmbraRole_bottom,
                {UmbraPlane::end, {object_}});
    }
  }

  void need_z_fail() {
    trace_.header.casters[caster_].z_fail_needed = true;
    trace_.header.z_fail_needed = true;
  }

  std::uint32_t add_wedge(const WorldWedge& volume, const glm::dvec4& umbra_plane,
                          ShadowWedge shadow) {
    if (!volume.faces.empty() && pyramid_.may_meet(volume)) need_z_fail();
    fb::Wedge wedge;
    if (volume.faces.empty() || !screen_.add_faces(volume, wedge)) {
      if (volume.faces.empty()) ++geometry_.degenerate_wedges;
      return traces::kNone;
    }
    // By their distance from the light: the matrix's translation would round small lights away.
    const glm::dmat3 axes(to_light_);
    shadow.light_begin = axes * (shadow.begin - light_.centre);
    shadow.light_end = axes * (shadow.end - light_.centre);
    shadow.umbra_plane = SidedPlane(umbra_plane);
    for (std::size_t i = 0; i < std::min(volume.planes.size(), kMaxPlanes); ++i) {
      shadow.planes.emplace_back(volume.planes[i]);
    }
    const auto index = static_cast<std::uint32_t>(trace_.wedges.size());
    wedge.mutate_kind(kind_);
    wedge.mutate_umbra(traces::kNone);
    wedge.mutate_umbra_plane(screen_.plane_reference(umbra_plane));
    wedge.mutate_caster(caster_);
    wedge.mutable_edge_begin() = to_fb(shadow.light_begin);
    wedge.mutable_edge_end() = to_fb(shadow.light_end);
    for (std::size_t i = 0; i < shadow.factors.size(); ++i) {
      wedge.mutable_linear_factors()->Mutate(static_cast<flatbuffers::uoffset_t>(i),
                                             shadow.factors[i]);
    }
    trace_.wedges.push_back(wedge);
    geometry_.wedges.push_back(std::move(shadow));
    return index;
  }

  std::uint32_t add_umbra(const std::vector<glm::dvec3>& outline, const glm::dvec4& plane,
                          std::uint32_t wedge, fb::UmbraRole role, UmbraSource source) {
    const std::uint32_t reference = role == fb::UmbraRole_cap ? 0 : screen_.plane_reference(plane);
    const bool twisted = kind_ == fb::WedgeKind_linear || role == fb::UmbraRole_bottom;
    const std::uint32_t polygon =
        screen_.add_umbra_polygon(outline, reference, wedge, caster_, role, twisted);
    if (role != fb::UmbraRole_cap && pyramid_.meets(outline)) need_z_fail();
    for (std::size_t i = geometry_.umbra_planes.size(); i < trace_.umbra_polygons.size(); ++i) {
      const bool turned = trace_.umbra_polygons[i].plane() != reference;
      geometry_.umbra_planes.emplace_back(turned ? -plane : plane);
      source.turned = turned;
      geometry_.umbra_sources.push_back(source);
    }
    if (wedge != traces::kNone && polygon != traces::kNone) {
      trace_.wedges[wedge].mutate_umbra(polygon);
      trace_.wedges[wedge].mutate_umbra_plane(trace_.umbra_polygons[polygon].plane());
    }
    return polygon;
  }

  const Light& light_;
  fb::WedgeKind kind_;
  std::optional<double> length_;
  traces::Trace& trace_;
  ScreenBuilder screen_;
  NearPyramid pyramid_;
  glm::dmat4 to_light_;
  Bounds bounds_;
  bool soft_;
  std::uint32_t caster_ = 0;
  std::uint32_t object_ = 0;  // of the scene
  ShadowGeometry geometry_;
};

}  // namespace

SidedPlane::SidedPlane(const glm::dvec4& oriented) : plane(oriented) {
  for (int i = 0; i < 4; ++i) {
    if (oriented[i] != 0.0) {
      minus = oriented[i] < 0.0;
      break;
    }
  }
  if (minus) plane = -plane;
}

bool SidedPlane::inside(const glm::dvec3& p) const {
  return (glm::dot(glm::dvec3(plane), p) + plane.w >= 0.0) != minus;
}

ShadowGeometry build_shadow_geometry(const Scene& scene, const Window& window, fb::WedgeKind kind,
                                     std::optional<double> length, const Bounds& receivers,
                                     traces::Trace& trace) {
  Builder builder(scene, window, kind, length, receivers, trace);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!scene.objects[i].casts) continue;
    try {
      builder.add_caster(scene.objects[i].mesh, static_cast<std::uint32_t>(i));
    } catch (const InputError& error) {
      throw InputError(scene.place, error.what());
    }
  }
  return builder.take();
}

}  // namespace wedgesim::functional

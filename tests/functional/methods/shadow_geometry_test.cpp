#include "functional/methods/shadow_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "functional/geometry/silhouette.h"
#include "functional/scene/primitives.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

Scene box_over_floor() {
  Scene scene;
  scene.name = "box";
  scene.width = 96;
  scene.height = 64;
  scene.camera.eye = {4.0, 5.0, 9.0};
  scene.camera.target = {0.0, 0.5, 0.0};
  scene.light.centre = {-2.0, 9.0, 1.0};
  scene.light.half_u = {0.5, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.5};
  Object floor;
  floor.mesh = make_plane({20.0, 20.0}, {2, 2});
  floor.mesh.name = "floor";
  Object box;
  box.casts = true;
  box.mesh = make_box({1.0, 1.0, 1.0});
  box.mesh.name = "box";
  for (glm::dvec3& p : box.mesh.positions) p.y += 0.8;
  scene.objects = {floor, box};
  return scene;
}

traces::Trace build(const Scene& scene, fb::WedgeKind kind, ShadowGeometry* geometry = nullptr,
                    std::optional<double> length = std::nullopt) {
  traces::Trace trace;
  const Window window = make_window(scene.camera, scene.width, scene.height);
  ShadowGeometry built =
      build_shadow_geometry(scene, window, kind, length, bounds_of(scene.objects), trace);
  if (geometry != nullptr) *geometry = std::move(built);
  return trace;
}

std::string error_of(const Scene& scene, fb::WedgeKind kind = fb::WedgeKind_coverage) {
  try {
    build(scene, kind);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

// One wedge and one quad for each silhouette edge, a fan below, a cap for each lit triangle.
TEST(ShadowGeometry, OneBox) {
  const Scene scene = box_over_floor();
  ShadowGeometry geometry;
  const traces::Trace trace = build(scene, fb::WedgeKind_coverage, &geometry);
  const auto edges =
      find_silhouette(scene.objects[1].mesh, scene.light.centre).loops.front().size();
  EXPECT_EQ(trace.wedges.size(), edges);
  EXPECT_EQ(geometry.wedges.size(), edges);
  EXPECT_EQ(geometry.degenerate_wedges, 0U);
  std::map<fb::UmbraRole, std::size_t> roles;
  for (const fb::UmbraPolygon& polygon : trace.umbra_polygons) ++roles[polygon.role()];
  EXPECT_EQ(roles[fb::UmbraRole_side], edges);
  EXPECT_EQ(roles[fb::UmbraRole_bottom], edges - 2);
  EXPECT_EQ(roles[fb::UmbraRole_cap], geometry.caps.size());
  EXPECT_EQ(geometry.umbra_planes.size(), trace.umbra_polygons.size());
  for (std::size_t i = 0; i < trace.wedges.size(); ++i) {
    const fb::Wedge& wedge = trace.wedges[i];
    EXPECT_EQ(wedge.kind(), fb::WedgeKind_coverage);
    ASSERT_LT(wedge.umbra(), trace.umbra_polygons.size());
    EXPECT_EQ(trace.umbra_polygons[wedge.umbra()].wedge(), i);
    EXPECT_EQ(trace.umbra_polygons[wedge.umbra()].plane(), wedge.umbra_plane());
    EXPECT_EQ(geometry.wedges[i].planes.size(), wedge.plane_count());
    EXPECT_LE(wedge.plane_count(), kMaxPlanes);
    EXPECT_GT(geometry.wedges[i].light_begin.z, 0.0);
  }
  ASSERT_EQ(trace.header.casters.size(), 1U);
  EXPECT_EQ(trace.header.casters[0].name, "box");
  EXPECT_EQ(trace.header.casters[0].triangles, 12U);
  EXPECT_FALSE(trace.header.z_fail_needed);
}

// Of a light that is a line, as far as double precision tells, edges along it have no penumbra: no
// wedge, but all the same an umbra polygon.
TEST(ShadowGeometry, WedgesThatHoldNothingAreCounted) {
  Scene scene = box_over_floor();
  scene.light.half_v.z = 0x1p-80;
  ShadowGeometry geometry;
  const traces::Trace trace = build(scene, fb::WedgeKind_linear, &geometry);
  const Mesh& box = scene.objects[1].mesh;
  const auto silhouette = find_silhouette(box, scene.light.centre);
  const auto& edges = silhouette.loops.front();
  const auto along =
      static_cast<std::size_t>(std::ranges::count_if(edges, [&](const SilhouetteEdge& edge) {
        const glm::dvec3 way = box.positions[edge.end] - box.positions[edge.begin];
        return way.y == 0.0 && way.z == 0.0;
      }));
  EXPECT_GT(along, 0U);
  EXPECT_EQ(geometry.degenerate_wedges, along);
  EXPECT_EQ(trace.wedges.size() + along, edges.size());
  const auto sides =
      std::ranges::count(trace.umbra_polygons, fb::UmbraRole_side, &fb::UmbraPolygon::role);
  EXPECT_EQ(static_cast<std::size_t>(sides), edges.size());
}

// In a closed volume the planes of sides and bottom hold the points of the shadow.
TEST(ShadowGeometry, UmbraPlanesFaceTheShadow) {
  const Scene scene = box_over_floor();
  ShadowGeometry geometry;
  const traces::Trace trace = build(scene, fb::WedgeKind_coverage, &geometry);
  const glm::dvec3 middle(0.0, 1.3, 0.0);
  const glm::dvec3 below = middle + 0.12 * (middle - scene.light.centre);
  for (std::size_t i = 0; i < trace.umbra_polygons.size(); ++i) {
    if (trace.umbra_polygons[i].role() == fb::UmbraRole_cap) continue;
    EXPECT_TRUE(geometry.umbra_planes[i].inside(below)) << i;
    EXPECT_FALSE(geometry.umbra_planes[i].inside(middle + glm::dvec3(0, -50, 0)) &&
                 geometry.umbra_planes[i].inside(middle + glm::dvec3(50, 20, 0)) &&
                 geometry.umbra_planes[i].inside(middle - glm::dvec3(50, -20, 0)))
        << i;
  }
}

TEST(ShadowGeometry, SidedPlanesPartSpace) {
  const SidedPlane plus(glm::dvec4(0, 2, 0, -1));
  const SidedPlane minus(glm::dvec4(0, -2, 0, 1));
  EXPECT_FALSE(plus.minus);
  EXPECT_TRUE(minus.minus);
  EXPECT_EQ(plus.plane, minus.plane);
  for (const double y : {-1.0, 0.5, 2.0}) {
    EXPECT_NE(plus.inside({3, y, 1}), minus.inside({3, y, 1})) << "in exactly one, ties included";
  }
  EXPECT_TRUE(plus.inside({0, 0.5, 0}));
}

// A light without extent has hard shadow volumes: no wedges.
TEST(ShadowGeometry, PointLightHasNoWedges) {
  Scene scene = box_over_floor();
  scene.light.shape = LightShape::point;
  for (const fb::WedgeKind kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
    const traces::Trace trace = build(scene, kind);
    EXPECT_TRUE(trace.wedges.empty());
    EXPECT_FALSE(trace.umbra_polygons.empty());
  }
}

TEST(ShadowGeometry, FixedLengthEndsTheVolumes) {
  ShadowGeometry geometry;
  build(box_over_floor(), fb::WedgeKind_coverage, &geometry, 0.25);
  for (const ShadowWedge& wedge : geometry.wedges) {
    for (std::size_t k = 2; k < 4; ++k) {
      EXPECT_GT(wedge.umbra[k].y, 0.0) << "above the floor";
      EXPECT_LT(wedge.umbra[k].y, 1.8);
    }
  }
}

// z-fail is needed where the pyramid from the eye to the near rectangle meets a volume, and where
// it lies wholly inside one and meets no polygon at all.
TEST(ShadowGeometry, ZFailWhereTheEyeIsInShadow) {
  Scene scene = box_over_floor();
  scene.objects[1].mesh = make_box({30.0, 0.2, 30.0});  // a roof far wider than the light
  for (glm::dvec3& p : scene.objects[1].mesh.positions) p.y += 6.0;
  scene.camera.eye = {0.0, 2.0, 0.5};
  scene.camera.target = {0.0, 1.0, -1.0};
  scene.camera.near_plane = 0.05;
  for (const fb::WedgeKind kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
    const traces::Trace trace = build(scene, kind);
    EXPECT_TRUE(trace.header.z_fail_needed) << "deep in the umbra";
    EXPECT_TRUE(trace.header.casters[0].z_fail_needed);
  }
  scene = box_over_floor();
  const glm::dvec3 edge_middle = glm::dvec3(0.5, 1.8, 0.0);
  scene.camera.eye = edge_middle + 0.1 * (edge_middle - scene.light.centre);
  scene.camera.target = scene.camera.eye + glm::dvec3(1.0, -0.2, 0.0);
  EXPECT_TRUE(build(scene, fb::WedgeKind_coverage).header.z_fail_needed) << "in a penumbra";
}

TEST(ShadowGeometry, LightsAmongCastersAreRefused) {
  Scene scene = box_over_floor();
  scene.light.centre = {0.0, 1.5, 0.0};
  const std::string inside = error_of(scene);
  EXPECT_EQ(inside.find("scene: box: "), 0U) << inside;
  EXPECT_NE(inside.find("not clear of the light"), std::string::npos) << inside;
  EXPECT_NE(inside.find("in front of the rectangle's plane"), std::string::npos) << inside;
  EXPECT_EQ(inside.find('\n'), std::string::npos) << "one line";

  scene = box_over_floor();
  scene.light.centre = {3.0, 1.0, 0.0};  // shines down, beside the box: partly behind it
  EXPECT_NE(error_of(scene).find("not clear of the light"), std::string::npos);

  scene = box_over_floor();
  scene.light.shape = LightShape::sphere;
  scene.light.radius = 0.6;
  scene.light.centre = {0.6, 2.2, 0.6};  // a corner of the box inside the sphere
  const std::string sphere = error_of(scene);
  EXPECT_NE(sphere.find("not clear of the light"), std::string::npos) << sphere;
  EXPECT_NE(sphere.find("outside the light"), std::string::npos) << sphere;
}

}  // namespace
}  // namespace wedgesim::functional

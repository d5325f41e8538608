// Are the umbra and the penumbra of the D-buffer where they truly are? Its texels limit what it can
// know: within one texel of the true outlines it may say either.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <iostream>
#include <limits>

#include "functional/geometry/hull.h"
#include "functional/methods/d_buffer_map.h"
#include "functional/methods/method.h"
#include "functional/scene/primitives.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 200;
constexpr int kTexels = 256;

// A caster over a floor at y = 0, seen from below: nothing is in front of the floor.
Scene scene_over_floor(Mesh caster, const glm::dvec3& centre, double half_light, double floor) {
  Scene scene;
  scene.width = scene.height = kSize;
  scene.camera.eye = glm::dvec3(0.01, -40.0, 0.02);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  scene.camera.field_of_view_degrees = 2.0 * std::atan(0.5 * floor / 40.0) * 180.0 / M_PI;
  scene.camera.near_plane = 10.0;
  scene.light.centre = centre;
  scene.light.half_u = glm::dvec3(half_light, 0.0, 0.0);
  scene.light.half_v = glm::dvec3(0.0, 0.0, half_light);
  Object ground;
  ground.mesh = make_plane({floor, floor}, {1, 1});
  scene.objects.push_back(ground);
  Object object;
  object.mesh = std::move(caster);
  object.casts = true;
  scene.objects.push_back(object);
  return scene;
}

void place(Mesh& mesh, const glm::dmat3& linear, const glm::dvec3& at) {
  for (glm::dvec3& p : mesh.positions) p = linear * p + at;
}

enum class Zone { umbra, penumbra, lit };

// What a point of the floor truly sees of a disk parallel to it past a convex caster: the caster's
// projection from the point into the disk's plane is the hull of its vertices' projections, and
// the disk is inside it, outside it or neither.
Zone zone_at(const Mesh& caster, const LightDisk& disk, const glm::dvec3& x) {
  std::vector<glm::dvec2> points;
  for (const glm::dvec3& p : caster.positions) {
    const glm::dvec3 q = x + (p - x) * (disk.centre.y - x.y) / (p.y - x.y) - disk.centre;
    points.emplace_back(q.x, q.z);
  }
  const std::vector<glm::dvec2> hull = convex_hull(points);
  double inside = std::numeric_limits<double>::infinity();   // the least distance to an edge's line
  double outside = std::numeric_limits<double>::infinity();  // the least distance to an edge
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 way = hull[(i + 1) % hull.size()] - hull[i];
    const double length = glm::length(way);
    const double offset = (way.y * hull[i].x - way.x * hull[i].y) / length;
    const double along = -glm::dot(way, hull[i]) / (length * length);
    inside = std::min(inside, offset);
    outside = std::min(outside, glm::length(hull[i] + std::clamp(along, 0.0, 1.0) * way));
  }
  if (inside >= disk.radius) return Zone::umbra;
  if (inside >= 0.0 || outside < disk.radius) return Zone::penumbra;
  return Zone::lit;
}

struct Mismatch {
  int wrong = 0;       // pixels whose zone is nowhere within a texel
  int boundary = 0;    // pixels with another zone within a texel
  int zones[3] = {0};  // pixels by their true zone
};

Mismatch compare(const Scene& scene, const std::string& choice) {
  const Window window = make_window(scene.camera, kSize, kSize);
  const DepthBuffer depth = render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  const Visibility visibility =
      render_method({scene, window, depth}, choose_method("--method", choice));
  const Mesh& caster = scene.objects[1].mesh;
  const LightDisk disk = disk_of(scene.light, glm::dvec3(0.0));
  const std::vector<DiskSilhouettes> silhouettes{find_disk_silhouettes(disk, caster)};
  const std::vector<DiskVolumes> volumes{
      extrude_disk_volumes(disk, caster, silhouettes[0], 1.001 * disk.centre.y)};
  DBufferOptions options;
  options.resolution = kTexels;
  const LightView view = draw_d_buffer(scene, disk, silhouettes, volumes, options).view;
  const MapRays rays(view);

  Mismatch result;
  for (std::size_t pixel = 0; pixel < visibility.values.size(); ++pixel) {
    const double z = traces::decode_depth(depth.format, depth.words[pixel]);
    const glm::dvec3 x = world_point(window, static_cast<double>(pixel % kSize) + 0.5,
                                     static_cast<double>(pixel / kSize) + 0.5, z);
    const float v = visibility.values[pixel];
    const Zone said = v == 0.0F ? Zone::umbra : (v == 1.0F ? Zone::lit : Zone::penumbra);
    const Zone truth = zone_at(caster, disk, x);
    ++result.zones[static_cast<int>(truth)];
    if (said == truth) continue;
    const MapPlace at = place_in(view, x);
    bool near = false;
    for (int i = 0; i < 16 && !near; ++i) {
      const double angle = 2.0 * M_PI * i / 16.0;
      const glm::dvec3 ray = rays.at(at.x + std::cos(angle), at.y + std::sin(angle));
      near = zone_at(caster, disk, disk.centre - disk.centre.y / ray.y * ray) == said;
    }
    ++(near ? result.boundary : result.wrong);
  }
  return result;
}

void print(const std::string& name, const Mismatch& m) {
  std::cout << name << ": umbra " << m.zones[0] << ", penumbra " << m.zones[1] << ", lit "
            << m.zones[2] << " pixels; off within a texel " << m.boundary << ", beyond " << m.wrong
            << '\n';
}

const std::string kChoice = "d-buffer:resolution=" + std::to_string(kTexels);

// Boxes turned any way under lights from small to four times their size.
TEST(DBufferBoundary, BoxesUnderSmallAndLargeLights) {
  Random random(71);
  for (const double half_light : {0.3, 1.0, 2.0, 4.0}) {
    for (int i = 0; i < 3; ++i) {
      Mesh box =
          make_box({random.uniform(0.5, 2.5), random.uniform(0.3, 2.0), random.uniform(0.5, 2.5)});
      const glm::dquat turn = glm::angleAxis(random.uniform(0.0, 3.0), random.direction());
      place(box, glm::mat3_cast(turn), {0.0, random.uniform(3.0, 5.0), 0.0});
      const Scene scene =
          scene_over_floor(box, {random.uniform(-2.0, 2.0), 12.0, random.uniform(-2.0, 2.0)},
                           half_light, 5.0 + 3.5 * half_light);
      const Mismatch found = compare(scene, kChoice);
      print("box, half light " + std::to_string(half_light), found);
      EXPECT_EQ(found.wrong, 0);
      EXPECT_GT(found.zones[1], 100);
    }
  }
}

// Bodies of many sides: spheres and stretched ones.
TEST(DBufferBoundary, RoundBodies) {
  Random random(72);
  for (const double half_light : {0.5, 1.5, 3.0}) {
    for (int i = 0; i < 2; ++i) {
      Mesh sphere = make_sphere(1.0, 12, 8);
      const glm::dquat turn = glm::angleAxis(random.uniform(0.0, 3.0), random.direction());
      glm::dmat3 stretch(1.0);
      stretch[0][0] = random.uniform(0.4, 1.5);
      stretch[1][1] = random.uniform(0.4, 1.5);
      place(sphere, glm::mat3_cast(turn) * stretch, {0.0, random.uniform(3.0, 5.0), 0.0});
      const Scene scene =
          scene_over_floor(sphere, {random.uniform(-2.0, 2.0), 12.0, random.uniform(-2.0, 2.0)},
                           half_light, 5.0 + 3.5 * half_light);
      const Mismatch found = compare(scene, kChoice);
      print("round, half light " + std::to_string(half_light), found);
      EXPECT_EQ(found.wrong, 0);
      EXPECT_GT(found.zones[1], 100);
    }
  }
}

// The paper's penumbra silhouette is between triangles that see all of the light and others: a
// steep roof under a wide light has none, and the outer half of its penumbra is missing; under a
// small light it is there.
TEST(DBufferBoundary, WithoutATriangleThatSeesAllOfTheLightThereIsNoOuterPenumbra) {
  for (const double half_light : {0.5, 3.0}) {
    Mesh pyramid;
    pyramid.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 4, 0}};
    pyramid.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
    place(pyramid, glm::dmat3(1.0), {0.0, 3.0, 0.0});
    const Scene scene =
        scene_over_floor(pyramid, {0.0, 12.0, 0.0}, half_light, 5.0 + 3.5 * half_light);
    const Mismatch found = compare(scene, kChoice);
    print("pyramid, half light " + std::to_string(half_light), found);
    if (half_light < 1.0) {
      EXPECT_EQ(found.wrong, 0);
    } else {
      EXPECT_GT(found.wrong, found.zones[1] / 4);
    }
  }
}

}  // namespace
}  // namespace wedgesim::functional

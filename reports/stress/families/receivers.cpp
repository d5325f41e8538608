#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <memory>
#include <utility>

#include "functional/geometry/extent.h"
#include "functional/scene/primitives.h"
#include "functional/scene/transform.h"
#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"
#include "reports/stress/families/penumbra.h"

namespace wedgesim::reports::stress {
namespace {

namespace fb = traces::fb;

// A shelf in front of a wall, lit from above and seen from below. The row of pixels in the middle
// of the frame looks at points of the wall in the penumbra of the shelf's rear edge, at a distance
// from it; their depth is 1/2, which is stored without error.
Case contact(std::uint64_t seed, double distance) {
  constexpr double kHalfWidth = 1.2;
  constexpr double kShelfDepth = 1.6;
  Stage stage = make_stage(seed, 1.2);
  functional::Scene& scene = stage.result.scene;
  functional::Placement upright;
  upright.turn_degrees = {90.0, 0.0, 0.0};
  scene.objects.push_back(
      {functional::placed(functional::make_plane({kFloorSide, kFloorSide}, {1, 1}), upright)});
  scene.objects.back().mesh.name = "wall";
  scene.light.centre.z += 4.0;
  const glm::dvec3 target{stage.random.between(-0.2, 0.2), 4.0, 0.0};
  const glm::dvec3 right(kHalfWidth, 0.0, 0.0);
  const glm::dvec3 front(0.0, 0.0, kShelfDepth);
  const Penumbra penumbra =
      penumbra_of(scene.light, target - right, target + right, target + front);
  const double share = stage.random.between(-0.8, 0.8);
  const double angle = share * (share < 0.0 ? -penumbra.least : penumbra.most);
  const glm::dvec3 edge = target + distance * kSize * penumbra.towards(angle);
  const std::vector<glm::dvec3> loop{edge - right, edge + right, edge + right + front,
                                     edge - right + front};
  const glm::dvec3 middle = 0.5 * (loop[0] + loop[2]) - scene.light.centre;
  add_caster(stage.result,
             between_pyramids(scene.light, glm::dvec2(middle.x, middle.z) / -middle.y, loop));
  scene.width = 33;
  scene.height = 25;
  scene.camera.target = target;
  scene.camera.eye = target + glm::dvec3(0.0, -2.8, 6.0);
  const double far = scene.camera.far_plane;
  const double away = glm::distance(scene.camera.eye, scene.camera.target);
  scene.camera.near_plane = far * away / (2.0 * far - away);
  stage.result.options.depth_format = fb::DepthFormat_float32;
  return std::move(stage.result);
}

// Finds the points where the rays through pixel centres meet planes of wedges.
class OnPlanes {
 public:
  explicit OnPlanes(const Case& made) {
    functional::FrameOptions options = made.options;
    options.expected_li = false;
    frame_ = functional::make_frame(made.scene, options);
    bounds_ = functional::bounds_of(made.scene.objects);
  }

  // The depth buffer with each pixel moved to the nearest such point, if there is one, and a number
  // of steps of stored z off it.
  template <typename PlanesOf>
  std::shared_ptr<const functional::DepthBuffer> moved(double steps, PlanesOf planes_of) const {
    auto buffer = std::make_shared<functional::DepthBuffer>(frame_.depth);
    for (int row = 0; row < buffer->height; ++row) {
      for (int column = 0; column < buffer->width; ++column) {
        const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer->width) +
                       static_cast<std::size_t>(column);
        const double seen = traces::decode_depth(buffer->format, buffer->words[i]);
        const double z = nearest(column + 0.5, row + 0.5, seen, planes_of);
        if (z > 1.0) continue;
        const std::int64_t off = std::llround(steps) * (i % 2 == 0 ? 1 : -1);
        buffer->words[i] =
            static_cast<std::uint32_t>(std::int64_t{traces::encode_depth(buffer->format, z)} + off);
      }
    }
    return buffer;
  }

 private:
  // The depth of the point nearest to the one seen, or above 1.
  template <typename PlanesOf>
  double nearest(double x, double y, double seen, PlanesOf planes_of) const {
    double best = 2.0;
    for (const fb::Wedge& wedge : frame_.trace.wedges) {
      for (const std::uint32_t reference : planes_of(wedge)) {
        const double z = depth_on(frame_.trace.planes[reference / 2], x, y);
        if (std::abs(z - seen) < std::abs(best - seen) && is_in(wedge, reference, x, y, z)) {
          best = z;
        }
      }
    }
    return best;
  }

  static double depth_on(const fb::Plane& plane, double x, double y) {
    return -((plane.a() * x + plane.b() * y) + plane.d()) / plane.c();
  }

  // Inside the wedge and the scene, but for the plane that the point lies on.
  bool is_in(const fb::Wedge& wedge, std::uint32_t on, double x, double y, double z) const {
    if (!(z >= wedge.z_min() && z <= wedge.z_max() && z > 0.0 && z < 1.0)) return false;
    for (std::uint32_t k = 0; k < wedge.plane_count(); ++k) {
      const std::uint32_t reference = wedge.planes()->Get(k);
      if (reference / 2 == on / 2) continue;
      const fb::Plane& p = frame_.trace.planes[reference / 2];
      const double value = ((p.a() * x + p.b() * y) + p.c() * z) + p.d();
      if ((value >= 0.0) == (reference % 2 == 1)) return false;
    }
    const glm::dvec3 point = functional::world_point(frame_.window, x, y, z);
    return glm::all(glm::greaterThan(point, bounds_.low)) &&
           glm::all(glm::lessThan(point, bounds_.high));
  }

  functional::Frame frame_;
  functional::Bounds bounds_;
};

Case harmless(std::uint64_t seed) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  return std::move(stage.result);
}

Case on_side_plane(std::uint64_t seed, double steps) {
  Case result = harmless(seed);
  result.depth = OnPlanes(result).moved(steps, [](const fb::Wedge& wedge) {
    // Of a linear wedge those it shares with its neighbours, else all but the last: its bottom.
    const bool linear = wedge.kind() == fb::WedgeKind_linear;
    const std::uint32_t first = linear ? 2 : 0;
    const std::uint32_t end = linear ? 4 : wedge.plane_count() - 1U;
    std::vector<std::uint32_t> planes;
    for (std::uint32_t k = first; k < end; ++k) planes.push_back(wedge.planes()->Get(k));
    return planes;
  });
  return result;
}

Case on_quad_plane(std::uint64_t seed, double steps) {
  Case result = harmless(seed);
  result.depth = OnPlanes(result).moved(
      steps, [](const fb::Wedge& wedge) { return std::vector{wedge.umbra_plane()}; });
  return result;
}

}  // namespace

std::vector<Family> receiver_families() {
  const std::vector<double> steps = decades(4, 0, {0.0});
  return {
      {"contact",
       "distance of the receiver from a silhouette edge over the light's height",
       "",
       decades(-1, -12, {0.0}),
       {0.0, 0.0},
       contact},
      {"on-side-plane",
       "distance of points from a wedge's side plane, in steps of stored z",
       "steps",
       steps,
       {0.0, 0.0},
       on_side_plane},
      {"on-quad-plane",
       "distance of points from a shadow quad's plane, in steps of stored z",
       "steps",
       steps,
       {0.0, 0.0},
       on_quad_plane},
  };
}

}  // namespace wedgesim::reports::stress

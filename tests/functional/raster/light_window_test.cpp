#include "functional/raster/light_window.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/error.h"
#include "functional/raster/light_map.h"
#include "functional/scene/primitives.h"
#include "functional/scene/transform.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 64;
const glm::dvec3 kLight{1.0, 7.0, -2.0};

std::vector<Object> boxes_over_a_floor() {
  std::vector<Object> objects;
  objects.push_back({make_plane({6.0, 6.0}, {1, 1}), false});
  objects.push_back({placed(make_box({1.0, 2.0, 0.5}), {.position = {3.0, 0.5, 0.0}}), true});
  objects.push_back({placed(make_box({0.5, 0.5, 0.5}), {.position = {-1.0, 1.0, 1.0}}), true});
  return objects;
}

bool inside(const MapPlace& place) {
  return place.w > 0.0 && place.x > 0.0 && place.x < kSize && place.y > 0.0 && place.y < kSize;
}

TEST(LightWindow, ShowsEveryCasterAndLittleElse) {
  const std::vector<Object> objects = boxes_over_a_floor();
  const Window window = make_light_window(objects, kLight, 0.0, kSize);
  double reach = 0.0;
  for (std::size_t i = 1; i < objects.size(); ++i) {
    for (const glm::dvec3& p : objects[i].mesh.positions) {
      const MapPlace place = place_in(window, p);
      EXPECT_TRUE(inside(place)) << place.x << " " << place.y;
      reach = std::max({reach, std::abs(place.x - 0.5 * kSize), std::abs(place.y - 0.5 * kSize)});
    }
  }
  EXPECT_GT(reach, 0.49 * kSize);
}

// A point of a penumbra is where a ray from the sphere past a caster's corner meets the floor.
TEST(LightWindow, ShowsEveryPenumbra) {
  constexpr double kRadius = 0.8;
  const std::vector<Object> objects = boxes_over_a_floor();
  const Window window = make_light_window(objects, kLight, kRadius, kSize);
  for (std::size_t i = 1; i < objects.size(); ++i) {
    for (const glm::dvec3& corner : objects[i].mesh.positions) {
      for (int k = 0; k < 16; ++k) {
        const double angle = k * M_PI / 8.0;
        const glm::dvec3 from =
            kLight + kRadius * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
        const glm::dvec3 p = from + from.y / (from.y - corner.y) * (corner - from);
        EXPECT_TRUE(inside(place_in(window, p))) << p.x << " " << p.z;
      }
    }
  }
}

TEST(LightWindow, ItsFocalLengthIsTexelsPerUnitAtDepthOne) {
  const Window window = make_light_window(boxes_over_a_floor(), kLight, 0.3, kSize);
  const glm::dvec3 centre = world_point(window, 0.5 * kSize, 0.5 * kSize, 0.5);
  const glm::dvec3 across = world_point(window, 0.5 * kSize + 10.0, 0.5 * kSize, 0.5);
  EXPECT_NEAR(focal_length(window),
              10.0 * place_in(window, centre).w / glm::distance(centre, across),
              1e-9 * focal_length(window));
}

TEST(LightWindow, RefusesCastersAllAround) {
  std::vector<Object> objects = boxes_over_a_floor();
  objects.push_back({placed(make_box({1.0, 1.0, 1.0}), {.position = {0.0, 12.0, 0.0}}), true});
  EXPECT_THROW(make_light_window(objects, kLight, 0.3, kSize), InputError);
}

TEST(LightWindow, LooksSomewhereWithoutCasters) {
  EXPECT_EQ(make_light_window({}, kLight, 0.3, kSize).width, kSize);
}

}  // namespace
}  // namespace wedgesim::functional

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

// Seen straight from above at 90 degrees, so that half a unit at the plate's height is a pixel: the
// plate's upright, level and diagonal edges pass through pixel centres.
Case pixel_on_edge(std::uint64_t seed, double parts_of_pixel) {
  constexpr double kMiddle = 8.0;  // pixels
  constexpr double kPlateHeight = 4.0;
  Stage stage = make_stage(seed, 1.5);
  functional::Scene& scene = stage.result.scene;
  scene.width = scene.height = 16;
  scene.camera = {{0.0, kSize, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 90.0, 2.0, 10.0};
  scene.light.centre.x -= 2.5;
  const glm::dvec2 move{std::round(stage.random.between(-1.0, 1.0)),
                        std::round(stage.random.between(-1.0, 1.0))};
  const auto point = [&](const glm::dvec2& pixel) {
    const glm::dvec2 p = 0.5 * (pixel + move + parts_of_pixel / 256.0 - kMiddle);
    return glm::dvec3(p.x, kPlateHeight, p.y);
  };
  std::vector<glm::dvec3> loop;
  for (const glm::dvec2 pixel :
       {glm::dvec2(3.5, 3.5), {9.5, 3.5}, {9.5, 6.5}, {6.5, 9.5}, {3.5, 9.5}}) {
    loop.push_back(point(pixel));
  }
  const glm::dvec3 middle = point({6.0, 6.0}) - scene.light.centre;
  add_caster(stage.result,
             between_pyramids(scene.light, glm::dvec2(middle.x, middle.z) / -middle.y, loop));
  return std::move(stage.result);
}

constexpr std::array<std::array<int, 2>, 6> kSizes{
    {{33, 9}, {31, 17}, {5, 3}, {1, 1}, {1, 8192}, {8192, 1}}};

// The longer side of the frame spans as much as ever; its middle is in the penumbra.
Case frame_size(std::uint64_t seed, double index) {
  Stage stage = make_stage(seed, kLightRadius);
  const std::vector<glm::dvec3> plate = add_plate(stage);
  functional::Scene& scene = stage.result.scene;
  const double last = static_cast<double>(kSizes.size() - 1);
  const auto [width, height] =
      kSizes[static_cast<std::size_t>(std::clamp(std::round(index), 0.0, last))];
  scene.width = width;
  scene.height = height;
  const double tan_half = std::tan(glm::radians(0.5 * scene.camera.field_of_view_degrees)) *
                          std::min(1.0, static_cast<double>(height) / width);
  scene.camera.field_of_view_degrees = glm::degrees(2.0 * std::atan(tan_half));
  const glm::dvec3 edge = 0.5 * (plate[0] + plate[1]) - scene.light.centre;
  scene.camera.target = scene.light.centre + (kSize / kDepth) * edge;
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> raster_families() {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < kSizes.size(); ++i) sizes.push_back(static_cast<double>(i));
  return {
      {"pixel-on-edge",
       "distance of pixel centres from polygon edges",
       "pixels/256",
       {16.0, 4.0, 1.0, 0.25, 0.0},
       {0.0, 0.0},
       pixel_on_edge},
      {"frame-size",
       "0: 33x9, 1: 31x17, 2: 5x3, 3: 1x1, 4: 1x8192, 5: 8192x1",
       "",
       sizes,
       {sizes.back(), sizes.back()},
       frame_size,
       false,
       1.0},
  };
}

}  // namespace wedgesim::reports::stress

#include "reports/accuracy/artifact_scenes.h"

#include <cmath>

#include "functional/scene/primitives.h"
#include "functional/scene/scene_file.h"
#include "functional/scene/transform.h"

namespace wedgesim::reports::accuracy {
namespace {

using functional::Scene;

Scene floor_seen_from(const glm::dvec3& eye, const glm::dvec3& up, double field_of_view_degrees) {
  Scene scene;
  scene.width = scene.height = 240;
  scene.camera = {eye, {0.0, 0.0, 0.0}, up, field_of_view_degrees, 1.0, 60.0};
  scene.objects.push_back({functional::make_plane({20.0, 20.0}, {2, 2}), false, {}});
  return scene;
}

}  // namespace

Scene built_in_scene(const std::string& name) {
  functional::SceneOptions options;
  options.size = {960, 640};
  return functional::load_scene(name, options);
}

namespace {

Scene below_square_light(double light) {
  constexpr double kHeight = 30.0;   // of the eye: its perspective is slight
  constexpr double kHalfView = 3.0;  // world units of the floor
  Scene scene = floor_seen_from({0.0, kHeight, 0.0}, {0.0, 0.0, -1.0},
                                2.0 * std::atan(kHalfView / kHeight) * 180.0 / M_PI);
  scene.light.centre = {0.0, 10.0, 0.0};
  scene.light.half_u = {light, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, light};
  return scene;
}

}  // namespace

Scene thin_polygon(const std::vector<glm::dvec2>& outline, double height, double light) {
  Scene scene = below_square_light(light);
  scene.objects.push_back(
      {functional::placed(functional::make_thin_polygon(outline), {.position = {0.0, height, 0.0}}),
       true,
       {}});
  return scene;
}

Scene thin_board(const glm::dvec2& half, double turn, double height, double light) {
  std::vector<glm::dvec2> outline;
  for (const glm::dvec2 corner : {glm::dvec2(-1, 1), {1, 1}, {1, -1}, {-1, -1}}) {
    const glm::dvec2 p = corner * half;
    outline.emplace_back(p.x * std::cos(turn) - p.y * std::sin(turn),
                         p.x * std::sin(turn) + p.y * std::cos(turn));
  }
  return thin_polygon(outline, height, light);
}

Scene fence(int bars, double width, double gap, double height, double light) {
  Scene scene = below_square_light(light);
  for (int i = 0; i < bars; ++i) {
    const double x = (i - 0.5 * (bars - 1)) * (width + gap);
    scene.objects.push_back({functional::placed(functional::make_box({width, 0.01, 2.0}),
                                                {.position = {x, height, 0.0}}),
                             true,
                             {}});
  }
  return scene;
}

Scene boxes_below_sphere(const std::vector<Box>& boxes, double radius) {
  Scene scene = floor_seen_from({0.0, 9.0, 6.0}, {0.0, 1.0, 0.0}, 36.0);
  scene.light.shape = functional::LightShape::sphere;
  scene.light.centre = {0.6, 8.0, 0.3};
  scene.light.radius = radius;
  for (const Box& box : boxes) {
    scene.objects.push_back(
        {functional::placed(functional::make_box(box.size),
                            {.turn_degrees = box.turn_degrees, .position = box.position}),
         true,
         {}});
  }
  return scene;
}

Scene comb_below_sphere(int bars, double width, double gap, double radius) {
  std::vector<Box> boxes;
  for (int i = 0; i < bars; ++i) {
    const double x = (i - 0.5 * (bars - 1)) * (width + gap);
    boxes.push_back({{width, 0.12, 2.4}, {x, 2.0, 0.0}});
  }
  return boxes_below_sphere(boxes, radius);
}

}  // namespace wedgesim::reports::accuracy

#include "functional/scene/lights.h"

#include "base/check.h"

namespace wedgesim::functional {

const Light& light_at(const Scene& scene, std::size_t i) {
  CHECK_LT(i, light_count(scene));
  return i == 0 ? scene.light : scene.other_lights[i - 1];
}

Scene with_light(const Scene& scene, std::size_t i) {
  Scene lit = scene;
  lit.light = light_at(scene, i);
  lit.other_lights.clear();
  return lit;
}

}  // namespace wedgesim::functional

#pragma once

#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <iostream>
#include <random>

namespace wedgesim::functional {

/// Random input of property tests; prints its seed, so that a failure can be had again.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) { std::cout << "seed " << seed << '\n'; }

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  /// A whole number from low to high, both included.
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }
  glm::dvec3 in_box(const glm::dvec3& low, const glm::dvec3& high) {
    return {uniform(low.x, high.x), uniform(low.y, high.y), uniform(low.z, high.z)};
  }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 d = in_box(glm::dvec3(-1.0), glm::dvec3(1.0));
      const double length = glm::length(d);
      if (length > 0.1 && length <= 1.0) return d / length;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace wedgesim::functional

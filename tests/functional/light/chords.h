#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>

#include "base/image.h"
#include "tests/functional/light/exact_area.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {

struct RandomChord {
  glm::dvec2 p, q;
};

/// A chord of the square [−1, 1]² as edges give them: mostly from border to border.
inline RandomChord random_chord(Random& random) {
  const auto end = [&] {
    glm::dvec2 p(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    if (random.chance(0.3)) return p;
    const int side = random.whole(0, 3);
    p[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
    return p;
  };
  const glm::dvec2 p = end();
  return {p, end()};
}

/// What lies beyond a chord, texel by texel: each is clipped by the rays and the chord.
/// \param shares  (height, width, 3)
inline std::array<double, 3> exact_beyond(const Image& shares, glm::dvec2 p, glm::dvec2 q) {
  if (p.x * q.y - p.y * q.x < 0.0) std::swap(p, q);
  std::array<long double, 3> sum{};
  for (int row = 0; row < shares.height; ++row) {
    for (int column = 0; column < shares.width; ++column) {
      const auto x = [&](int i) { return 2.0L * i / shares.width - 1.0L; };
      const auto y = [&](int i) { return 2.0L * i / shares.height - 1.0L; };
      LightPolygon part{{x(column), y(row)},
                        {x(column + 1), y(row)},
                        {x(column + 1), y(row + 1)},
                        {x(column), y(row + 1)}};
      const long double whole = std::abs(area_of(part));
      part = clip_half_plane(part, -p.y, p.x, 0.0L);  // counter-clockwise of p
      part = clip_half_plane(part, q.y, -q.x, 0.0L);  // clockwise of q
      const glm::dvec2 way = q - p;
      part = clip_half_plane(
          part, way.y, -way.x,
          static_cast<long double>(p.y) * way.x - static_cast<long double>(p.x) * way.y);
      for (int c = 0; c < 3; ++c) {
        sum[static_cast<std::size_t>(c)] +=
            shares.pixel(column, row)[c] * std::abs(area_of(part)) / whole;
      }
    }
  }
  return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

}  // namespace wedgesim::functional

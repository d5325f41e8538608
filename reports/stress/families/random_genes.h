#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "reports/stress/families/random_case.h"

namespace wedgesim::reports::stress {

/// Sizes, distances and depths are exponents of 2.
inline constexpr std::array<Gene, kSceneGenes> kSceneTable{{
    {"kind", 0, 1, 50},    // coverage, linear
    {"format", 0, 3, 75},  // of the stored depths
    {"z_fail", 0, 1, 20},  // asked for, even where z-pass would do
    {"light", 0, 6, 55},   // 0 a rectangle, 6 a point, else a sphere
    {"light_size", -30, 12, 40},
    {"light_flat", 0, 24, 15},  // how much shorter the rectangle's second side is
    {"light_tilt_x", -6, 6, 20},
    {"light_tilt_z", -6, 6, 20},
    {"light_roll", -7, 7, 40},
    {"scale", -30, 17, 15},
    {"offset", -8, 19, 15},  // of the scene from the origin
    {"offset_way", 0, 7, 50},
    {"axes", 0, 5, 30},   // which way is up
    {"turn", 0, 7, 30},   // off the axes
    {"grid", 0, 10, 30},  // vertices are rounded to so many bits
    {"floor_tilt_x", -8, 8, 30},
    {"floor_tilt_z", -8, 8, 30},
    {"floor_size", -4, 17, 15},
    {"wall", 0, 1, 20},
    {"eye_place", 0, 5, 30},
    {"eye_x", -8, 8, 60},
    {"eye_y", -8, 8, 60},
    {"eye_z", -8, 8, 60},
    {"eye_distance", -4, 20, 25},
    {"view", -12, 8, 35},  // how wide
    {"near", -2, 28, 25},
    {"far", -2, 28, 25},
    {"target_x", -8, 8, 40},
    {"target_z", -8, 8, 40},
    {"close_up", 0, 1, 50},  // to the penumbra of a corner
    {"up", 0, 2, 30},
    {"casters", 0, 1, 35},  // one, two
}};

inline constexpr std::array<Gene, kCasterGenes> kCasterTable{{
    {"shape", 0, 5, 80},
    {"depth", -30, 30, 35},  // below 0: near the light; above 0: near the
                             // floor
    {"size", -20, 3, 20},    // as seen from the light
    {"thick", -40, 2, 30},
    {"pyramid", 0, 1, 50},  // spreads as it leaves the light: sides point
                            // at its centre
    {"x", -8, 8, 50},
    {"z", -8, 8, 50},
    {"turn", 0, 7, 30},
    {"x0", -8, 8, 15},
    {"y0", -8, 8, 15},
    {"z0", -8, 8, 15},  // how far vertices are moved
    {"x1", -8, 8, 15},
    {"y1", -8, 8, 15},
    {"z1", -8, 8, 15},
    {"x2", -8, 8, 15},
    {"y2", -8, 8, 15},
    {"z2", -8, 8, 15},
    {"x3", -8, 8, 15},
    {"y3", -8, 8, 15},
    {"z3", -8, 8, 15},
    {"move", 0, 5, 25},
    {"move_a", 0, 7, 80},
    {"move_b", 0, 7, 80},
    {"move_by", -60, 60, 60},
    {"then", 0, 5, 15},
    {"then_a", 0, 7, 80},
    {"then_b", 0, 7, 80},
    {"then_by", -60, 60, 60},
}};

/// Where a table has a name; a name that it has not does not compile.
template <std::size_t kSize>
consteval std::size_t place_of(const std::array<Gene, kSize>& table, std::string_view name) {
  std::size_t place = 0;
  while (table.at(place).name != name) ++place;
  return place;
}
consteval std::size_t scene_place(std::string_view name) { return place_of(kSceneTable, name); }
/// Among those of one caster.
consteval std::size_t caster_place(std::string_view name) { return place_of(kCasterTable, name); }

}  // namespace wedgesim::reports::stress

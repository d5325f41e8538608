#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "functional/raster/light_map.h"

namespace wedgesim::functional {

/// A side of a volume on the ray of a texel: how near it is (light_map.h: a key, greater is nearer)
/// and which of the drawn triangles it is.
struct SideKey {
  float key = 0.0F;
  std::uint32_t triangle = 0;
};

/// What one caster has on the rays of a map, as the D-buffer needs it: all empty between casters.
class CasterLayer {
 public:
  explicit CasterLayer(std::size_t texels) : texels_(texels) {}

  struct Texel {
    std::uint16_t entries = 0;  // how often the ray enters the caster
    std::int16_t inside = 0;    // umbra volumes entered less those left
    float entry = 0.0F;         // key of the nearest entry; 0 if none
    float exit = 0.0F;          // of the nearest place where the ray leaves it
    SideKey nearest;            // of the sides offered; key 0 if none
    SideKey farthest;

    bool untouched() const {
      return entries == 0 && inside == 0 && exit == 0.0F && nearest.key == 0.0F;
    }
    void enter(float key) {
      ++entries;
      if (key > entry) entry = key;
    }
    void leave(float key) {
      if (key > exit) exit = key;
    }
    void cross(bool into) { into ? ++inside : --inside; }
    void offer(const SideKey& side) {
      if (side.key > nearest.key) nearest = side;
      if (farthest.key == 0.0F || side.key < farthest.key) farthest = side;
    }
  };
  Texel& operator[](std::size_t texel) { return texels_[texel]; }

 private:
  std::vector<Texel> texels_;
};

}  // namespace wedgesim::functional

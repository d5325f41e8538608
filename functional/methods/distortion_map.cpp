#include "functional/methods/distortion_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/check.h"
#include "functional/raster/spans.h"

namespace wedgesim::functional {
DistortionMap::DistortionMap(std::span<const PenumbraStrip> strips, int size, int maps)
    : size_(size), maps_(maps), tiles_(static_cast<std::size_t>(light_tiles(size))) {
  CHECK_GE(maps, 1);
  CHECK_LE(maps, 2);
  for (std::size_t map = 0; map < static_cast<std::size_t>(maps); ++map) {
    texels_[map] = std::make_unique_for_overwrite<Tile[]>(tiles_ * tiles_);
  }
  used_.assign(tiles_ * tiles_, 0);

  const std::vector<StripSplat> splats = strip_splats(strips);
  std::vector<std::vector<std::uint32_t>> bands(tiles_);
  for (std::size_t i = 0; i < splats.size(); ++i) {
    const auto corners = std::span(splats[i].corners).first(splats[i].count);
    const auto [low, high] = std::ranges::minmax_element(corners, {}, &SnappedPoint::y);
    const int first = std::max(0, (low->y >> 8) / kLightTile);
    const int last = std::min(static_cast<int>(tiles_) - 1, (high->y >> 8) / kLightTile);
    for (int band = first; band <= last; ++band) {
      bands[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(i));
    }
  }

  std::vector<Count> counts(tiles_);
  tbb::parallel_for(std::size_t{0}, tiles_, [&](std::size_t band) {
    const int y_begin = static_cast<int>(band) * kLightTile;
    for (const std::uint32_t i : bands[band]) {
      const Count count = draw(splats[i], strips[splats[i].name.strip()], y_begin,
                               std::min(size_, y_begin + kLightTile));
      counts[band].compared += count.compared;
      counts[band].written += count.written;
    }
  });
  for (const Count& count : counts) {
    compared_ += count.compared;
    written_ += count.written;
  }
}

DistortionMap::Tile& DistortionMap::touch(std::size_t map, int x, int y) {
  const std::size_t index = tile_of(x, y);
  Tile& tile = texels_[map][index];
  const auto bit = static_cast<std::uint8_t>(1U << map);
  if ((used_[index] & bit) == 0) {
    used_[index] = static_cast<std::uint8_t>(used_[index] | bit);
    tile.distance.fill(std::numeric_limits<float>::infinity());
    tile.name.fill(StripName::kNone);
  }
  return tile;
}

DistortionMap::Count DistortionMap::draw(const StripSplat& splat, const PenumbraStrip& strip,
                                         int y_begin, int y_end) {
  Count count;
  const std::size_t map = maps_ == 2 && splat.inside ? 1 : 0;
  const bool corner = splat.name.part() != StripName::Part::edge;
  const glm::vec2 outward = strip.outward();
  for_each_span(
      {splat.corners.data(), splat.count}, size_, y_begin, y_end, [&](int y, int x0, int x1) {
        const float dy = static_cast<float>(y) + 0.5F - strip.begin.y;
        count.compared += static_cast<std::uint64_t>(x1 - x0);
        for (int x = x0; x < x1;) {
          const int stop = std::min(x1, (x / kLightTile + 1) * kLightTile);
          Tile& tile = touch(map, x, y);
          std::size_t texel = texel_of(x, y);
          for (; x < stop; ++x, ++texel) {
            const float dx = static_cast<float>(x) + 0.5F - strip.begin.x;
            const float distance =
                corner ? std::sqrt(dx * dx + dy * dy) : std::abs(dx * outward.x + dy * outward.y);
            if (distance < tile.distance[texel]) {
              tile.distance[texel] = distance;
              tile.name[texel] = splat.name.word;
              ++count.written;
            }
          }
        }
      });
  return count;
}

}  // namespace wedgesim::functional

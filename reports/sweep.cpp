#include "reports/sweep.h"

namespace wedgesim::reports {

std::vector<model::CountConfig> Sweep::configs() const {
  std::vector<model::CountConfig> configs;
  for (const model::Mode mode : modes) {
    for (const unsigned tile : tiles) {
      for (const model::Cull cull : culls) {
        for (const model::UmbraCull umbra_cull : umbra_culls) {
          for (const model::Accept accept : accepts) {
            for (const model::Share share : shares) {
              configs.push_back({mode, tile, cull, umbra_cull, accept, share, z, tile_build});
            }
          }
        }
      }
    }
  }
  return configs;
}

std::vector<unsigned> all_tiles() {
  std::vector<unsigned> tiles;
  for (unsigned tile = model::kMinTile; tile <= model::kMaxTile; tile *= 2) tiles.push_back(tile);
  return tiles;
}

}  // namespace wedgesim::reports

#pragma once

#include <vector>

#include "model/count/config.h"

namespace wedgesim::reports {

/// Sets of options; what is counted is every combination of them.
struct Sweep {
  std::vector<model::Mode> modes{model::CountConfig{}.mode};
  std::vector<unsigned> tiles{model::CountConfig{}.tile};
  std::vector<model::Cull> culls{model::CountConfig{}.cull};
  std::vector<model::UmbraCull> umbra_culls{model::CountConfig{}.umbra_cull};
  std::vector<model::Accept> accepts{model::CountConfig{}.accept};
  std::vector<model::Share> shares{model::CountConfig{}.share};
  model::ZChoice z = model::CountConfig{}.z;
  model::TileBuild tile_build = model::CountConfig{}.tile_build;

  /// In the order of the members, the last of them changing fastest.
  std::vector<model::CountConfig> configs() const;
};

/// All tile edges, 2 to 256.
std::vector<unsigned> all_tiles();

}  // namespace wedgesim::reports

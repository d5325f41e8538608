#include "reports/stress/configurations.h"

#include <algorithm>
#include <array>

#include "model/count/count.h"
#include "reports/stress/frame.h"

namespace wedgesim::reports::stress {

bool configurations_agree(const functional::Frame& frame, const model::Datapath& datapath,
                          const std::vector<std::int64_t>& sums) {
  using namespace model;  // NOLINT: the vocabulary of configurations
  std::array configs{
      CountConfig{Mode::three_pass, 2, Cull::both, UmbraCull::zmax},
      CountConfig{Mode::single_pass, 4, Cull::sat, UmbraCull::zmax, Accept::zmin, Share::all},
      CountConfig{Mode::single_pass, 8, Cull::none, UmbraCull::none},
      CountConfig{Mode::three_pass, 16, Cull::planes, UmbraCull::zmax, Accept::zmin},
      CountConfig{Mode::single_pass, 64, Cull::zmax, UmbraCull::none},
  };
  const bool fail = stress::method_of(frame) == ZMethod::fail;
  for (CountConfig& config : configs) config.z = fail ? ZChoice::fail : ZChoice::automatic;
  CountOptions options;
  options.threads = 1;
  options.maps = true;
  options.datapath = datapath;
  return std::ranges::all_of(count(frame.trace.view(), configs, options), [&](const auto& result) {
    return result.wrong_contributions == 0 && result.li == sums;
  });
}

}  // namespace wedgesim::reports::stress

#include <fmt/format.h>

#include "base/error.h"
#include "reports/study.h"
#include "reports/sweep.h"

namespace wedgesim::reports {
namespace {

using model::Accept;
using model::Cull;
using model::Mode;
using model::Share;
using model::UmbraCull;

void append(std::vector<model::CountConfig>& configs, const Sweep& sweep) {
  const std::vector<model::CountConfig> more = sweep.configs();
  configs.insert(configs.end(), more.begin(), more.end());
}

// The question of Paper II: what single-pass saves, and what each culling test does, at every tile
// size.
Study paper2() {
  Study study;
  study.name = "paper2";
  study.scenes = {"plain-columns", "columns", "fractal", "text2002", "bunny"};
  Sweep each_test;
  each_test.modes = {Mode::three_pass, Mode::single_pass};
  each_test.tiles = all_tiles();
  each_test.culls = {Cull::none, Cull::zmax, Cull::zrange, Cull::planes, Cull::both, Cull::sat};
  Sweep no_umbra_test = each_test;
  no_umbra_test.umbra_culls = {UmbraCull::none};
  append(study.configs, no_umbra_test);
  Sweep acceptance_alone = no_umbra_test;
  acceptance_alone.culls = {Cull::none};
  acceptance_alone.accepts = {Accept::zmin};
  append(study.configs, acceptance_alone);
  append(study.configs, each_test);
  Sweep accepting = each_test;
  accepting.culls = {Cull::both};
  accepting.accepts = {Accept::zmin};
  append(study.configs, accepting);
  Sweep all_shared = accepting;
  all_shared.modes = {Mode::single_pass};
  all_shared.accepts = {Accept::none, Accept::zmin};
  all_shared.shares = {Share::all};
  append(study.configs, all_shared);
  return study;
}

}  // namespace

Study built_in_study(std::string_view name) {
  if (name == "paper2") return paper2();
  throw InputError(name, "no such study", "paper2");
}

}  // namespace wedgesim::reports

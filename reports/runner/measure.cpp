#include "reports/runner/measure.h"

#include <algorithm>

#include "base/check.h"
#include "reports/runner/metrics.h"

namespace wedgesim::reports {
namespace {

bool equal(model::datapath::Formats a, model::datapath::Formats b) {
  return std::ranges::all_of(model::datapath::kWidths, [&](const model::datapath::Width& width) {
    return width.of(a) == width.of(b);
  });
}

}  // namespace

std::vector<int> common_part(const Configuration& configuration) {
  std::vector<int> part{static_cast<int>(configuration.measure)};
  const auto add = [&part](auto... values) { (part.push_back(static_cast<int>(values)), ...); };
  const bool counts = configuration.measure == Measure::count;
  if (counts) {
    add(configuration.datapath);
  } else {
    const auto [mode, tile, cull, umbra_cull, accept, share, z, tile_build] =
        configuration.block.rasterizer;
    add(mode, tile, cull, umbra_cull, accept, share, z, tile_build);
  }
  if (!counts || configuration.datapath == model::DatapathKind::fixed) {
    model::datapath::Formats formats = configuration.block.formats;
    for (const model::datapath::Width& width : model::datapath::kWidths) add(width.of(formats));
  }
  return part;
}

std::vector<Values> Measurer::measure(const std::vector<const Configuration*>& configurations) {
  if (configurations.front()->measure == Measure::count) return count(configurations);
  CHECK_EQ(configurations.size(), 1U);
  return {run_block(*configurations.front())};
}

std::vector<Values> Measurer::count(const std::vector<const Configuration*>& configurations) const {
  std::vector<model::CountConfig> configs;
  for (const Configuration* configuration : configurations) {
    configs.push_back(configuration->block.rasterizer);
  }
  model::CountOptions options;
  options.threads = 1;
  options.datapath = configurations.front()->count_datapath();
  std::vector<Values> values;
  for (const model::CountResult& result : model::count(trace_.view(), configs, options)) {
    values.push_back(metrics_of(result));
  }
  return values;
}

Values Measurer::run_block(const Configuration& configuration) {
  const model::BlockConfig& block = configuration.block;
  if (!frame_ || frame_->frame.rasterizer != block.rasterizer || !equal(*formats_, block.formats)) {
    frame_.reset();  // before the next takes as much memory
    frame_ = check_frame(trace_.view(), block);
    formats_ = block.formats;
  }
  return metrics_of(run_cycles(*frame_, block, {}));
}

}  // namespace wedgesim::reports

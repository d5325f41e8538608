#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "reports/study.h"

namespace wedgesim::reports {

/// A result as count() would give it, with these accesses and nothing wrong.
inline model::CountResult make_result(const model::CountConfig& config, std::uint64_t reads,
                                      std::uint64_t writes, std::uint64_t visits = 0) {
  model::CountResult result;
  result.config = config;
  result.counters = std::make_unique<model::Counters>();
  result.counters->z_reads = reads;
  result.counters->li_writes = writes;
  result.counters->tile_visits = visits;
  result.counters->z_reads_floor = 100;
  result.counters->li_writes_floor = 50;
  result.counters->all_bytes = 2500 * reads;
  result.pixels.compared = 6;
  result.pixels.tolerance = 1e-6;
  result.seconds = 0.25;
  return result;
}

/// Both modes at tiles 4 and 8; single-pass saves 20 % of the reads and 10 % of the writes at 4,
/// half and nothing at 8; smaller tiles have fewer accesses and more visits.
inline StudyResults make_study_results() {
  StudyResults results;
  results.study.name = "sample";
  results.study.scenes = {"somewhere"};
  SceneResults scene;
  scene.scene = "somewhere";
  scene.trace = {"somewhere", 0xabcU, 3, 2, 7};
  const auto add = [&](model::Mode mode, unsigned tile, std::uint64_t reads, std::uint64_t writes,
                       std::uint64_t visits) {
    model::CountConfig config;
    config.mode = mode;
    config.tile = tile;
    results.study.configs.push_back(config);
    scene.results.push_back(make_result(config, reads, writes, visits));
  };
  add(model::Mode::three_pass, 4, 1000, 500, 400);
  add(model::Mode::single_pass, 4, 800, 450, 300);
  add(model::Mode::three_pass, 8, 2000, 500, 90);
  add(model::Mode::single_pass, 8, 1000, 500, 80);
  results.scenes.push_back(std::move(scene));
  return results;
}

}  // namespace wedgesim::reports

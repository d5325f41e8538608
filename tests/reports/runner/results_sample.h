#pragma once

#include <string>

#include "model/count/config.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// Both modes at tiles 4 and 8 on one frame; single-pass saves 20 % of the reads and 10 % of the
/// writes at 4, half and nothing at 8; smaller tiles have fewer accesses and more visits.
inline Results sample_results() {
  Results results;
  results.study.name = "sample";
  results.study.title = "A sample";
  results.study.measure = "count";
  results.study.axes = {"block.mode", "block.tile"};
  results.study.metrics = {"z_reads"};
  FrameRow frame;
  frame.key = "f";
  frame.label = frame.scene = "somewhere";
  frame.parameters = {{"width", std::int64_t{3}}, {"height", std::int64_t{2}}};
  frame.checksum = 0xabcU;
  frame.wedges = 7;
  results.frames.push_back(frame);
  const auto add = [&results](const char* mode, std::int64_t tile, std::int64_t reads,
                              std::int64_t writes, std::int64_t visits) {
    PointRow point;
    point.key = std::string(mode) + std::to_string(tile);
    point.frame = "somewhere";
    point.measure = "count";
    point.configuration = {
        {"block.mode", std::string(mode)},     {"block.tile", tile},
        {"block.cull", std::string("both")},   {"block.umbra_cull", std::string("zmax")},
        {"block.accept", std::string("none")}, {"block.share", std::string("eye")}};
    point.metrics = {{"z", std::string("pass")},
                     {"z_reads", reads},
                     {"li_writes", writes},
                     {"tile_visits", visits},
                     {"z_reads_floor", std::int64_t{100}},
                     {"li_writes_floor", std::int64_t{50}},
                     {"over_floor", static_cast<double>(reads + writes) / 150.0},
                     {"all_bytes", 2500 * reads},
                     {"compared", std::int64_t{6}},
                     {"mismatched", std::int64_t{0}},
                     {"wrong_contributions", std::int64_t{0}},
                     {"tolerance", 1e-6}};
    point.seconds = 0.25;
    results.points.push_back(point);
  };
  add("three-pass", 4, 1000, 500, 400);
  add("single-pass", 4, 800, 450, 300);
  add("three-pass", 8, 2000, 500, 90);
  add("single-pass", 8, 1000, 500, 80);
  results.points_planned = 4;
  return results;
}

}  // namespace wedgesim::reports

#include "tests/reports/page/sample.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/image.h"

namespace wedgesim::tests {
namespace {

using namespace reports;  // NOLINT: the vocabulary of results

Value integer(double number) { return static_cast<std::int64_t>(std::llround(number)); }

FrameRow make_frame(const std::string& scene, int view, int width = 640, int height = 427) {
  FrameRow frame;
  frame.scene = scene;
  frame.label = fmt::format("{}-f{}-{}x{}", scene, view, width, height);
  frame.key = fmt::format("{:032x}", std::hash<std::string>{}(frame.label));
  frame.parameters = {{"frame", std::int64_t{view}},    {"width", std::int64_t{width}},
                      {"height", std::int64_t{height}}, {"kind", std::string("coverage")},
                      {"light", std::string("rect")},   {"depth", std::string("unorm24")}};
  frame.wedges = 100 * (view + 1);
  return frame;
}

PointRow make_point(Results& results, const FrameRow& frame, const std::string& measure) {
  PointRow point;
  point.key = fmt::format("{:032x}", 0x9e3779b97f4a7c15ULL * (results.points.size() + 1));
  point.frame = frame.label;
  point.measure = measure;
  point.seconds = 0.01 * static_cast<double>(1 + results.points.size() % 7);
  point.configuration = {{"block.umbra_cull", std::string("zmax")},
                         {"block.accept", std::string("none")},
                         {"block.share", std::string("eye")},
                         {"block.z", std::string("auto")},
                         {"block.tile_build", std::string("eager")}};
  return point;
}

void add_counted(Results& results, const FrameRow& frame, double f, const std::string& mode,
                 int tile, const std::string& cull) {
  PointRow point = make_point(results, frame, "count");
  point.configuration["block.mode"] = mode;
  point.configuration["block.tile"] = std::int64_t{tile};
  point.configuration["block.cull"] = cull;
  point.configuration["datapath"] = std::string("exact");
  const bool single = mode == "single-pass";
  const double factor = cull == "none" ? 4.0 : cull == "zmax" ? 2.0 : 1.0;
  const double reads = 1000 * (f + 10) * (tile + 16) / (single ? 20.0 : 18.0) * factor;
  const double writes = 9000 * (f + 10) * (single ? 0.97 : 1.0);
  const double needless = 3e5 * (f + 10) / tile;
  Values& m = point.metrics;
  m["z_reads"] = integer(reads);
  m["li_writes"] = integer(writes);
  m["accesses"] = integer(reads + writes);
  m["z_reads_floor"] = integer(4000 * (f + 10));
  m["li_writes_floor"] = integer(3600 * (f + 10));
  m["over_floor"] = (reads + writes) / (7600 * (f + 10));
  m["all_bytes"] = integer(4 * reads + 40000 * (f + 10) * (8.0 / tile + tile / 8.0));
  m["tile_visits"] = integer(4e5 * (f + 10) / tile);
  m["needless_visits"] = integer(needless);
  m["visits_culled_zmax"] = integer(cull == "zmax" ? 0.5 * needless : 0.0);
  m["visits_culled_zrange"] = integer(cull == "both" ? 0.3 * needless : 0.0);
  m["visits_culled_planes"] = integer(cull == "both" ? 0.4 * needless : 0.0);
  m["visits_culled_sat"] = integer(0.0);
  m["umbra_visits_culled"] = integer(0.1 * needless);
  m["mismatched"] = integer(0.0);
  m["max_error"] = 8.3e-9;
  results.points.push_back(std::move(point));
}

}  // namespace

Results counted_results() {
  Results results;
  results.study.name = "sample";
  results.study.title = "Tiles and culling, made up";
  results.study.question = "Which tile size costs least, and what does culling save?";
  results.study.measure = "count";
  results.study.axes = {"block.mode", "block.tile", "block.cull"};
  results.study.by = {"scene"};
  results.study.metrics = {"z_reads", "li_writes", "all_bytes"};
  results.study.plots = {
      {"bar", "Visits of tiles, by culling", "block.cull", "tile_visits", "block.mode"}};
  double f = 0;
  for (const char* scene : {"plain-columns", "fractal", "bunny"}) {
    for (const int view : {0, 12}) {
      results.frames.push_back(make_frame(scene, view));
      for (const char* mode : {"three-pass", "single-pass"}) {
        for (int tile = 2; tile <= 256; tile *= 2) {
          for (const char* cull : {"none", "zmax", "both"}) {
            add_counted(results, results.frames.back(), f, mode, tile, cull);
          }
        }
      }
      f += 1;
    }
  }
  PointRow& crashed = results.points.back();
  crashed.state = PointState::crashed;
  crashed.message = "ended by signal 11";
  crashed.metrics.clear();
  results.points_planned = static_cast<std::int64_t>(results.points.size());
  return results;
}

Results timed_results() {
  Results results;
  results.study.name = "sample-time";
  results.study.title = "The block in time, made up";
  results.study.measure = "cycles";
  results.study.axes = {"block.mode", "block.tile", "memory.dram.preset", "z_read.cache_bytes"};
  results.study.by = {"scene", "width"};
  results.study.metrics = {"cycles", "frames_per_second", "port_gb_per_second"};
  results.study.plots = {{"scatter", "Frames per second against traffic", "port_gb_per_second",
                          "frames_per_second", "memory.dram.preset"}};
  for (const int scale : {1, 2, 4}) {
    results.frames.push_back(make_frame("fractal", scale, 320 * scale, 240 * scale));
    FrameRow& frame = results.frames.back();
    frame.wedges = 50 * scale * scale * scale * scale;
    for (const char* mode : {"three-pass", "single-pass"}) {
      for (int tile = 4; tile <= 32; tile *= 2) {
        for (const char* preset : {"ddr4-2400", "lpddr5-6400"}) {
          for (std::int64_t cache = 2048; cache <= 32768; cache *= 4) {
            PointRow point = make_point(results, frame, "cycles");
            point.configuration["block.mode"] = std::string(mode);
            point.configuration["block.tile"] = std::int64_t{tile};
            point.configuration["memory.dram.preset"] = std::string(preset);
            point.configuration["memory.dram.banks"] = std::int64_t{preset[0] == 'd' ? 16 : 8};
            point.configuration["z_read.cache_bytes"] = cache;
            point.configuration["block.clock_mhz"] = std::int64_t{500};
            const double miss = 40.0 / std::sqrt(static_cast<double>(cache));
            const double cycles = 76800.0 * scale * scale * (1.0 + 0.02 * std::abs(tile - 8)) *
                                  (mode[0] == 's' ? 3.0 : 3.6) * (preset[0] == 'd' ? 1.3 : 1.0) *
                                  (1.0 + miss);
            Values& m = point.metrics;
            m["cycles"] = integer(cycles);
            m["frames_per_second"] = 5e8 / cycles;
            m["port_bytes"] = integer(2e6 * scale * scale * miss);
            m["port_gb_per_second"] = 2e6 * scale * scale * miss * 5e8 / cycles / 1e9;
            m["cache.z.hit_rate"] = 1.0 - miss;
            m["cache.li.hit_rate"] = 0.93 + 0.0005 * tile;
            m["bottleneck"] = std::string(preset[0] == 'd' ? "z_read" : "penumbra");
            m["mismatched"] = integer(0.0);
            double busy = 0.1;
            for (const char* unit : {"wedge_fetch", "wedge_setup", "tile_walk", "tile_cull",
                                     "z_read", "penumbra", "li_update"}) {
              const std::string name = unit;
              m["path.memory." + name] = integer(busy / 7.0 * cycles);
              m["path." + name] = integer(busy / 3.5 * cycles);
              m[name + ".busy_cycles"] = integer(busy * cycles);
              m[name + ".stalled_cycles"] = integer((0.9 - busy) * 0.6 * cycles);
              m[name + ".starved_cycles"] = integer((1.0 - busy - (0.9 - busy) * 0.6) * cycles);
              busy += preset[0] == 'd' ? 0.09 : 0.12;
            }
            results.points.push_back(std::move(point));
          }
        }
      }
    }
  }
  return results;
}

Results precision_results() {
  Results results;
  results.study.name = "sample-precision";
  results.study.title = "Widths of the fixed datapath, made up";
  results.study.measure = "count";
  results.study.axes = {"formats.plane", "formats.reciprocal"};
  results.study.metrics = {"max_error", "mismatched"};
  results.study.check_pixels = false;
  for (const int view : {0, 1, 2}) {
    results.frames.push_back(make_frame("columns", view));
    for (std::int64_t plane = 10; plane <= 18; plane += 2) {
      for (const std::int64_t reciprocal : {8, 12, 16}) {
        PointRow point = make_point(results, results.frames.back(), "count");
        point.configuration["formats.plane"] = plane;
        point.configuration["formats.reciprocal"] = reciprocal;
        const double error = std::exp2(-static_cast<double>(plane)) +
                             std::exp2(-1.5 * static_cast<double>(reciprocal));
        point.metrics["max_error"] = error * (view + 1);
        point.metrics["rms_error"] = error / 10;
        point.metrics["mismatched"] =
            integer(plane < 14 ? 100.0 * static_cast<double>(14 - plane) * (view + 1) : 0.0);
        point.metrics["accesses"] = integer(500000);
        results.points.push_back(std::move(point));
      }
    }
  }
  return results;
}

Results large_results(std::size_t points) {
  Results results = counted_results();
  const std::vector<PointRow> some = std::move(results.points);
  const std::size_t frames = (points + 47) / 48;
  results.study.name = "sample-large";
  results.frames.clear();
  results.points.clear();
  for (std::size_t f = 0; f < frames; ++f) {
    results.frames.push_back(make_frame(fmt::format("scene-{}", f % 7), static_cast<int>(f / 7)));
    for (std::size_t i = 0; i < 48 && results.points.size() < points; ++i) {
      PointRow point = some[i];
      point.frame = results.frames.back().label;
      point.key = fmt::format("{:032x}", 0x9e3779b97f4a7c15ULL * (results.points.size() + 1));
      for (int k = 0; k < 80; ++k)
        point.configuration[fmt::format("unit.key_{}", k)] = std::int64_t{k};
      for (int k = 0; k < 120; ++k) {
        point.metrics[fmt::format("unit.count_{}", k)] = static_cast<std::int64_t>(
            (f * 7919 + i * 104729 + static_cast<std::size_t>(k) * 1299709) % 1000003);
      }
      results.points.push_back(std::move(point));
    }
  }
  return results;
}

Results hostile_results() {
  Results results = counted_results();
  const std::string hostile =
      "</script><script>window.broken = 1</script><img src=x onerror=\"window.broken = 1\">&'";
  results.study.name = "sample-hostile";
  results.study.title = hostile;
  results.study.question = hostile;
  results.study.plots.front().title = hostile;
  for (FrameRow& frame : results.frames) {
    frame.scene += hostile;
    for (PointRow& point : results.points) {
      if (point.frame == frame.label) point.frame += hostile;
    }
    frame.label += hostile;
  }
  results.points.back().message = hostile;
  results.points.front().configuration["note" + hostile] = hostile;
  return results;
}

std::vector<page::HeatMap> sample_maps(const Results& results) {
  constexpr int kWidth = 60, kHeight = 40;
  std::vector<page::HeatMap> maps;
  for (const std::size_t frame : {0U, 2U}) {
    for (const char* mode : {"three-pass", "single-pass"}) {
      for (unsigned tile = 2; tile <= 256; tile *= 2) {
        for (const char* kind : {"z reads", "LI writes"}) {
          const bool reads = kind[0] == 'z';
          Image image(kWidth, kHeight, 1);
          for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
              const int step = reads ? static_cast<int>(std::min(tile, 40U)) : 1;
              const double dx = x / step * step - 30.0,
                           dy = y / step * step - 20.0 - static_cast<double>(frame);
              *image.pixel(x, y) = static_cast<float>(std::exp(-(dx * dx + dy * dy) / 200.0));
            }
          }
          const auto path = std::filesystem::temp_directory_path() /
                            fmt::format("wedgesim-sample-{}.png", getpid());
          write_image(path, image);
          const MappedFile file(path);
          maps.push_back({results.frames[frame].label, mode, tile, kind, std::string(file.text()),
                          9.0, reads ? 1000.0 * tile : 5e4, ""});
          std::filesystem::remove(path);
        }
      }
    }
  }
  return maps;
}

}  // namespace wedgesim::tests

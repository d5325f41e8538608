#include "reports/page/heat_maps.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/file.h"
#include "base/image.h"
#include "model/count/count.h"
#include "reports/page/chart.h"
#include "reports/page/names.h"
#include "reports/page/small_picture.h"
#include "reports/picture.h"
#include "reports/runner/frames.h"
#include "reports/runner/value.h"
#include "traces/reader.h"

namespace wedgesim::reports::page {
namespace {

constexpr std::size_t kMostFrames = 3;
constexpr std::size_t kMostPixels = 4U << 20U;  // of a frame that is counted again
constexpr int kMostWidth = 320;                 // of a picture in the page

model::CountConfig config_of(const Values& values) {
  const auto word = [&values](const char* key) { return to_text(find_value(values, key)); };
  model::CountConfig config;
  config.mode = model::parse<model::Mode>("block.mode", word("block.mode"));
  config.tile = model::parse_tile("block.tile", word("block.tile"));
  config.cull = model::parse<model::Cull>("block.cull", word("block.cull"));
  config.umbra_cull = model::parse<model::UmbraCull>("block.umbra_cull", word("block.umbra_cull"));
  config.accept = model::parse<model::Accept>("block.accept", word("block.accept"));
  config.share = model::parse<model::Share>("block.share", word("block.share"));
  config.z = model::parse<model::ZChoice>("block.z", word("block.z"));
  return config;
}

/// One kind of access of one configuration.
struct Counted {
  HeatMap map;
  std::vector<float> values;  // (height, width)
  Image small;
};

/// Draws one frame.
class FrameMaps {
 public:
  FrameMaps(const std::filesystem::path& folder, const std::string& label,
            std::vector<model::CountConfig> configs)
      : folder_(folder), label_(label), configs_(std::move(configs)) {}

  std::vector<HeatMap> draw() {
    const traces::TraceFile trace(trace_path(folder_, label_));
    width_ = static_cast<int>(trace.view().header.width);
    height_ = static_cast<int>(trace.view().header.height);
    model::CountOptions options;
    options.maps = true;
    for (const model::CountResult& result : model::count(trace.view(), configs_, options)) {
      add(result.config, "z reads", "z_reads", result.z_reads);
      add(result.config, "LI writes", "li_writes", result.li_writes);
    }
    scale();
    write();
    std::vector<HeatMap> maps;
    for (Counted& counted : counted_) maps.push_back(std::move(counted.map));
    return maps;
  }

 private:
  void add(const model::CountConfig& config, const std::string& kind, const char* stem,
           const std::vector<std::uint32_t>& counts) {
    Counted counted;
    counted.values.assign(counts.begin(), counts.end());
    counted.map.frame = label_;
    counted.map.mode = spelling(config.mode);
    counted.map.tile = config.tile;
    counted.map.kind = kind;
    for (const std::uint32_t count : counts) counted.map.total += count;
    // What no tile size changes is written once.
    for (const Counted& other : counted_) {
      if (other.map.kind == kind && other.map.mode == counted.map.mode &&
          other.values == counted.values) {
        counted.map.file = other.map.file;
      }
    }
    if (counted.map.file.empty()) {
      counted.map.file =
          fmt::format("maps/{}_{}_t{}_{}.png", label_, counted.map.mode, config.tile, stem);
    }
    Image image(width_, height_, 1);
    image.values = counted.values;
    counted.small = reduced(image, kMostWidth);
    counted_.push_back(std::move(counted));
  }

  // One scale for all pictures of a kind, so that the slider compares them.
  void scale() {
    std::map<std::string, float> most;
    for (const Counted& counted : counted_) {
      float& maximum = most.emplace(counted.map.kind, 1.0F).first->second;
      maximum = std::max(maximum, *std::ranges::max_element(counted.small.values));
    }
    for (Counted& counted : counted_) {
      const float maximum = most[counted.map.kind];
      counted.map.maximum = static_cast<double>(maximum);
      for (float& value : counted.small.values) value /= maximum;
    }
  }

  void write() {
    std::filesystem::create_directories(folder_ / "maps");
    std::set<std::string> files;
    std::vector<std::pair<const Counted*, bool>> work;  // is it the first of its file?
    for (const Counted& counted : counted_) {
      work.emplace_back(&counted, files.insert(counted.map.file).second);
    }
    tbb::parallel_for(std::size_t{0}, work.size(), [&](std::size_t i) {
      Counted& counted = counted_[i];
      const std::filesystem::path path = folder_ / counted.map.file;
      counted.map.png =
          png_of(counted.small, folder_ / "maps" / fmt::format("{}_{}.png", label_, i));
      if (!work[i].second) return;
      write_heat(path, counted.values, width_, height_, static_cast<float>(counted.map.maximum));
      write_heat(std::filesystem::path(path).replace_extension(".exr"), counted.values, width_,
                 height_, static_cast<float>(counted.map.maximum));
    });
  }

  const std::filesystem::path& folder_;
  const std::string& label_;
  std::vector<model::CountConfig> configs_;
  int width_ = 0, height_ = 0;
  std::vector<Counted> counted_;
};

double pixels_of(const FrameRow& frame) {
  return number_of(find_value(frame.parameters, "width")).value_or(0.0) *
         number_of(find_value(frame.parameters, "height")).value_or(0.0);
}

bool can_be_drawn(const FrameRow& frame, const std::filesystem::path& folder) {
  return frame.failure.empty() && pixels_of(frame) <= static_cast<double>(kMostPixels) &&
         std::filesystem::is_regular_file(trace_path(folder, frame.label));
}

// The largest frame of each scene, the first of equals.
std::vector<const FrameRow*> frames_to_draw(const Columns& columns,
                                            const std::filesystem::path& folder) {
  std::vector<const FrameRow*> frames;
  for (const FrameRow& frame : columns.results().frames) {
    if (!can_be_drawn(frame, folder)) continue;
    const auto known = std::ranges::find(frames, frame.scene, &FrameRow::scene);
    if (known == frames.end()) {
      if (frames.size() < kMostFrames) frames.push_back(&frame);
    } else if (pixels_of(frame) > pixels_of(**known)) {
      *known = &frame;
    }
  }
  return frames;
}

// Each mode and tile size once, as the charts by tile size hold the other settings.
std::vector<model::CountConfig> configs_of(const Columns& columns) {
  Chart chart;
  chart.x = columns.find("block.tile");
  chart.series = columns.find("block.mode");
  const Column* reads = columns.number("z_reads");
  if (chart.x == nullptr || chart.series == nullptr || reads == nullptr) return {};
  chart.measures = {{reads, ""}};
  const Held held = choose_held(columns, chart);
  std::vector<model::CountConfig> configs;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    const bool is_held = std::ranges::all_of(held, [i](const auto& hold) {
      return hold.first->kind != Column::Kind::setting || hold.first->values[i] == hold.second;
    });
    if (!is_held || !columns.done(i)) continue;
    const model::CountConfig config = config_of(columns.results().points[i].configuration);
    if (std::ranges::find(configs, config) == configs.end()) configs.push_back(config);
  }
  return configs;
}

}  // namespace

void add_heat_maps(const Columns& columns, const std::filesystem::path& folder, Page& page) {
  const std::vector<model::CountConfig> configs = configs_of(columns);
  if (configs.empty()) return;
  for (const FrameRow* drawn : frames_to_draw(columns, folder)) {
    const FrameRow& frame = *drawn;
    std::vector<HeatMap> maps = FrameMaps(folder, frame.label, configs).draw();
    std::ranges::move(maps, std::back_inserter(page.maps));
    const std::filesystem::path shaded = folder / (frame.label + "_shaded.png");
    if (!std::filesystem::is_regular_file(shaded)) continue;
    page.pictures.push_back({frame.label, png_of(reduced(read_image(shaded), kMostWidth),
                                                 folder / "maps" / (frame.label + ".png"))});
  }
}

}  // namespace wedgesim::reports::page

#include "functional/methods/render.h"

#include <array>

#include "base/error.h"
#include "base/file.h"
#include "model/count/count.h"
#include "reports/map_files.h"
#include "reports/maps.h"
#include "reports/picture.h"
#include "reports/runner/frames.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim::reports {
namespace {

// What the block's default configuration does with a frame, as pictures.
std::string draw(const std::string& prefix, const traces::TraceView& trace,
                 const functional::Scene* scene, const functional::Frame& frame) {
  constexpr model::DatapathKind kFormat = model::DatapathKind::exact;
  model::CountOptions options;
  options.maps = true;
  const auto pictured = model::count(trace, std::array{model::CountConfig{}}, options);
  const MapScales scales = write_maps(prefix, trace, pictured.front(), kFormat);
  if (scene != nullptr) {
    const Image shaded =
        functional::shade(*scene, frame.window, frame.depth, light_of(pictured.front(), kFormat));
    for (const char* kind : {".png", ".exr"}) write_colours(prefix + "_shaded" + kind, shaded);
  }
  return to_text(scales);
}

}  // namespace

std::filesystem::path trace_path(const std::filesystem::path& folder, const std::string& label) {
  return folder / (label + ".wtrace");
}

std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& folder,
                                                 const std::string& label) {
  const std::string prefix = (folder / label).string();
  std::vector<std::filesystem::path> files = map_files(prefix);
  for (const char* kind : {".png", ".exr"}) files.emplace_back(prefix + "_shaded" + kind);
  return files;
}

bool holds_trace(const std::filesystem::path& path, std::uint64_t checksum) {
  try {
    return traces::TraceFile(path).view().header.checksum == checksum;
  } catch (const InputError&) {
    return false;
  }
}

RenderedFrame render_frame(const FrameSpec& spec, const std::filesystem::path& folder,
                           bool pictures) {
  const std::filesystem::path path = trace_path(folder, spec.row.label);
  functional::Scene scene;
  functional::Frame frame;
  if (spec.is_trace) {
    write_file(path, MappedFile(spec.source).bytes());
  } else {
    scene = functional::load_scene(spec.source, spec.scene);
    traces::require_room(scene.place, scene.width, scene.height);
    frame = functional::make_frame(scene, spec.options);
    traces::write_trace(path, frame.trace);
    frame.trace = {};  // from here on the trace comes from its file alone
  }
  const traces::TraceFile trace(path);
  RenderedFrame rendered;
  rendered.checksum = trace.view().header.checksum;
  rendered.wedges = static_cast<std::int64_t>(trace.view().wedges.size());
  if (pictures) {
    rendered.pictures = draw((folder / spec.row.label).string(), trace.view(),
                             spec.is_trace ? nullptr : &scene, frame);
  }
  return rendered;
}

}  // namespace wedgesim::reports

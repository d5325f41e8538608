#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// A frame to be made: its row, without what only rendering tells, and what it is made from.
struct FrameSpec {
  FrameRow row;
  std::string source;  // a built-in scene, a scene file, or a trace
  bool is_trace = false;
  functional::SceneOptions scene;
  functional::FrameOptions options;
  std::vector<std::filesystem::path> files;  // that it is read from
};

/// What the command line may put in the place of a study's own frames.
struct FrameOverrides {
  std::vector<std::string> scenes;          // names or files
  std::optional<std::pair<int, int>> size;  // pixels
};

/// The frames of a table [frames], or of several: traces, and every combination of scenes and their
/// options.
/// docs/studies.md lists the keys.
/// \param file  the study's; relative paths start at its folder
/// \throws InputError at FILE:LINE, or of a scene or trace that is not there
std::vector<FrameSpec> read_frames(const toml::node& node, const std::string& file,
                                   const FrameOverrides& overrides);

/// What rendering tells.
struct RenderedFrame {
  std::uint64_t checksum = 0;
  std::int64_t wedges = 0;
  std::string pictures;
};

/// The name of a frame's trace in the folder of a study, and of its pictures.
std::filesystem::path trace_path(const std::filesystem::path& folder, const std::string& label);
std::vector<std::filesystem::path> picture_paths(const std::filesystem::path& folder,
                                                 const std::string& label);

/// Is the file a sound trace with this checksum? Reads all of it: a damaged one is none.
bool holds_trace(const std::filesystem::path& path, std::uint64_t checksum);

/// Renders a frame, or copies its trace, into trace_path.
/// \param pictures  also draw picture_paths, of the block's default configuration
/// \throws InputError if the scene or trace is wrong, or a file cannot be written
RenderedFrame render_frame(const FrameSpec& frame, const std::filesystem::path& folder,
                           bool pictures);

}  // namespace wedgesim::reports

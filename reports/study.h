#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/count/count.h"
#include "reports/json.h"
#include "reports/maps.h"

namespace wedgesim::reports {

/// A sweep: every configuration on the first frame of every scene.
struct Study {
  std::string name;
  std::vector<std::string> scenes;          // built-in names or files
  std::optional<std::pair<int, int>> size;  // pixels; none: the scenes' own
  std::vector<model::CountConfig> configs;
  model::CountConfig pictured;  // of the pictures and maps
};

/// The studies inside the program.
/// \throws InputError naming all of them
Study built_in_study(std::string_view name);

/// What a study found on one scene.
struct SceneResults {
  std::string scene;
  std::string failure;  // why the scene could not be loaded; then nothing else is set
  TraceInfo trace;
  std::vector<model::CountResult> results;  // one a configuration, in the study's order
  MapScales scales;
  double seconds = 0.0;
};

struct StudyResults {
  Study study;
  std::vector<SceneResults> scenes;
};

/// Runs a study, one scene after another on all cores. Writes to `folder`, for each scene,
/// SCENE.wtrace, SCENE_shaded and the maps (maps.h) as .png and .exr; at the end results.csv,
/// results.json and summary.txt. A scene that cannot be loaded is left out and says why.
/// \param progress  told what is being done
/// \throws InputError before any work if a scene is not there, if two have the same name, or if one
///         is read from a file that would be written; later if a file cannot be written
StudyResults run_study(const Study& study, const std::filesystem::path& folder,
                       const std::function<void(std::string_view)>& progress);

/// Every pixel of every scene held (count_text.h).
bool held(const StudyResults& results);

}  // namespace wedgesim::reports

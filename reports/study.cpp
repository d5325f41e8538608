#include "reports/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "functional/methods/frame.h"
#include "functional/methods/render.h"
#include "functional/scene/scene_file.h"
#include "reports/count_text.h"
#include "reports/map_files.h"
#include "reports/picture.h"
#include "reports/study_files.h"
#include "reports/study_text.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim::reports {
namespace {

constexpr model::LiFormat kFormat = model::LiFormat::exact;
constexpr const char* kCsv = "results.csv";
constexpr const char* kJson = "results.json";
constexpr const char* kText = "summary.txt";

class SceneRun {
 public:
  SceneRun(const Study& study, const std::filesystem::path& folder,
           const std::function<void(std::string_view)>& progress)
      : study_(study), folder_(folder), progress_(progress) {}

  SceneResults run(const std::string& name) {
    const auto start = std::chrono::steady_clock::now();
    SceneResults found;
    found.scene = name;
    functional::Scene scene;
    functional::Frame frame;
    try {
      say(name, "rendering");
      functional::SceneOptions options;
      options.size = study_.size;
      scene = functional::load_scene(name, options);
      traces::require_room(scene.place, scene.width, scene.height);
      frame = functional::make_frame(scene);
    } catch (const InputError& error) {
      found.failure = error.what();
      return found;
    }
    const std::string prefix = (folder_ / scene.name).string();
    traces::write_trace(prefix + ".wtrace", frame.trace);
    frame.trace = {};  // from here on the trace comes from its file alone
    const traces::TraceFile trace(prefix + ".wtrace");
    found.trace = info_of(trace.view());
    say(name, fmt::format("counting in {} configurations", study_.configs.size()));
    found.results = model::count(trace.view(), study_.configs);
    say(name, "drawing");
    draw(prefix, scene, frame, trace.view(), found);
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return found;
  }

 private:
  void say(const std::string& scene, const std::string& what) const {
    progress_(fmt::format("{}: {}: {}", study_.name, scene, what));
  }

  void draw(const std::string& prefix, const functional::Scene& scene,
            const functional::Frame& frame, const traces::TraceView& trace,
            SceneResults& found) const {
    model::CountOptions options;
    options.maps = true;
    const auto pictured = model::count(trace, std::array{study_.pictured}, options);
    found.scales = write_maps(prefix, trace, pictured.front(), kFormat);
    const Image shaded =
        functional::shade(scene, frame.window, frame.depth, light_of(pictured.front(), kFormat));
    for (const char* kind : {".png", ".exr"}) write_colours(prefix + "_shaded" + kind, shaded);
  }

  const Study& study_;
  const std::filesystem::path& folder_;
  const std::function<void(std::string_view)>& progress_;
};

// What a study writes into its folder for one scene.
std::vector<std::filesystem::path> scene_files(const std::string& prefix) {
  std::vector<std::filesystem::path> files = map_files(prefix);
  for (const char* rest : {".wtrace", "_shaded.png", "_shaded.exr"})
    files.emplace_back(prefix + rest);
  return files;
}

void check_scenes(const Study& study, const std::filesystem::path& folder) {
  std::map<std::string, std::string> scenes;  // by name
  std::vector<std::filesystem::path> outputs{folder, folder / kCsv, folder / kJson, folder / kText};
  for (const std::string& scene : study.scenes) {
    const std::string name = functional::scene_name(scene);
    const auto [first, is_new] = scenes.try_emplace(name, scene);
    if (!is_new) {
      throw InputError(scene, fmt::format("writes the same files as {}", first->second),
                       "scenes of different names");
    }
    std::ranges::move(scene_files((folder / name).string()), std::back_inserter(outputs));
  }
  const std::vector<std::filesystem::path> inputs(study.scenes.begin(), study.scenes.end());
  for (const std::filesystem::path& output : outputs) require_not_read(output, inputs);
}

}  // namespace

StudyResults run_study(const Study& study, const std::filesystem::path& folder,
                       const std::function<void(std::string_view)>& progress) {
  check_scenes(study, folder);
  StudyResults results;
  results.study = study;
  SceneRun scene_run(study, folder, progress);
  for (const std::string& scene : study.scenes) results.scenes.push_back(scene_run.run(scene));
  write_file(folder / kCsv, study_csv(results));
  write_json(folder / kJson, study_json(results));
  write_file(folder / kText, study_text(results));
  return results;
}

bool held(const StudyResults& results) {
  return std::ranges::all_of(results.scenes,
                             [](const SceneResults& scene) { return held(scene.results); });
}

}  // namespace wedgesim::reports

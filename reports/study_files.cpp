#include "reports/study_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace wedgesim::reports {
namespace {

// As RFC 4180 has it: quoted where it must be, quotes doubled.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

void append_line(std::string& text, const SceneResults& scene, const model::CountResult& result) {
  const model::CountConfig& config = result.config;
  text +=
      fmt::format("{},{:016x},{},{},{},{},{},{},{},{}", csv_field(scene.trace.name),
                  scene.trace.checksum, spelling(config.mode), config.tile, spelling(config.cull),
                  spelling(config.umbra_cull), spelling(config.accept), spelling(config.share),
                  result.z == model::ZMethod::pass ? "pass" : "fail", spelling(config.tile_build));
  for (const Counter* counter : result.counters->counters()) {
    text += fmt::format(",{}", counter->value());
  }
  text += fmt::format(",{},{},{},{},{},{}\n", result.pixels.compared, result.pixels.max_error,
                      result.pixels.rms_error, result.pixels.mismatched, result.pixels.tolerance,
                      result.wrong_contributions);
}

Json scene_json(const SceneResults& scene) {
  if (!scene.failure.empty()) return {{"scene", scene.scene}, {"failure", scene.failure}};
  Json configs = Json::array();
  for (const model::CountResult& result : scene.results) {
    configs.push_back(to_json(result, model::LiFormat::exact));
  }
  return {{"scene", scene.scene},
          {"trace", to_json(scene.trace)},
          {"configs", std::move(configs)},
          {"timing", {{"seconds", scene.seconds}}}};
}

}  // namespace

std::string study_csv(const StudyResults& results) {
  std::string text = "trace,checksum,mode,tile,cull,umbra_cull,accept,share,z,tile_build";
  const model::Counters registry;
  for (const Counter* counter : registry.counters()) {
    text += fmt::format(",{}", counter->name());
  }
  text += ",compared,max_error,rms_error,mismatched,tolerance,wrong_contributions\n";
  for (const SceneResults& scene : results.scenes) {
    for (const model::CountResult& result : scene.results) append_line(text, scene, result);
  }
  return text;
}

Json study_json(const StudyResults& results) {
  Json scenes = Json::array();
  for (const SceneResults& scene : results.scenes) scenes.push_back(scene_json(scene));
  return {{"schema", "wedgesim.study/1"},
          {"study", results.study.name},
          {"configuration", to_json(results.study.configs, model::LiFormat::exact)},
          {"scenes", std::move(scenes)}};
}

}  // namespace wedgesim::reports

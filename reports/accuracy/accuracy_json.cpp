#include "reports/accuracy/accuracy_json.h"

#include <cmath>

#include "reports/accuracy/equal_error.h"
#include "reports/accuracy/published.h"

namespace wedgesim::reports::accuracy {
namespace {

Json to_json(const Errors& errors) {
  const double psnr = errors.psnr_db();
  return {{"values", errors.values},
          {"rmse", errors.rmse},
          {"max_error", errors.largest},
          {"psnr_db", std::isfinite(psnr) ? Json(psnr) : Json(nullptr)},
          {"beyond_1_255", errors.beyond_1_255},
          {"beyond_16_255", errors.beyond_16_255},
          {"wrong_kind", errors.wrong_kind}};
}

Json to_json(const functional::MethodAccesses& accesses) {
  return {{"z_reads", accesses.z_reads},     {"li_reads", accesses.li_reads},
          {"li_writes", accesses.li_writes}, {"sums", accesses.sums},
          {"map_reads", accesses.map_reads}, {"map_writes", accesses.map_writes},
          {"bytes", accesses.bytes}};
}

Json to_json(const Timing& timing) {
  Json stages = Json::object();
  for (const functional::Stage& stage : timing.stages) stages[stage.name] = 1e3 * stage.seconds;
  return {{"one_thread_ms", 1e3 * timing.one_thread},
          {"all_threads_ms", 1e3 * timing.all_threads},
          {"stages_ms", stages},
          {"peak_bytes", timing.peak_bytes}};
}

Json to_json(const Measured& measured, const SceneResult& scene) {
  const functional::Method& method = *measured.choice.method;
  Json json{{"choice", measured.choice.text},
            {"method", method.name},
            {"source", method.source},
            {"artifacts", Json::array()},
            {"refused", measured.refused ? Json(*measured.refused) : Json(nullptr)}};
  for (const std::string_view artifact : method.artifacts) json["artifacts"].push_back(artifact);
  if (measured.refused) return json;
  for (const Region region : kRegions) {
    json["errors"][std::string(name_of(region))] = to_json(measured.on(region));
  }
  json["accesses"] = to_json(measured.accesses);
  json["timing"] = to_json(measured.timing);
  json["timing"]["raytraced_ms"] = nullptr;
  json["timing"]["raytraced_extrapolated"] = nullptr;
  if (const auto rays = ray_traced_like(scene.methods, measured)) {
    json["timing"]["raytraced_ms"] = 1e3 * rays->seconds;
    json["timing"]["raytraced_extrapolated"] = rays->extrapolated;
  }
  return json;
}

std::string_view name_of(functional::LightShape shape) {
  switch (shape) {
    case functional::LightShape::point:
      return "point";
    case functional::LightShape::rectangle:
      return "rectangle";
    case functional::LightShape::sphere:
      return "sphere";
  }
  return "";
}

Json to_json(const SceneResult& result, const Wish* wish) {
  const functional::Scene& scene = result.scene;
  Json json{{"name", scene.name},
            {"frame", scene.frame},
            {"width", scene.width},
            {"height", scene.height},
            {"triangles", result.triangles},
            {"light", name_of(scene.light.shape)},
            {"lights", result.reference.size()},
            {"methods", Json::array()}};
  for (const Measured& measured : result.methods) {
    json["methods"].push_back(to_json(measured, result));
  }
  Json front = Json::array();
  for (const std::size_t i : pareto_front(result.methods)) {
    front.push_back(result.methods[i].choice.text);
  }
  json["timing"] = {{"reference_seconds", result.reference_seconds}, {"pareto_front", front}};
  if (wish != nullptr) {
    const Recommendation found = recommend(result.methods, *wish);
    json["timing"]["recommended"] = {
        {"choice", found.method ? Json(result.methods[*found.method].choice.text) : Json(nullptr)},
        {"why", found.why}};
  }
  return json;
}

}  // namespace

Json accuracy_json(const MeasureOptions& options, const std::vector<SceneResult>& scenes,
                   const Wish* wish, std::span<const ShownArtifact> artifacts) {
  Json json{{"schema", "wedgesim.accuracy/1"},
            {"configuration", {{"rays", options.rays}, {"repetitions", options.repetitions}}},
            {"scenes", Json::array()}};
  for (const SceneResult& scene : scenes) json["scenes"].push_back(to_json(scene, wish));
  json["artifacts"] = artifacts_json(artifacts);
  json["published"] = published_json(scenes);
  return json;
}

}  // namespace wedgesim::reports::accuracy

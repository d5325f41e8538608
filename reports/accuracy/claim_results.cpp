#include "reports/accuracy/claim_results.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "reports/runner/value.h"

namespace wedgesim::reports::accuracy {
namespace {

// How many silhouette edges meet at a vertex of a scene, counted from the triangles: an edge that
// is in front of one of its triangles alone.
struct Degrees {
  std::int64_t odd = 0;      // vertices with an odd number (Paper V: none)
  std::int64_t largest = 0;  // number at any vertex
};

Degrees silhouette_degrees(const functional::Scene& scene) {
  Degrees degrees;
  for (const functional::Object& object : scene.objects) {
    if (!object.casts) continue;
    const functional::Mesh& mesh = object.mesh;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> lit_sides;
    for (const auto& t : mesh.triangles) {
      const glm::dvec3& a = mesh.positions[t[0]];
      const glm::dvec3 normal = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
      const int lit = glm::dot(normal, scene.light.centre - a) > 0.0 ? 1 : 0;
      for (std::size_t i = 0; i < 3; ++i) lit_sides[std::minmax(t[i], t[(i + 1) % 3])] += lit;
    }
    std::map<std::uint32_t, std::int64_t> at;
    for (const auto& [edge, lit] : lit_sides) {
      if (lit % 2 == 0) continue;
      ++at[edge.first];
      ++at[edge.second];
    }
    for (const auto& [vertex, count] : at) {
      degrees.odd += count % 2;
      degrees.largest = std::max(degrees.largest, count);
    }
  }
  return degrees;
}

Values metrics_of(const Measured& measured, const Degrees& degrees) {
  const functional::MethodAccesses& accesses = measured.accesses;
  const Timing& timing = measured.timing;
  const auto count = [](std::uint64_t words) { return static_cast<std::int64_t>(words); };
  Values metrics{{"rmse", measured.on(Region::receivers).rmse},
                 {"rmse_casters", measured.on(Region::casters).rmse},
                 {"rmse_penumbra", measured.on(Region::penumbra).rmse},
                 {"max_error", measured.on(Region::receivers).largest},
                 {"beyond_1_255", measured.on(Region::receivers).beyond_1_255},
                 {"beyond_16_255", measured.on(Region::receivers).beyond_16_255},
                 {"wrong_kind", measured.on(Region::receivers).wrong_kind},
                 {"milliseconds", 1e3 * timing.all_threads},
                 {"milliseconds_one_thread", 1e3 * timing.one_thread},
                 {"frames_per_second", 1.0 / timing.all_threads},
                 {"frames_per_second_one_thread", 1.0 / timing.one_thread},
                 {"z_reads", count(accesses.z_reads)},
                 {"li_reads", count(accesses.li_reads)},
                 {"li_writes", count(accesses.li_writes)},
                 {"map_reads", count(accesses.map_reads)},
                 {"map_writes", count(accesses.map_writes)},
                 {"bytes", count(accesses.bytes)},
                 {"bytes_without_sums",
                  count(accesses.bytes - accesses.sums * functional::MethodAccesses::kSumBytes)},
                 {"odd_degree_vertices", degrees.odd},
                 {"largest_degree", degrees.largest}};
  for (const functional::Stage& stage : timing.stages) {
    metrics[stage.name + "_milliseconds"] = 1e3 * stage.seconds;
  }
  return metrics;
}

// What a side of a measurement asks for on a scene.
void add_side(const Values& side, const std::string& scene, ClaimWork& work) {
  const auto method = side.find("method");
  if (method == side.end()) return;
  const auto named = side.find("scene");
  work[named == side.end() ? scene : to_text(named->second)].insert(to_text(method->second));
}

}  // namespace

ClaimWork work_of(const ClaimFile& file) {
  ClaimWork work;
  for (const Claim& claim : file.claims) {
    for (const Measurement& measurement : claim.measured) {
      for (const std::string& scene : claim.scenes) {
        add_side(measurement.from, scene, work);
        add_side(measurement.to, scene, work);
      }
    }
  }
  return work;
}

Results claim_results(const std::vector<SceneResult>& scenes) {
  Results results;
  for (const SceneResult& scene : scenes) {
    FrameRow frame;
    frame.label = frame.scene = scene.scene.name;
    results.frames.push_back(frame);
    const Degrees degrees = silhouette_degrees(scene.scene);
    for (const Measured& measured : scene.methods) {
      if (measured.refused) continue;
      PointRow point;
      point.frame = frame.label;
      point.measure = "accuracy";
      point.configuration = {{"method", measured.choice.text}};
      point.metrics = metrics_of(measured, degrees);
      results.points.push_back(std::move(point));
    }
  }
  return results;
}

}  // namespace wedgesim::reports::accuracy

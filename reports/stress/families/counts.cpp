#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <string>
#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

// The number that a difficulty counts.
int whole(double difficulty, int least) {
  return std::max(least, static_cast<int>(std::lround(difficulty)));
}

// Plates one below the other, all over one shadow.
Case overlap(std::uint64_t seed, double volumes) {
  Stage stage = make_stage(seed, kLightRadius);
  const int count = whole(volumes, 1);
  const double turn = stage.random.between(0.0, 1.5);
  for (int i = 0; i < count; ++i) {
    const double depth = kDepth - 2.0 * i / count;
    const double across = kAcross * stage.random.between(0.9, 1.1);
    const std::vector<glm::dvec3> loop = below(
        stage.light(), ring(stage.aim, across, 4, turn + stage.random.between(-0.1, 0.1)), depth);
    add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop),
               "plate-" + std::to_string(i));
  }
  // Fewer pixels where each costs more.
  const int scale = count > 500 ? 4 : (count > 50 ? 2 : 1);
  stage.result.scene.width /= scale;
  stage.result.scene.height /= scale;
  return std::move(stage.result);
}

// A round plate so small against the light that most pixels are in the wedges of all its edges.
Case many_edges(std::uint64_t seed, double edges) {
  constexpr double kRound = 0.08;
  constexpr double kHalfWay = 4.0;
  const int count = whole(edges, 3);
  Stage stage = make_stage(seed, 2.0);
  const std::vector<glm::dvec3> loop = below(
      stage.light(), ring(stage.aim, kRound, count, stage.random.between(0.0, 1.5)), kHalfWay);
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  stage.camera().field_of_view_degrees = 17.0;
  // Fewer pixels where each costs more.
  functional::Scene& scene = stage.result.scene;
  const int scale = count > 20000 ? 8 : (count > 2000 ? 4 : (count > 200 ? 2 : 1));
  scene.width /= scale;
  scene.height /= scale;
  return std::move(stage.result);
}

Case many_edges_wide(std::uint64_t seed, double edges) {
  Case result = many_edges(seed, edges);
  result.formats.li.fraction_bits = 20;
  return result;
}

// Two apexes over a ring of waves, seen by the light along the ring: as it goes round the apex, the
// fan of triangles turns towards the light and away again as often as the degree says.
Case vertex_degree(std::uint64_t seed, double degree) {
  Stage stage = make_stage(seed, kLightRadius);
  const int waves = whole(0.5 * degree, 1) + 1;
  const int count = 4 * waves;
  const glm::dvec3 apex = below(stage.light(), stage.aim, 4.5);
  const glm::dvec3 up = glm::normalize(stage.light().centre - apex);
  const double around = stage.random.between(0.0, 6.28);
  const glm::dvec3 side =
      glm::normalize(glm::cross(up, glm::dvec3(std::cos(around), 0.0, std::sin(around))));
  const glm::dvec3 axis = glm::cross(side, up);
  const double phase = stage.random.between(-0.05, 0.05);
  functional::Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const double angle = glm::two_pi<double>() * i / count + phase;
    mesh.positions.push_back(apex + 1.3 * (std::cos(angle) * up + std::sin(angle) * side) +
                             0.5 * std::cos(waves * angle) * axis);
  }
  mesh.positions.push_back(apex);
  mesh.positions.push_back(apex - 1.2 * axis);
  const auto n = static_cast<std::uint32_t>(count);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({n, next, i});
    mesh.triangles.push_back({n + 1, i, next});
  }
  add_caster(stage.result, std::move(mesh));
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> count_families() {
  const std::vector<double> edges{4, 12, 48, 100, 1e3, 1e4, 1e5};
  return {
      {"overlap",
       "volumes that hold a point",
       "",
       {1, 2, 5, 10, 15, 16, 30, 100, 300, 1000},
       {15.0, 1000.0},
       overlap,
       false,
       1.0},
      {"many-edges",
       "edges whose wedges hold a point",
       "",
       edges,
       {48.0, 1e5},
       many_edges,
       false,
       1.0},
      {"many-edges-wide",
       "edges whose wedges hold a point, 20 fraction bits of LI",
       "",
       edges,
       {1e4, {}},
       many_edges_wide,
       false,
       1.0},
      {"vertex-degree",
       "degree of a vertex in the silhouette",
       "",
       {2, 4, 6, 8},
       {8.0, 8.0},
       vertex_degree,
       false,
       2.0},
  };
}

}  // namespace wedgesim::reports::stress

// Silhouettes of a mesh with its edges known, on one thread and on two: the bar is 10 ms for
// 270,000 triangles on two.
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include "functional/geometry/silhouette.h"
#include "functional/scene/mesh_edges.h"
#include "functional/scene/primitives.h"

namespace wedgesim::bench {
namespace {

using namespace functional;  // NOLINT: the vocabulary of the meshes

void silhouette_of_torus(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(0));
  const int segments = static_cast<int>(state.range(1));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Mesh mesh = make_torus(2.0, 0.7, segments, segments);
  mesh.edges = mesh_edges(mesh);
  std::size_t edges = 0;
  for (auto _ : state) {
    const Silhouette silhouette = find_silhouette(mesh, {3.0, 9.0, 1.0});
    edges = 0;
    for (const auto& loop : silhouette.loops) edges += loop.size();
    benchmark::DoNotOptimize(edges);
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["silhouette_edges"] = static_cast<double>(edges);
}
BENCHMARK(silhouette_of_torus)
    ->ArgsProduct({{1, 2}, {116, 367}})
    ->ArgNames({"threads", "segments"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace wedgesim::bench

#include "functional/geometry/rings.h"

#include <algorithm>

namespace wedgesim::functional {
namespace {

void find_points(Rings& rings) {
  std::vector<int> degree(rings.vertices.size(), 0);
  rings.points.assign(rings.vertices.size(), {rings.samples, 1, false});
  for (const Rings::Edge& edge : rings.edges) {
    const auto [outside, inside] = std::minmax(edge.below, edge.above);
    for (const std::uint32_t v : {edge.begin, edge.end}) {
      Rings::Point& point = rings.points[v];
      point.lowest = std::min(point.lowest, outside + 1);
      point.highest = std::max(point.highest, inside);
      ++degree[v];
    }
  }
  for (std::size_t v = 0; v < degree.size(); ++v) {
    rings.points[v].crossing = degree[v] > 2 && rings.points[v].lowest < rings.points[v].highest;
  }
}

void halve_edges_between_crossings(Rings& rings) {
  const std::size_t edges = rings.edges.size();
  for (std::size_t i = 0; i < edges; ++i) {
    const Rings::Edge edge = rings.edges[i];
    const auto [outside, inside] = std::minmax(edge.below, edge.above);
    if (outside > 0 && inside < rings.samples) continue;
    if (!rings.points[edge.begin].crossing || !rings.points[edge.end].crossing) continue;
    const GridPoint& a = rings.vertices[edge.begin];
    const GridPoint& b = rings.vertices[edge.end];
    const auto middle = static_cast<std::uint32_t>(rings.vertices.size());
    rings.vertices.push_back({a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2});
    rings.points.push_back({outside + 1, inside, false});
    rings.edges[i].end = middle;
    rings.edges.push_back({middle, edge.end, edge.below, edge.above});
  }
}

}  // namespace

Rings merge_silhouettes(std::span<const std::vector<GridSegment>> silhouettes) {
  std::vector<GridSegment> segments;
  for (const auto& outline : silhouettes) {
    segments.insert(segments.end(), outline.begin(), outline.end());
  }
  Arrangement arrangement = arrange(segments);
  Rings rings;
  rings.samples = static_cast<int>(silhouettes.size());
  Sweep sweep = sweep_line(arrangement, rings.samples);
  for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
    const auto& edge = arrangement.edges[i];
    rings.edges.push_back({edge.begin, edge.end, sweep.below[i], sweep.below[i] + edge.rise});
  }
  rings.vertices = std::move(arrangement.vertices);
  rings.bridges = std::move(sweep.bridges);
  rings.umbra = std::move(sweep.trapezoids);
  find_points(rings);
  halve_edges_between_crossings(rings);
  return rings;
}

double intensity(const Rings& rings, std::uint32_t vertex, int count) {
  if (rings.samples == 1) return 1.0;
  const Rings::Point& point = rings.points[vertex];
  const double steps = rings.samples - 1;
  if (point.crossing) {
    return (std::clamp(count, point.lowest, point.highest - 1) - 0.5) / steps;
  }
  return ((count < point.lowest ? point.lowest : point.highest) - 1) / steps;
}

}  // namespace wedgesim::functional

#include "functional/geometry/ring_map.h"

#include <algorithm>

namespace wedgesim::functional {
namespace {

// Of a bridge until the area round it is walked: the counts on both its sides are that area's.
constexpr int kUnknown = -1;

}  // namespace

RingMap::RingMap(const Rings& rings) : edges_(rings.edges) {
  for (const auto& [a, b] : rings.bridges) edges_.push_back({a, b, kUnknown, kUnknown});
  next_.resize(half_edges());
  std::vector<std::uint32_t> out(half_edges());
  std::vector<std::uint32_t> first(rings.vertices.size() + 1, 0);
  for (std::uint32_t h = 0; h < half_edges(); ++h) ++first[begin(h) + 1];
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t h = 0; h < half_edges(); ++h) out[fill[begin(h)]++] = h;
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const auto low = out.begin() + first[v];
    const auto high = out.begin() + first[v + 1];
    const GridPoint& p = rings.vertices[v];
    const auto point = [&](std::uint32_t h) { return rings.vertices[end(h)]; };
    // Counter-clockwise: to the right and straight up, then to the left and straight down.
    const auto middle = std::partition(low, high, [&](std::uint32_t h) { return p < point(h); });
    const auto turns = [&](std::uint32_t g, std::uint32_t h) {
      return turn(p, point(g), point(h)) > 0;
    };
    std::sort(low, middle, turns);
    std::sort(middle, high, turns);
    // Who arrives goes on along the next clockwise: what is on the left stays there.
    for (auto h = low; h != high; ++h) next_[*h ^ 1U] = h == low ? *(high - 1) : *(h - 1);
  }
  for (auto h = static_cast<std::uint32_t>(2 * rings.edges.size()); h < half_edges(); ++h) {
    std::uint32_t around = h;
    while (left(around) == kUnknown) around = next(around);
    Rings::Edge& edge = edges_[h / 2];
    (h % 2 == 0 ? edge.above : edge.below) = left(around);
  }
}

}  // namespace wedgesim::functional

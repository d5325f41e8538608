#pragma once

#include <cstdint>
#include <vector>

#include "functional/geometry/rings.h"

namespace wedgesim::functional {

/// Rings as a map: walks round the areas between them. Half-edge 2e runs along edge e, 2e + 1 back;
/// bridges follow the edges. The area on its left belongs to a half-edge.
class RingMap {
 public:
  explicit RingMap(const Rings& rings);

  std::size_t half_edges() const { return 2 * edges_.size(); }
  std::uint32_t begin(std::uint32_t half) const {
    const Rings::Edge& edge = edges_[half / 2];
    return half % 2 == 0 ? edge.begin : edge.end;
  }
  std::uint32_t end(std::uint32_t half) const { return begin(half ^ 1U); }
  /// Samples hidden on the left, and on the right.
  int left(std::uint32_t half) const {
    const Rings::Edge& edge = edges_[half / 2];
    return half % 2 == 0 ? edge.above : edge.below;
  }
  int right(std::uint32_t half) const { return left(half ^ 1U); }
  /// The half-edge that goes on round the same area.
  std::uint32_t next(std::uint32_t half) const { return next_[half]; }

 private:
  std::vector<Rings::Edge> edges_;
  std::vector<std::uint32_t> next_;
};

}  // namespace wedgesim::functional

#include "functional/geometry/ring_strips.h"

#include <tbb/parallel_for.h>

#include "base/check.h"
#include "functional/geometry/cell_grid.h"
#include "functional/geometry/ring_map.h"

namespace wedgesim::functional {
namespace {

// Finds out whether triangles are empty.
class VertexIndex {
 public:
  explicit VertexIndex(const std::vector<GridPoint>& vertices)
      : vertices_(vertices), grid_(vertices, vertices.size()), in_(grid_, vertices) {}

  const GridPoint& operator[](std::uint32_t v) const { return vertices_[v]; }

  /// Counter-clockwise, and no vertex in it or on it but its corners.
  bool is_clear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const GridPoint& p = vertices_[a];
    const GridPoint& q = vertices_[b];
    const GridPoint& r = vertices_[c];
    if (turn(p, q, r) <= 0) return false;
    return !grid_.any_cell({p, q, r}, [&](std::uint32_t cell) {
      for (const std::uint32_t v : in_[cell]) {
        const GridPoint& s = vertices_[v];
        if (v != a && v != b && v != c && turn(p, q, s) >= 0 && turn(q, r, s) >= 0 &&
            turn(r, p, s) >= 0) {
          return true;
        }
      }
      return false;
    });
  }

 private:
  const std::vector<GridPoint>& vertices_;
  CellGrid grid_;
  CellLists in_;
};

// Fills one area of the penumbra, cutting corner after corner off its outline.
class StripFiller {
 public:
  StripFiller(const Rings& rings, const RingMap& map, const VertexIndex& vertices,
              std::uint32_t first)
      : rings_(rings), vertices_(vertices), hidden_(map.left(first)) {
    std::uint32_t half = first;
    do {
      const auto here = static_cast<std::uint32_t>(nodes_.size());
      const int right = map.right(half);
      nodes_.push_back({map.begin(half), here - 1, here + 1,
                        right < hidden_   ? Border::outer
                        : right > hidden_ ? Border::inner
                                          : Border::bridge});
      half = map.next(half);
    } while (half != first);
    left_ = nodes_.size();
    nodes_.front().previous = static_cast<std::uint32_t>(left_ - 1);
    nodes_.back().next = 0;
  }

  void run(std::vector<ShadedTriangle>& triangles) {
    triangles_ = &triangles;
    std::uint32_t a = begin_walk();
    while (left_ > 3) {
      const std::uint32_t corner = choose(a);
      if (corner == a) a = nodes_[a].next;
      cut(corner);
    }
    emit(a);
  }

 private:
  enum class Border : std::uint8_t { outer, inner, bridge };
  struct Node {
    std::uint32_t vertex, previous, next;
    Border border;  // from here to the next
  };

  const GridPoint& point(std::uint32_t node) const { return vertices_[nodes_[node].vertex]; }
  bool can_cut(std::uint32_t node) const {
    return vertices_.is_clear(nodes_[nodes_[node].previous].vertex, nodes_[node].vertex,
                              nodes_[nodes_[node].next].vertex);
  }

  // The node at whose corner the walk stands: it and its predecessor lie on two rings.
  std::uint32_t begin_walk() {
    std::uint32_t start = 0;
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const Node& node = nodes_[i];
      const Border before = nodes_[node.previous].border;
      if (before == Border::bridge) start = i;
      if (left_ > 3 && before != node.border && before != Border::bridge &&
          node.border != Border::bridge && can_cut(i)) {
        start = node.next;
        cut(i);
        break;
      }
    }
    return start;
  }

  // The corner to cut next: at one end of the line that the walk stands at, the one that gives the
  // shorter new line; else the nearest along the rings. There always is one: an area with one
  // outline and no vertex inside has a triangulation, and one triangle of it is a corner.
  std::uint32_t choose(std::uint32_t a) const {
    const std::uint32_t b = nodes_[a].previous;
    const bool a_first = squared_distance(point(b), point(nodes_[a].next)) <=
                         squared_distance(point(a), point(nodes_[b].previous));
    if (can_cut(a_first ? a : b)) return a_first ? a : b;
    if (can_cut(a_first ? b : a)) return a_first ? b : a;
    std::uint32_t x = a;
    std::uint32_t y = b;
    for (std::size_t i = 2;; i += 2) {
      CHECK_LT(i, left_);
      x = nodes_[x].next;
      y = nodes_[y].previous;
      if (can_cut(x)) return x;
      if (can_cut(y)) return y;
    }
  }

  void cut(std::uint32_t node) {
    emit(node);
    const Node& n = nodes_[node];
    nodes_[n.previous].next = n.next;
    nodes_[n.next].previous = n.previous;
    --left_;
  }

  void emit(std::uint32_t node) {
    ShadedTriangle triangle;
    triangle.hidden = hidden_;
    triangle.corners = {nodes_[nodes_[node].previous].vertex, nodes_[node].vertex,
                        nodes_[nodes_[node].next].vertex};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.intensity[i] =
          static_cast<float>(functional::intensity(rings_, triangle.corners[i], hidden_));
    }
    triangles_->push_back(triangle);
  }

  const Rings& rings_;
  const VertexIndex& vertices_;
  int hidden_;
  std::vector<Node> nodes_;
  std::size_t left_ = 0;
  std::vector<ShadedTriangle>* triangles_ = nullptr;
};

// One half-edge of each area of the penumbra.
std::vector<std::uint32_t> areas_of(const RingMap& map, int samples) {
  std::vector<std::uint32_t> areas;
  std::vector<bool> seen(map.half_edges(), false);
  for (std::uint32_t h = 0; h < map.half_edges(); ++h) {
    if (seen[h] || map.left(h) <= 0 || map.left(h) >= samples) continue;
    areas.push_back(h);
    for (std::uint32_t g = h; !seen[g]; g = map.next(g)) seen[g] = true;
  }
  return areas;
}

std::vector<ShadedTriangle> mends_of(const Rings& rings, const RingMap& map,
                                     const VertexIndex& vertices) {
  std::vector<ShadedTriangle> mends;
  for (std::uint32_t h = 0; h < map.half_edges(); ++h) {
    const int hidden = map.left(h);
    if (hidden > 0 && hidden < rings.samples) continue;
    ShadedTriangle mend{{map.begin(h), map.end(h), map.end(map.next(h))}, {}, hidden};
    const auto& c = mend.corners;
    if (!rings.points[c[1]].crossing || !vertices.is_clear(c[0], c[1], c[2])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      mend.intensity[i] = static_cast<float>(intensity(rings, c[i], hidden));
    }
    mends.push_back(mend);
  }
  return mends;
}

}  // namespace

RingTriangles triangulate_rings(const Rings& rings) {
  const RingMap map(rings);
  const VertexIndex vertices(rings.vertices);
  const std::vector<std::uint32_t> areas = areas_of(map, rings.samples);
  constexpr std::size_t kAreasATask = 64;
  std::vector<std::vector<ShadedTriangle>> parts((areas.size() + kAreasATask - 1) / kAreasATask);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    const std::size_t end = std::min(areas.size(), (i + 1) * kAreasATask);
    for (std::size_t area = i * kAreasATask; area < end; ++area) {
      StripFiller(rings, map, vertices, areas[area]).run(parts[i]);
    }
  });
  RingTriangles triangles;
  for (const auto& part : parts) {
    triangles.strips.insert(triangles.strips.end(), part.begin(), part.end());
  }
  if (rings.samples > 1) triangles.mends = mends_of(rings, map, vertices);
  return triangles;
}

}  // namespace wedgesim::functional

#include "functional/geometry/arrangement.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "functional/geometry/cell_grid.h"

namespace wedgesim::functional {
namespace {

__extension__ using Wide = __int128;

int sign(std::int64_t x) { return (x > 0 ? 1 : 0) - (x < 0 ? 1 : 0); }

bool boxes_meet(const GridSegment& s, const GridSegment& t) {
  const auto apart = [](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  return !apart(s.begin.x, s.end.x, t.begin.x, t.end.x) &&
         !apart(s.begin.y, s.end.y, t.begin.y, t.end.y);
}

// a + (b − a)·n/d, d > 0, to the nearest even number; halves go up, as a grid square is open above.
std::int32_t along(std::int32_t a, std::int32_t b, std::int64_t n, std::int64_t d) {
  const Wide doubled = Wide{2} * d;
  const Wide value = Wide{a} * d + (Wide{b} - a) * n + d;
  Wide quotient = value / doubled;
  if (value % doubled < 0) --quotient;
  return 2 * static_cast<std::int32_t>(quotient);
}

// The rounded point where two segments cross, if they do away from their ends.
bool crossing(const GridSegment& s, const GridSegment& t, GridPoint& point) {
  if (!boxes_meet(s, t)) return false;
  std::int64_t at_begin = turn(t.begin, t.end, s.begin);
  std::int64_t at_end = turn(t.begin, t.end, s.end);
  if (sign(at_begin) * sign(at_end) >= 0) return false;
  if (sign(turn(s.begin, s.end, t.begin)) * sign(turn(s.begin, s.end, t.end)) >= 0) return false;
  if (at_begin < 0) {
    at_begin = -at_begin;
    at_end = -at_end;
  }
  const std::int64_t d = at_begin - at_end;
  point = {along(s.begin.x, s.end.x, at_begin, d), along(s.begin.y, s.end.y, at_begin, d)};
  return true;
}

// Does a segment meet the grid square of a vertex, left and lower side included, right and upper
// not? Odd coordinates bound the square, so ends are never on its border.
bool meets_square(const GridSegment& s, const GridPoint& v) {
  const auto [x0, x1] = std::minmax(s.begin.x, s.end.x);
  const auto [y0, y1] = std::minmax(s.begin.y, s.end.y);
  if (x0 > v.x + 1 || x1 < v.x - 1 || y0 > v.y + 1 || y1 < v.y - 1) return false;
  const std::int64_t dx = std::int64_t{s.end.x} - s.begin.x;
  const std::int64_t dy = std::int64_t{s.end.y} - s.begin.y;
  // On which side a corner is; the right and upper sides are moved in by next to nothing.
  const auto side = [&](int right, int up) {
    const std::int64_t value = turn(s.begin, s.end, {v.x + 2 * right - 1, v.y + 2 * up - 1});
    return value != 0 ? sign(value) : sign(right * dy - up * dx);
  };
  const int first = side(0, 0);
  return first == 0 || side(1, 0) != first || side(0, 1) != first || side(1, 1) != first;
}

// Calls part(begin, end, out) for parts of a range at once and puts what they add to `out` one
// behind the other.
template <typename Item, typename Part>
void gather(std::size_t size, std::vector<Item>& all, Part&& part) {
  constexpr std::size_t kPart = 4096;
  if (size <= kPart) return part(std::size_t{0}, size, all);
  std::vector<std::vector<Item>> parts((size + kPart - 1) / kPart);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    part(i * kPart, std::min(size, (i + 1) * kPart), parts[i]);
  });
  for (const auto& items : parts) all.insert(all.end(), items.begin(), items.end());
}

std::vector<GridPoint> all_vertices(std::span<const GridSegment> segments, const CellGrid& grid,
                                    const CellLists& segments_in) {
  std::vector<GridPoint> vertices;
  vertices.reserve(4 * segments.size());
  for (const GridSegment& s : segments) {
    vertices.push_back(s.begin);
    vertices.push_back(s.end);
  }
  gather(grid.cells(), vertices, [&](std::size_t first, std::size_t last, auto& found) {
    GridPoint point;
    for (std::size_t cell = first; cell < last; ++cell) {
      const auto here = segments_in[cell];
      for (std::size_t i = 0; i < here.size(); ++i) {
        for (std::size_t j = i + 1; j < here.size(); ++j) {
          if (crossing(segments[here[i]], segments[here[j]], point) &&
              grid.cell_of(point) == cell) {
            found.push_back(point);
          }
        }
      }
    }
  });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Edges from vertex to vertex along segment s, which passes some cells.
void add_edges(const GridSegment& s, std::span<const CellLists::Entry> cells,
               const std::vector<GridPoint>& vertices, const CellLists& vertices_in,
               std::vector<std::uint32_t>& way, std::vector<Arrangement::Edge>& edges) {
  way.clear();
  for (const CellLists::Entry& entry : cells) {
    for (const std::uint32_t v : vertices_in[entry.cell]) {
      if (meets_square(s, vertices[v])) way.push_back(v);
    }
  }
  // A segment passes grid squares in the order of both coordinates.
  const int sx = s.end.x >= s.begin.x ? 1 : -1;
  const int sy = s.end.y >= s.begin.y ? 1 : -1;
  std::sort(way.begin(), way.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::int64_t{sx} * vertices[a].x + std::int64_t{sy} * vertices[a].y <
           std::int64_t{sx} * vertices[b].x + std::int64_t{sy} * vertices[b].y;
  });
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const auto [low, high] = std::minmax(way[i], way[i + 1]);
    edges.push_back({low, high, way[i] == low ? s.weight : -s.weight});
  }
}

// Edges with the same ends become one; those between equal winding numbers go.
void merge_edges(std::vector<Arrangement::Edge>& edges, const std::vector<GridPoint>& vertices) {
  using Edge = Arrangement::Edge;
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.begin != b.begin ? a.begin < b.begin : a.end < b.end;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    Edge edge = edges[i];
    for (++i; i < edges.size() && edges[i].begin == edge.begin && edges[i].end == edge.end; ++i) {
      edge.rise += edges[i].rise;
    }
    if (edge.rise != 0) edges[kept++] = edge;
  }
  edges.resize(kept);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end].begin == edges[i].begin) ++end;
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(i),
              edges.begin() + static_cast<std::ptrdiff_t>(end), [&](const Edge& a, const Edge& b) {
                return turn(vertices[a.begin], vertices[a.end], vertices[b.end]) > 0;
              });
    i = end;
  }
}

void drop_unused_vertices(Arrangement& arrangement) {
  std::vector<std::uint32_t> index(arrangement.vertices.size(), 0);
  for (const auto& edge : arrangement.edges) index[edge.begin] = index[edge.end] = 1;
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < index.size(); ++i) {
    if (index[i] == 0) continue;
    arrangement.vertices[used] = arrangement.vertices[i];
    index[i] = used++;
  }
  arrangement.vertices.resize(used);
  for (auto& edge : arrangement.edges) {
    edge.begin = index[edge.begin];
    edge.end = index[edge.end];
  }
}

}  // namespace

Arrangement arrange(std::span<const GridSegment> segments) {
  std::vector<GridPoint> ends;
  ends.reserve(2 * segments.size());
  for (const GridSegment& s : segments) ends.insert(ends.end(), {s.begin, s.end});
  const CellGrid grid(ends, segments.size());
  std::vector<CellLists::Entry> entries;  // segment by segment
  entries.reserve(3 * segments.size());
  std::vector<std::size_t> first{0};
  first.reserve(segments.size() + 1);
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    grid.for_each_cell({segments[i].begin, segments[i].end}, [&](std::uint32_t cell) {
      entries.push_back({cell, i});
    });
    first.push_back(entries.size());
  }
  Arrangement arrangement;
  std::vector<GridPoint>& vertices = arrangement.vertices;
  vertices = all_vertices(segments, grid, CellLists(grid.cells(), entries));
  const CellLists vertices_in(grid, vertices);
  gather(segments.size(), arrangement.edges, [&](std::size_t begin, std::size_t end, auto& edges) {
    std::vector<std::uint32_t> way;
    for (std::size_t i = begin; i < end; ++i) {
      const auto cells = std::span(entries).subspan(first[i], first[i + 1] - first[i]);
      add_edges(segments[i], cells, vertices, vertices_in, way, edges);
    }
  });
  merge_edges(arrangement.edges, vertices);
  drop_unused_vertices(arrangement);
  return arrangement;
}

}  // namespace wedgesim::functional

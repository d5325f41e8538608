#include "functional/geometry/sweep_line.h"

#include <algorithm>
#include <numeric>

#include "base/check.h"

namespace wedgesim::functional {
namespace {

// Which vertices hang together.
class Components {
 public:
  explicit Components(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  /// \return whether they were apart
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Sweeper {
 public:
  Sweeper(const Arrangement& arrangement, int full)
      : vertices_(arrangement.vertices),
        edges_(arrangement.edges),
        full_(full),
        components_(vertices_.size()) {
    sweep_.below.resize(edges_.size());
    for (const auto& edge : edges_) components_.join(edge.begin, edge.end);
  }

  Sweep run() {
    std::size_t next = 0;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      const std::size_t first = next;
      while (next < edges_.size() && edges_[next].begin == v) ++next;
      pass(v, first, next);
    }
    WEDGESIM_CHECK(cut_.empty());
    return std::move(sweep_);
  }

 private:
  // An edge that the sweep line cuts, and the gap above it.
  struct Cut {
    std::uint32_t edge = 0;
    int above = 0;             // winding number of the gap
    std::int32_t begin_x = 0;  // where the gap's trapezoid begins
    std::uint32_t latest = 0;  // the last vertex that bounded the gap
  };

  // Edges [first, last) begin at vertex v.
  void pass(std::uint32_t v, std::size_t first, std::size_t last) {
    const GridPoint& p = vertices_[v];
    const auto side = [&](const Cut& cut) {
      const auto& edge = edges_[cut.edge];
      return turn(vertices_[edge.begin], vertices_[edge.end], p);
    };
    const auto low = std::partition_point(cut_.begin(), cut_.end(),
                                          [&](const Cut& cut) { return side(cut) > 0; });
    auto high = low;
    for (; high != cut_.end() && side(*high) == 0; ++high) CHECK_EQ(edges_[high->edge].end, v);

    for (auto gap = low == cut_.begin() ? low : low - 1; gap != high; ++gap) close(gap, p.x);
    const bool enclosed = low != cut_.begin();
    if (enclosed) {
      Cut& under = *(low - 1);
      if (low == high && under.above >= 1 && under.above < full_ &&
          components_.join(v, under.latest)) {
        sweep_.bridges.push_back({under.latest, v});
      }
      under.begin_x = p.x;
      under.latest = v;
    }

    int winding = enclosed ? (low - 1)->above : 0;
    fresh_.clear();
    for (std::size_t e = first; e < last; ++e) {
      sweep_.below[e] = winding;
      winding += edges_[e].rise;
      fresh_.push_back({static_cast<std::uint32_t>(e), winding, p.x, v});
    }
    // In place as far as possible: most vertices end one edge and begin another.
    const auto ended = static_cast<std::size_t>(high - low);
    const std::size_t common = std::min(ended, fresh_.size());
    const auto rest = std::copy_n(fresh_.begin(), common, low);
    if (ended > common) {
      cut_.erase(rest, high);
    } else {
      cut_.insert(rest, fresh_.begin() + static_cast<std::ptrdiff_t>(common), fresh_.end());
    }
  }

  // Ends the trapezoid above a cut edge.
  void close(std::vector<Cut>::const_iterator cut, std::int32_t x) {
    if (cut->above < full_ || cut->begin_x == x) return;
    const auto ends = [&](const Cut& c) {
      return std::array{vertices_[edges_[c.edge].begin], vertices_[edges_[c.edge].end]};
    };
    sweep_.trapezoids.push_back({ends(*cut), ends(*(cut + 1)), cut->begin_x, x});
  }

  const std::vector<GridPoint>& vertices_;
  const std::vector<Arrangement::Edge>& edges_;
  int full_;
  Components components_;
  std::vector<Cut> cut_;  // from below
  std::vector<Cut> fresh_;
  Sweep sweep_;
};

}  // namespace

Sweep sweep_line(const Arrangement& arrangement, int full) {
  CHECK_GE(full, 1);
  return Sweeper(arrangement, full).run();
}

}  // namespace wedgesim::functional

// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/d_buffer_band.h"

#include <glm/geometric.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/d_buffer_band.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/methods/d_buffer_finish_simd.h"
#include "functional/raster/map_blocks_simd.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// |cx_o| lies this share of the way through a caster before the far side.
constexpr float kInside = 0.05F;
// A lit face does not shadow itself: |cx_o| lies behind it by what its distance from c changes over
// a texel, as far as a face is not seen from aside: this tangent.
constexpr double kMostSlope = 2.0;

HWY_INLINE void add(float* sum, float value, M on) {
  store(hn::Add(load(sum), hn::IfThenElseZero(on, set(value))), sum);
}
HWY_INLINE std::uint64_t count_of(M mask) { return hn::CountTrue(kTag, mask); }

// Whole vectors are stored: what follows can read them before they are in memory.
HWY_INLINE void replace(float* words, V value, M where) {
  store(hn::IfThenElse(where, value, load(words)), words);
}

// Keeps the nearer of two. Returns how often that changes something.
HWY_INLINE std::uint64_t raise(float* kept, V key, M on) {
  const V old = load(kept);
  const M nearer = hn::And(on, hn::Gt(key, old));
  store(hn::IfThenElse(nearer, key, old), kept);
  return count_of(nearer);
}

class Drawer {
 public:
  Drawer(const DBufferDrawing& drawing, int band, DBufferBand& rows, DBuffer& map,
         DBuffer::Count& count)
      : drawing_(drawing),
        options_(drawing.options),
        band_(band),
        y_begin_(band * DBufferBand::kRows),
        rows_(rows),
        map_(map),
        count_(count),
        interpolated_(drawing.options.distances == Distances::interpolated) {
    const MapRays rays(map.view);
    texel_ = 0.5 * (glm::length(rays.dx()) + glm::length(rays.dy()));
    forget_touched();
  }

  void draw_receivers() {
    for_each_triangle(drawing_.receivers.band(band_), [&](const MapTriangle& t) HWY_ATTR {
      draw(t, [&](const Texels& at) HWY_ATTR { raise_surface(at); });
    });
    forget_touched();
  }

  // A caster's faces and umbra volume: |cx_o|, |cx_uv|, |cx_s|.
  void draw_umbra(const DBufferCaster& caster) {
    for_each_triangle(caster.faces.band(band_), [&](const MapTriangle& t) HWY_ATTR {
      const bool enters = t.faces_light;
      const bool lit = t.tag == DBufferCaster::kLit;
      const V behind = set(change_over_texel(t));
      draw(t, [&](const Texels& at) HWY_ATTR {
        if (lit) add(word(at.words, Plane::inside), enters ? 1.0F : -1.0F, at.on);
        if (enters) {
          raise_surface(at);
          add(word(at.words, Plane::entries), 1.0F, at.on);
          raise(word(at.words, Plane::behind_entry), hn::Sub(at.key, behind), at.on);
        }
        raise(word(at.words, enters ? Plane::entry : Plane::exit), at.key, at.on);
      });
    });
    for_each_triangle(caster.umbra.band(band_), [&](const MapTriangle& t) HWY_ATTR {
      const bool quad = t.tag == DBufferCaster::kQuad;
      const bool leaves = !t.faces_light;
      draw(t, [&](const Texels& at) HWY_ATTR {
        if (quad) add(word(at.words, Plane::inside), leaves ? -1.0F : 1.0F, at.on);
        // Of quads that have run past the other side of their caster, none before it counts.
        if (leaves) offer(at, hn::Le(at.key, value(at.words, Plane::entry)));
      });
    });
    merge([&](float* texels) HWY_ATTR { take_umbra(texels); });
  }

  // A caster's penumbra volume, where it is in front of all surfaces: |cx_pv|, |cx_s|.
  void draw_penumbra(const DBufferCaster& caster) {
    for_each_triangle(caster.penumbra.band(band_), [&](const MapTriangle& t) HWY_ATTR {
      draw(t, [&](const Texels& at)
                  HWY_ATTR { offer(at, hn::Gt(at.key, value(at.words, Plane::surface))); });
    });
    merge([&](float* texels) HWY_ATTR { take_penumbra(texels); });
  }

 private:
  // Texels that a triangle covers where `on`.
  struct Texels {
    float* words;
    M on;
    V key;
    V edge;  // the key of the silhouette edge that cast it there, where that is nearer
  };

  // Of 1/w; and of the rays' lengths, which change by half a texel's width, or less, of themselves.
  float change_over_texel(const MapTriangle& face) const {
    const double slope = std::abs(face.inverse_w.a) + std::abs(face.inverse_w.b);
    return static_cast<float>(std::min(slope, kMostSlope * texel_ * face.inverse_low) +
                              texel_ * face.inverse_low);
  }

  template <typename Change>
  HWY_INLINE void draw(const MapTriangle& triangle, Change&& change) {
    count_.tests += for_each_block(
        triangle, map_.width, y_begin_, [&](int column, int row, const auto& texels) HWY_ATTR {
          Touched& touched = touched_[static_cast<std::size_t>(row)];
          touched = {std::min(touched.begin, column), std::max(touched.end, column + 1)};
          draw_block(triangle, column, row, texels, change);
        });
  }
  template <typename Covered, typename Change>
  HWY_INLINE void draw_block(const MapTriangle& triangle, int column, int row,
                             const Covered& texels, Change&& change) {
    const int x = column * kBlockEdge;
    const int y = y_begin_ + row * kBlockEdge;
    float* words = rows_.block(column, row);
    const BlockPlane plane(triangle.inverse_w, x, y);
    const BlockPlane other(triangle.other_over_w, x, y);
    for (int lane = 0; lane < kBlock; lane += kLanes) {
      Texels at{words + lane, texels.covered(x, lane), inverse_w(triangle, plane, lane),
                other.at(lane)};
      if (interpolated_) {
        at.edge = hn::Div(at.key, at.edge);
        at.key = hn::Div(at.key, BlockPlane(triangle.value_over_w, x, y).at(lane));
      }
      change(at);
    }
  }

  HWY_INLINE void raise_surface(const Texels& at) {
    count_.writes += raise(word(at.words, Plane::surface), at.key, at.on);
  }

  // Keeps the nearest and the farthest side of a caster's volume.
  HWY_INLINE void offer(const Texels& at, M counts) {
    const M on = hn::And(at.on, counts);
    if (hn::AllFalse(kTag, on)) return;
    const V nearest = value(at.words, Plane::nearest);
    const V farthest = value(at.words, Plane::farthest);
    const M none = hn::Eq(farthest, hn::Zero(kTag));
    keep(at, hn::And(on, hn::Gt(at.key, nearest)), Plane::nearest, Plane::nearest_edge);
    keep(at, hn::And(on, hn::Or(none, hn::Lt(at.key, farthest))), Plane::farthest,
         Plane::farthest_edge);
  }
  HWY_INLINE void keep(const Texels& at, M where, Plane key, Plane edge) {
    replace(word(at.words, key), at.key, where);
    replace(word(at.words, edge), at.edge, where);
  }

  // Takes over what is drawn of a caster, and empties its planes.
  template <typename Take>
  HWY_INLINE void merge(Take&& take) {
    for (int row = 0; row < kBlockRows; ++row) {
      const Touched& touched = touched_[static_cast<std::size_t>(row)];
      for (int column = touched.begin; column < touched.end; ++column) {
        float* block = rows_.block(column, row);
        for (int lane = 0; lane < kBlock; lane += kLanes) take(block + lane);
        std::fill(word(block, Plane::entries), word(block, Plane::kPlanes), 0.0F);
      }
    }
    forget_touched();
  }

  HWY_INLINE void take_umbra(float* texels) {
    const V zero = hn::Zero(kTag);
    const V entries = value(texels, Plane::entries);
    const M crossed = hn::Gt(entries, zero);
    if (hn::AllFalse(kTag, crossed)) return;
    const V entry = value(texels, Plane::entry);
    const V left = value(texels, Plane::exit);
    const V exit = hn::IfThenElse(hn::Gt(left, zero), left, entry);
    const V in_it = hn::Add(exit, hn::Mul(set(kInside), hn::Sub(entry, exit)));
    count_.writes += raise(word(texels, Plane::occluder),
                           hn::Min(in_it, value(texels, Plane::behind_entry)), crossed);

    const M nearest = options_.crossing == Crossing::nearest    ? crossed
                      : options_.crossing == Crossing::farthest ? hn::Lt(entries, zero)
                                                                : hn::Eq(entries, set(1.0F));
    const V side =
        hn::IfThenElse(nearest, value(texels, Plane::nearest), value(texels, Plane::farthest));
    const V edge = hn::IfThenElse(nearest, value(texels, Plane::nearest_edge),
                                  value(texels, Plane::farthest_edge));
    const M inside = hn::Gt(value(texels, Plane::inside), zero);
    // A ray that grazes the caster may leave before, by rounding, it enters.
    const M grazes = hn::And(hn::Not(inside), hn::Eq(side, zero));
    const V key = hn::IfThenZeroElse(inside, hn::IfThenElse(grazes, entry, side));
    const V old = value(texels, Plane::umbra);
    const M better =
        hn::Or(hn::Lt(old, zero), nearest_caster() ? hn::Gt(key, old) : hn::Lt(key, old));
    const M taken = hn::And(crossed, better);
    replace(word(texels, Plane::umbra), key, taken);
    const V edge_key = hn::IfThenElse(grazes, key, hn::Max(key, edge));
    replace(word(texels, Plane::umbra_edge), edge_key, hn::And(taken, hn::Gt(key, zero)));
    count_.writes += count_of(taken);
  }

  HWY_INLINE void take_penumbra(float* texels) {
    const V zero = hn::Zero(kTag);
    const bool farthest = options_.crossing == Crossing::farthest;
    const V key = value(texels, farthest ? Plane::farthest : Plane::nearest);
    M taken = hn::Gt(key, zero);
    if (!options_.two_edges) taken = hn::And(taken, hn::Lt(value(texels, Plane::umbra), zero));
    const V old = value(texels, Plane::penumbra);
    const M better =
        hn::Or(hn::Eq(old, zero), nearest_caster() ? hn::Gt(key, old) : hn::Lt(key, old));
    taken = hn::And(taken, better);
    replace(word(texels, Plane::penumbra), key, taken);
    const V edge =
        hn::Max(key, value(texels, farthest ? Plane::farthest_edge : Plane::nearest_edge));
    replace(word(texels, options_.two_edges ? Plane::penumbra_edge : Plane::umbra_edge), edge,
            taken);
    count_.writes += count_of(taken);
  }

  bool nearest_caster() const { return options_.crossing == Crossing::nearest; }

  void forget_touched() { touched_.fill({map_.width, 0}); }

  const DBufferDrawing& drawing_;
  const DBufferOptions& options_;
  int band_, y_begin_;
  DBufferBand& rows_;
  DBuffer& map_;
  DBuffer::Count& count_;
  bool interpolated_;
  double texel_;  // its edge at w = 1
  static constexpr int kBlockRows = DBufferBand::kRows / kBlockEdge;
  struct Touched {
    int begin, end;
  };
  std::array<Touched, kBlockRows> touched_;  // blocks that something of a caster is drawn in
};

void draw_band(const DBufferDrawing& drawing, int band, DBufferBand& scratch, DBuffer& map,
               DBuffer::Count& count) {
  scratch.clear();
  Drawer drawer(drawing, band, scratch, map, count);
  drawer.draw_receivers();
  for (const DBufferCaster& caster : drawing.casters) drawer.draw_umbra(caster);
  // Only now is every surface known.
  for (const DBufferCaster& caster : drawing.casters) drawer.draw_penumbra(caster);
  const bool interpolated = drawing.options.distances == Distances::interpolated;
  finish_band(scratch, band * DBufferBand::kRows, interpolated, map);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(draw_band);
}  // namespace

void draw_d_buffer_band(const DBufferDrawing& drawing, int band, DBufferBand& scratch, DBuffer& map,
                        DBuffer::Count& count) {
  HWY_DYNAMIC_DISPATCH(draw_band)(drawing, band, scratch, map, count);
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE

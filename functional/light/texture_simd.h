// Lookups in a coverage texture (coverage_texture.h) for the lanes of a vector at once. Compiled
// once for every instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_TEXTURE_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_TEXTURE_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_TEXTURE_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_TEXTURE_SIMD_H
#endif

#include "functional/light/chord_simd.h"
#include "functional/light/coverage_texture.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

// Where a coordinate of a chord's end lies among the entries of a side: 0 to side − 1.
HWY_INLINE V entry_place(V coordinate, float last) {
  const V at = hn::Mul(hn::Add(coordinate, set(1.0F)), set(0.5F * last));
  return hn::Min(hn::IfThenElseZero(hn::Gt(at, hn::Zero(kTag)), at), set(last));
}

// An entry of an end: how many rows and columns from the light's middle, in half spacings, and its
// number.
struct EntryEnd {
  HWY_INLINE EntryEnd(V column, V row, int side) {
    const V middle = set(static_cast<float>(side - 1));
    x = hn::Sub(hn::Add(column, column), middle);
    y = hn::Sub(hn::Add(row, row), middle);
    number = hn::Add(hn::Mul(hn::ConvertTo(kInts, row), hn::Set(kInts, side)),
                     hn::ConvertTo(kInts, column));
  }
  V x, y;
  I number;
};

/// CoverageTexture::nearest and ::quadlinear.
template <std::size_t channels, TextureFilter filter>
struct TextureLookup {
  static constexpr std::size_t kChannels = channels;
  const CoverageTexture& table;

  HWY_INLINE void operator()(const Chords& chords, M, V* parts) const {
    // Counter-clockwise about the centre, as the table takes a chord's ends.
    const V cross = chords.cross();
    const Chords ordered = chords.exchanged(hn::Lt(cross, hn::Zero(kTag)));
    const Centre centre{hn::Abs(cross),
                        hn::Add(hn::Mul(chords.px, chords.qx), hn::Mul(chords.py, chords.qy))};
    for (std::size_t c = 0; c < channels; ++c) parts[c] = hn::Zero(kTag);
    if constexpr (filter == TextureFilter::nearest) {
      add_entry(centre, nearest(ordered.px, ordered.py), nearest(ordered.qx, ordered.qy), set(1.0F),
                parts);
    } else {
      add_linear(centre, ordered, parts);
    }
  }

 private:
  // On which side of the light's centre a chord passes, and how.
  struct Centre {
    V cross, dot;
  };

  float last() const { return static_cast<float>(table.side() - 1); }

  HWY_INLINE EntryEnd nearest(V x, V y) const {
    const V half = set(0.5F);
    return {hn::Floor(hn::Add(entry_place(x, last()), half)),
            hn::Floor(hn::Add(entry_place(y, last()), half)), table.side()};
  }

  // The entries at the corners of the cell that an end lies in, and their weights.
  struct Corners {
    HWY_INLINE Corners(V x, V y, int side) {
      const float last = static_cast<float>(side - 1);
      const V at_x = entry_place(x, last);
      const V at_y = entry_place(y, last);
      column = hn::Min(hn::Floor(at_x), set(last - 1.0F));
      row = hn::Min(hn::Floor(at_y), set(last - 1.0F));
      right = hn::Sub(at_x, column);
      lower = hn::Sub(at_y, row);
    }
    HWY_INLINE EntryEnd end(std::size_t i, int side) const {
      return {i % 2 == 0 ? column : hn::Add(column, set(1.0F)),
              i / 2 == 0 ? row : hn::Add(row, set(1.0F)), side};
    }
    HWY_INLINE V weight(std::size_t i) const {
      const V one = set(1.0F);
      return hn::Mul(i % 2 == 0 ? hn::Sub(one, right) : right,
                     i / 2 == 0 ? hn::Sub(one, lower) : lower);
    }
    V column, row, right, lower;
  };

  HWY_INLINE void add_linear(const Centre& centre, const Chords& chords, V* parts) const {
    const Corners from(chords.px, chords.py, table.side());
    const Corners to(chords.qx, chords.qy, table.side());
    for (std::size_t i = 0; i < 4; ++i) {
      const EntryEnd from_end = from.end(i, table.side());
      const V from_weight = from.weight(i);
      for (std::size_t j = 0; j < 4; ++j) {
        add_entry(centre, from_end, to.end(j, table.side()), hn::Mul(from_weight, to.weight(j)),
                  parts);
      }
    }
  }

  // Adds an entry as the chord has it: continued past the centre if it passes on the other side.
  HWY_INLINE void add_entry(const Centre& centre, const EntryEnd& from, const EntryEnd& to,
                            V weight, V* parts) const {
    const V zero = hn::Zero(kTag);
    const V cross = hn::Sub(hn::Mul(from.x, to.y), hn::Mul(from.y, to.x));
    const V dot = hn::Add(hn::Mul(from.x, to.x), hn::Mul(from.y, to.y));
    const M beyond = hn::Lt(cross, zero);
    const V between = hn::Sub(hn::Mul(dot, centre.cross), hn::Mul(centre.dot, cross));
    const V whole = hn::IfThenElseZero(hn::And(beyond, hn::Lt(between, zero)), weight);
    const V signed_weight = hn::IfThenElse(beyond, hn::Neg(weight), weight);
    const I ends = hn::Set(kInts, table.side() * table.side());
    V values[channels];
    read(hn::Add(hn::Mul(from.number, ends), to.number), values);
    for (std::size_t c = 0; c < channels; ++c) {
      parts[c] = hn::Add(parts[c], hn::Add(whole, hn::Mul(signed_weight, values[c])));
    }
  }

  HWY_INLINE void read(I entry, V* values) const {
    if (table.bytes_in_words() == nullptr) {
      const I first = hn::Mul(entry, hn::Set(kInts, static_cast<int>(channels)));
      for (std::size_t c = 0; c < channels; ++c) {
        const I place = hn::Add(first, hn::Set(kInts, static_cast<int>(c)));
        values[c] = hn::GatherIndex(kTag, table.floats(), place);
      }
      return;
    }
    const I byte = hn::Set(kInts, 255);
    const V level = set(1.0F / 255.0F);
    if constexpr (channels == 1) {
      const I word = hn::GatherIndex(kInts, table.bytes_in_words(), hn::ShiftRight<2>(entry));
      const I shift = hn::ShiftLeft<3>(hn::And(entry, hn::Set(kInts, 3)));
      values[0] = hn::Mul(hn::ConvertTo(kTag, hn::And(hn::Shr(word, shift), byte)), level);
    } else {
      const I word = hn::GatherIndex(kInts, table.bytes_in_words(), entry);
      const I shifted[3] = {word, hn::ShiftRight<8>(word), hn::ShiftRight<16>(word)};
      for (std::size_t c = 0; c < channels; ++c) {
        values[c] = hn::Mul(hn::ConvertTo(kTag, hn::And(shifted[c], byte)), level);
      }
    }
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_TEXTURE_SIMD_H

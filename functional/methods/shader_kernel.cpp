// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/shader_kernel.h"

#include <algorithm>
#include <bit>

#include "functional/light/shader_tables.h"
#include "functional/light/split_word.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/shader_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/light/coverage_simd.h"
#include "functional/light/sector_simd.h"
#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

// Adds up to 127 to each of four 8-bit components, up to 255.
HWY_INLINE V add_components(V old, V share) {
  constexpr hn::RebindToUnsigned<D> kBits;
  const auto whole = hn::BitCast(kBits, old);
  const auto high = hn::And(whole, hn::Set(kBits, 0x80808080U));
  const auto sum = hn::Add(hn::Xor(whole, high), hn::BitCast(kBits, share));  // no carries
  const auto over = hn::And(sum, high);
  const auto most = hn::Sub(hn::ShiftLeft<1>(over), hn::ShiftRight<7>(over));
  return hn::BitCast(kTag, hn::Or(hn::Or(sum, high), most));
}

template <typename Share>
struct SplitShare {
  static constexpr std::size_t kForms = Share::kForms;
  static constexpr std::size_t kChannels = 3;
  static constexpr std::size_t kUmbraChannel = 2;
  static constexpr std::size_t kWords = 1;  // four components are blended at once
  Share share;
  const std::int32_t* words = split_words().data();

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M inner, V* shares,
                          M& read) const {
    const V zero = hn::Zero(kTag);
    V whole = zero;
    const M counts = share(forms, wedge, inner, &whole, read);
    if (hn::AllFalse(kTag, counts)) return counts;
    const V covered = hn::IfThenElseZero(counts, hn::Abs(whole));
    const V at = hn::Mul(hn::Min(hn::Add(covered, covered), set(1.0F)), set(1023.0F));
    const I index = hn::ConvertTo(kInts, hn::Add(at, set(0.5F)));
    const V word = hn::BitCast(kTag, hn::GatherIndex(kInts, words, index));
    shares[0] = hn::IfThenElseZero(inner, word);
    shares[1] = hn::IfThenZeroElse(inner, word);
    shares[2] = zero;
    return counts;
  }
  static HWY_INLINE V blend(std::size_t channel, V old, V share) {
    return channel == kUmbraChannel ? old : add_components(old, share);
  }
};

template <typename Share>
void draw_split(const Share& share, const VolumeFrame& frame, VolumeRow& row) {
  const auto begin = row.words.begin();
  std::fill(begin, begin + 2 * static_cast<std::ptrdiff_t>(row.words.size() / 3), 0.0F);
  draw_row_by(SplitShare<Share>{share}, frame, row);
}

void draw_table_rectangle(const SectorTable& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(RectangleTableShare{{table}}, frame, row);
}
void draw_table_sphere(const SectorTable& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(SphereTableShare{table}, frame, row);
}
void draw_split_table_rectangle(const SectorTable& table, const VolumeFrame& frame,
                                VolumeRow& row) {
  draw_split(RectangleTableShare{{table}}, frame, row);
}
void draw_split_table_sphere(const SectorTable& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_split(SphereTableShare{table}, frame, row);
}
void draw_split_rectangle(const VolumeFrame& frame, VolumeRow& row) {
  draw_split(RectangleShare{}, frame, row);
}
void draw_split_sphere(const VolumeFrame& frame, VolumeRow& row) {
  draw_split(SphereShare{}, frame, row);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(draw_table_rectangle);
HWY_EXPORT(draw_table_sphere);
HWY_EXPORT(draw_split_table_rectangle);
HWY_EXPORT(draw_split_table_sphere);
HWY_EXPORT(draw_split_rectangle);
HWY_EXPORT(draw_split_sphere);

const SectorTable& square_table() {
  static const SectorTable table = SectorTable::square();
  return table;
}
const SectorTable& disc_table() {
  static const SectorTable table = SectorTable::disc();
  return table;
}
}  // namespace

DrawRow table_kernel(LightShape shape) {
  if (shape == LightShape::rectangle) {
    return [](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_table_rectangle)(square_table(), frame, row);
    };
  }
  return [](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_table_sphere)(disc_table(), frame, row);
  };
}

DrawRow split_kernel(LightShape shape, bool tables) {
  const bool rectangle = shape == LightShape::rectangle;
  if (tables && rectangle) {
    return [](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_split_table_rectangle)(square_table(), frame, row);
    };
  }
  if (tables) {
    return [](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_split_table_sphere)(disc_table(), frame, row);
    };
  }
  if (rectangle) {
    return [](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_split_rectangle)(frame, row);
    };
  }
  return [](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_split_sphere)(frame, row);
  };
}

std::vector<float> merged_split_words(const std::vector<float>& planes) {
  const std::size_t pixels = planes.size() / 3;
  std::vector<float> values(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const SplitWord added{std::bit_cast<std::array<std::uint8_t, 4>>(planes[i])};
    const SplitWord taken{std::bit_cast<std::array<std::uint8_t, 4>>(planes[pixels + i])};
    const auto sum = static_cast<float>(added.unpack() - taken.unpack());
    values[i] = planes[2 * pixels + i] + sum / static_cast<float>(SplitWord::kWhole);
  }
  return values;
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE

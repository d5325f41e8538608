// Compiled once for every instruction set (Highway); each gives the bits of kernel_scalar.cpp and
// contribution.cpp: the same operations in the same order, no fused multiply-add.
#include <algorithm>
#include <array>
#include <bit>
#include <tuple>
#include <utility>

#include "model/count/kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/count/kernel_simd.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "model/count/contribution_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::model {
namespace HWY_NAMESPACE {
namespace {

// The lanes' sign bits, lane 0 lowest.
std::uint64_t sign_bits(V v) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(
      kTag, hn::MaskFromVec(hn::BitCast(kTag, hn::BroadcastSignBit(hn::BitCast(kIntTag, v)))),
      bytes.data());
  return bytes[0] & kGroupBits;
}

HWY_INLINE Box box_of(const Block& block) {
  const double x = block.bx * 8.0;
  const double y = block.by * 8.0;
  return {x, x + 8.0, y, y + 8.0, block.z_interval};
}

// Calls f(group) for the groups of lanes of a row, without a loop.
template <typename F>
HWY_INLINE void for_each_group(F&& f) {
  [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) HWY_ATTR { (f(kIndices), ...); }
  (std::make_index_sequence<kGroups>());
}

// The bits that of_row(row, depths) gives for the rows of a block that hold a candidate; other
// rows' bits are 0.
template <typename OfRow>
HWY_INLINE std::uint64_t row_bits(const Block& block, std::uint64_t candidates, OfRow&& of_row) {
  std::uint64_t bits = 0;
  for (std::size_t row = 0; row < kBlock; ++row) {
    if ((candidates >> (kBlock * row) & 0xff) == 0) continue;
    bits |= of_row(row, block.z + kBlock * row) << (kBlock * row);
  }
  return bits;
}

// Set bits where a plane's value is negative. No value is ever -0 (plane.h).
HWY_INLINE std::uint64_t negative_bits(const Plane& plane, const Block& block,
                                       std::uint64_t candidates) {
  std::array<V, kGroups> ax;
  for_each_group([&](std::size_t g) HWY_ATTR {
    const V centre = hn::Add(hn::Iota(kTag, static_cast<double>(g * kLanes)), set(0.5));
    ax[g] = hn::Mul(set(plane.a), hn::Add(set(block.bx * 8.0), centre));
  });
  const V c = set(plane.c);
  const V d = set(plane.d);
  const double first_y = block.by * 8.0 + 0.5;
  return row_bits(block, candidates, [&](std::size_t row, const double* depths) HWY_ATTR {
    const V by = set(plane.b * (first_y + static_cast<double>(row)));
    std::uint64_t bits = 0;
    for_each_group([&](std::size_t g) HWY_ATTR {
      const V z = hn::LoadU(kTag, depths + g * kLanes);
      const V value = hn::Add(hn::Add(hn::Add(ax[g], by), hn::Mul(c, z)), d);
      bits |= sign_bits(value) << (g * kLanes);
    });
    return bits;
  });
}

// Set bits where z is below a bound, or above it.
HWY_INLINE std::uint64_t below_bits(double bound, const Block& block, std::uint64_t candidates) {
  return row_bits(block, candidates, [&](std::size_t, const double* depths) HWY_ATTR {
    std::uint64_t bits = 0;
    for_each_group([&](std::size_t g) HWY_ATTR {
      const V z = hn::LoadU(kTag, depths + g * kLanes);
      bits |= sign_bits(hn::Sub(z, set(bound))) << (g * kLanes);
    });
    return bits;
  });
}
HWY_INLINE std::uint64_t above_bits(double bound, const Block& block, std::uint64_t candidates) {
  return row_bits(block, candidates, [&](std::size_t, const double* depths) HWY_ATTR {
    std::uint64_t bits = 0;
    for_each_group([&](std::size_t g) HWY_ATTR {
      const V z = hn::LoadU(kTag, depths + g * kLanes);
      bits |= sign_bits(hn::Sub(set(bound), z)) << (g * kLanes);
    });
    return bits;
  });
}

// A wedge's planes side by side, to test a block's box against all of them at once. A plane that
// holds at all corners of the box holds at its pixels (monotone rounding), one that holds at none
// excludes it; the others decide pixel by pixel.
class BoxTests {
 public:
  HWY_INLINE explicit BoxTests(std::span<const Plane> planes) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const Plane& plane = planes[i];
      a_[i] = plane.a;
      b_[i] = plane.b;
      c_[i] = plane.c;
      d_[i] = plane.d;
      flip_[i] = plane.minus ? -0.0 : 0.0;
      right_[i] = (plane.a >= 0.0) != plane.minus ? 8.0 : 0.0;
      below_[i] = (plane.b >= 0.0) != plane.minus ? 8.0 : 0.0;
      far_[i] = plane.inward_c() >= 0.0 ? 1.0 : 0.0;
    }
    groups_ = (planes.size() + kLanes - 1) / kLanes;
  }

  struct Result {
    std::uint64_t excluding = 0;  // bit i: plane i excludes the box
    std::uint64_t deciding = 0;   // bit i: plane i does not hold everywhere in it
  };
  HWY_INLINE Result test(const Block& block) const {
    Result result;
    const V x0 = set(block.bx * 8.0);
    const V y0 = set(block.by * 8.0);
    const V near = set(block.z_interval.min);
    const V far = set(block.z_interval.max);
    const V eight = set(8.0);
    for (std::size_t i = 0; i < groups_ * kLanes; i += kLanes) {
      const V right = hn::LoadU(kTag, &right_[i]);
      const V below = hn::LoadU(kTag, &below_[i]);
      const M is_far = hn::Ne(hn::LoadU(kTag, &far_[i]), hn::Zero(kTag));
      result.excluding |=
          outside(i, hn::Add(x0, right), hn::Add(y0, below), hn::IfThenElse(is_far, far, near));
      result.deciding |=
          outside(i, hn::Add(x0, hn::Sub(eight, right)), hn::Add(y0, hn::Sub(eight, below)),
                  hn::IfThenElse(is_far, near, far));
    }
    return result;
  }

 private:
  // Bit k: a point, one for each plane, is outside plane k; planes i ... i + kLanes - 1.
  HWY_INLINE std::uint64_t outside(std::size_t i, V x, V y, V z) const {
    const V ab = hn::Add(hn::Mul(hn::LoadU(kTag, &a_[i]), x), hn::Mul(hn::LoadU(kTag, &b_[i]), y));
    const V abc = hn::Add(ab, hn::Mul(hn::LoadU(kTag, &c_[i]), z));
    const V value = hn::Add(abc, hn::LoadU(kTag, &d_[i]));
    return sign_bits(hn::Xor(value, hn::LoadU(kTag, &flip_[i]))) << i;
  }

  // Planes that are not there hold everywhere: 0 >= 0.
  std::array<double, 8> a_{}, b_{}, c_{}, d_{}, flip_{}, right_{}, below_{}, far_{};
  std::size_t groups_ = 0;
};

void inside(const Primitive& wedge, std::span<const Block> blocks, const std::uint64_t* candidates,
            std::uint64_t* result) {
  const BoxTests tests(wedge.planes);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    const ZInterval z = block.z_interval;
    result[i] = 0;
    if (candidates[i] == 0 || z.min > wedge.z.max || z.max < wedge.z.min) continue;
    const auto [excluding, deciding] = tests.test(block);
    if (excluding != 0) continue;
    std::uint64_t left = candidates[i];
    if (z.min < wedge.z.min) left &= ~below_bits(wedge.z.min, block, left);
    if (z.max > wedge.z.max) left &= ~above_bits(wedge.z.max, block, left);
    for (std::uint64_t planes = deciding; planes != 0; planes &= planes - 1) {
      const Plane& plane = wedge.planes[static_cast<std::size_t>(std::countr_zero(planes))];
      const std::uint64_t negative = negative_bits(plane, block, left);
      left &= plane.minus ? negative : ~negative;
    }
    result[i] = left;
  }
}

UmbraBits umbra_bits(const Plane& plane, ZInterval interval, const Block& block,
                     std::uint64_t candidates) {
  const ZInterval z = block.z_interval;
  const std::uint64_t negative = negative_bits(plane, block, candidates);
  return {plane.minus ? negative : ~negative,
          z.min < interval.min ? below_bits(interval.min, block, candidates) : 0,
          z.max > interval.max ? above_bits(interval.max, block, candidates) : 0};
}

void umbra(const Plane& plane, ZInterval interval, std::span<const Block> blocks,
           const std::uint64_t* candidates, UmbraBits* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    result[i] = {};
    if (candidates[i] == 0) continue;
    // Most blocks are on one side of the plane, and before, within or beyond the interval.
    const ZInterval z = block.z_interval;
    const Box box = box_of(block);
    const bool far_inside = plane.inward_c() >= 0.0;
    const bool none = !plane.reaches(box, far_inside ? z.max : z.min);
    const bool all = !none && plane.holds(box, far_inside ? z.min : z.max);
    const bool before = z.max < interval.min;
    const bool beyond = z.min > interval.max;
    const bool within = z.min >= interval.min && z.max <= interval.max;
    if ((none || all) && (before || beyond || within)) {
      const auto fill = [](bool set_all) { return set_all ? ~std::uint64_t{0} : 0; };
      result[i] = {fill(all), fill(before), fill(beyond)};
    } else {
      result[i] = umbra_bits(plane, interval, block, candidates[i]);
    }
  }
}

// All ones in the lanes of the set bits.
HWY_INLINE hn::Vec<decltype(kIntTag)> lanes_of(std::uint64_t bits) {
  alignas(16) static constexpr std::array<std::int64_t, 8> kBits{1, 2, 4, 8, 16, 32, 64, 128};
  const auto bit = hn::LoadU(kIntTag, kBits.data());
  const auto all = hn::Set(kIntTag, static_cast<std::int64_t>(bits));
  return hn::VecFromMask(kIntTag, hn::Eq(hn::And(all, bit), bit));
}

template <typename Terms>
void words_of(const Terms& terms, double one, std::span<const Block> blocks,
              const std::uint64_t* sets, const std::uint64_t* negated, std::int64_t* result) {
  const auto magic = hn::BitCast(kIntTag, set(kRoundMagic));
  const auto rows = rows_of(terms);
  std::array<BlockRow, std::tuple_size_v<decltype(rows)>> placed;
  for (std::size_t i = 0; i < blocks.size(); ++i, result += kBlockPixels) {
    if (sets[i] == 0) continue;
    for (std::size_t k = 0; k < rows.size(); ++k) placed[k].place(rows[k], blocks[i]);
    const bool turns = (sets[i] & negated[i]) != 0;
    for (std::size_t shift = 0; shift < kBlockPixels; shift += kLanes) {
      const std::uint64_t bits = sets[i] >> shift & kGroupBits;
      if (bits == 0) {
        hn::StoreU(hn::Zero(kIntTag), kIntTag, result + shift);
        continue;
      }
      const Here here{placed.data(), shift / kBlock, shift % kBlock / kLanes,
                      hn::LoadU(kTag, blocks[i].z + shift)};
      const V shifted = hn::Add(hn::Mul(value_of(terms, here), set(one)), set(kRoundMagic));
      const auto word = hn::Sub(hn::BitCast(kIntTag, shifted), magic);
      const auto kept = hn::And(word, lanes_of(bits));
      if (!turns) {
        hn::StoreU(kept, kIntTag, result + shift);
        continue;
      }
      const auto sign = lanes_of(negated[i] >> shift);
      hn::StoreU(hn::Sub(hn::Xor(kept, sign), sign), kIntTag, result + shift);  // -kept if all ones
    }
  }
}

void words(const LightTerms& terms, double one, std::span<const Block> blocks,
           const std::uint64_t* sets, const std::uint64_t* negated, std::int64_t* result) {
  std::visit(
      [&](const auto& kind) {
        using Terms = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Terms, FixedTerms> || std::is_same_v<Terms, SingleTerms>) {
          scalar_kernel().words(terms, one, blocks, sets, negated, result);
        } else {
          words_of(kind, one, blocks, sets, negated, result);
        }
      },
      terms);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::model
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::model {
namespace {

HWY_EXPORT(inside);
HWY_EXPORT(umbra);
HWY_EXPORT(words);

std::vector<Kernel> make_kernels() {
  std::vector<Kernel> kernels;
  for (std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    kernels.push_back({hwy::TargetName(target), &HWY_DYNAMIC_DISPATCH(inside),
                       &HWY_DYNAMIC_DISPATCH(umbra), &HWY_DYNAMIC_DISPATCH(words)});
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return kernels;
}

}  // namespace

const std::vector<Kernel>& simd_kernels() {
  static const std::vector<Kernel> kernels = make_kernels();
  return kernels;
}

const Kernel& simd_kernel() { return simd_kernels().front(); }

}  // namespace wedgesim::model
#endif  // HWY_ONCE

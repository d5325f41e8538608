// Compiled once for every instruction set (Highway); each gives the bits of kernel_scalar.cpp and
// contribution.cpp: the same operations in the same order, no fused multiply-add.
#include <array>
#include <cstring>

#include "model/count/atan.h"
#include "model/count/kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/count/kernel_simd.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::model {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kBlock>;  // lanes never straddle a block's row
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D d;
constexpr hn::RebindToSigned<D> di;

V set(double value) { return hn::Set(d, value); }

// The lanes' sign bits, lane 0 lowest.
std::uint64_t sign_bits(V v) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, hn::MaskFromVec(hn::BitCast(d, hn::BroadcastSignBit(hn::BitCast(di, v)))),
                    bytes.data());
  return bytes[0];
}

// The planes of one wedge over one block: a*x of the 8 columns and b*y of the 8 rows are kept.
struct BlockPlanes {
  std::array<std::array<double, kBlock>, 8> ax, by;

  void place(std::size_t i, const Plane& plane, const Block& block) {
    for (int k = 0; k < kBlock; ++k) {
      ax[i][static_cast<std::size_t>(k)] = plane.a * (block.bx * 8.0 + k + 0.5);
      by[i][static_cast<std::size_t>(k)] = plane.b * (block.by * 8.0 + k + 0.5);
    }
  }
  V value(std::size_t i, const Plane& plane, std::size_t row, std::size_t column, V z) const {
    const V ab = hn::Add(hn::LoadU(d, &ax[i][column]), set(by[i][row]));
    return hn::Add(hn::Add(ab, hn::Mul(set(plane.c), z)), set(plane.d));
  }
};

// Calls f(row, column, z, shift) for every group of lanes that holds a candidate.
template <typename F>
void for_each_group(const Block& block, std::uint64_t candidates, F&& f) {
  const std::size_t lanes = hn::Lanes(d);
  const std::uint64_t group = (std::uint64_t{1} << lanes) - 1;
  for (std::size_t row = 0; row < kBlock; ++row) {
    const std::uint64_t bits = candidates >> (8 * row) & 0xff;
    if (bits == 0) continue;
    for (std::size_t column = 0; column < kBlock; column += lanes) {
      if ((bits >> column & group) == 0) continue;
      const std::size_t shift = 8 * row + column;
      f(row, column, hn::LoadU(d, block.z + shift), shift);
    }
  }
}

void inside(const Primitive& wedge, std::span<const Block> blocks, const std::uint64_t* candidates,
            std::uint64_t* result) {
  // No value is ever -0, so sign bits alone decide: a point is outside if a plus plane's value has
  // one, or a minus plane's has none.
  std::array<Plane, 8> planes;
  std::size_t plus = 0;
  std::size_t count = 0;
  for (const Plane& plane : wedge.planes) {
    if (!plane.minus) planes[count++] = plane;
  }
  plus = count;
  for (const Plane& plane : wedge.planes) {
    if (plane.minus) planes[count++] = plane;
  }
  const std::uint64_t group = (std::uint64_t{1} << hn::Lanes(d)) - 1;
  BlockPlanes placed;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::uint64_t outside_bits = 0;
    if (candidates[i] != 0) {
      for (std::size_t p = 0; p < count; ++p) placed.place(p, planes[p], blocks[i]);
    }
    for_each_group(
        blocks[i], candidates[i], [&](std::size_t row, std::size_t column, V z, std::size_t shift) {
          V outside = hn::Or(hn::Sub(z, set(wedge.z.min)), hn::Sub(set(wedge.z.max), z));
          for (std::size_t p = 0; p < plus; ++p) {
            outside = hn::Or(outside, placed.value(p, planes[p], row, column, z));
          }
          for (std::size_t p = plus; p < count; ++p) {
            outside = hn::Or(outside, hn::Not(placed.value(p, planes[p], row, column, z)));
          }
          outside_bits |= (sign_bits(outside) & group) << shift;
        });
    result[i] = candidates[i] & ~outside_bits;
  }
}

void umbra(const Plane& plane, ZInterval interval, std::span<const Block> blocks,
           const std::uint64_t* candidates, UmbraBits* result) {
  const std::uint64_t group = (std::uint64_t{1} << hn::Lanes(d)) - 1;
  BlockPlanes placed;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    UmbraBits bits;
    if (candidates[i] != 0) placed.place(0, plane, blocks[i]);
    for_each_group(
        blocks[i], candidates[i], [&](std::size_t row, std::size_t column, V z, std::size_t shift) {
          const std::uint64_t negative = sign_bits(placed.value(0, plane, row, column, z));
          bits.inner |= ((plane.minus ? negative : ~negative) & group) << shift;
          bits.before |= (sign_bits(hn::Sub(z, set(interval.min))) & group) << shift;
          bits.beyond |= (sign_bits(hn::Sub(set(interval.max), z)) & group) << shift;
        });
    result[i] = bits;
  }
}

struct Point {
  V x, y, z;
};

template <typename Linear>  // Row or Plane
V at(const Linear& row, const Point& p) {
  const V ab = hn::Add(hn::Mul(set(row.a), p.x), hn::Mul(set(row.b), p.y));
  return hn::Add(hn::Add(ab, hn::Mul(set(row.c), p.z)), set(row.d));
}

V inward(const Plane& plane, const Point& p) {
  const V value = at(plane, p);
  return plane.minus ? hn::Neg(value) : value;
}

V value_of(const LinearTerms& terms, const Point& p) {
  const V front = inward(terms.planes[0], p);
  const V back = inward(terms.planes[1], p);
  const V left = inward(terms.planes[2], p);
  const V right = inward(terms.planes[3], p);
  const V back_left = hn::Mul(back, set(terms.factors[1]));
  const V back_right = hn::Mul(back, set(terms.factors[3]));
  const V thick_left = hn::Add(hn::Mul(front, set(terms.factors[0])), back_left);
  const V thick_right = hn::Add(hn::Mul(front, set(terms.factors[2])), back_right);
  const V to_left = hn::Mul(left, set(terms.factors[4]));
  const V to_right = hn::Mul(right, set(terms.factors[5]));
  const V numerator = hn::Add(hn::Mul(hn::Mul(to_right, back_left), thick_right),
                              hn::Mul(hn::Mul(to_left, back_right), thick_left));
  const V denominator = hn::Mul(hn::Mul(thick_left, thick_right), hn::Add(to_right, to_left));
  const V zero = hn::Zero(d);
  const V one = set(1.0);
  const V s = hn::Div(numerator, denominator);
  const V clamped = hn::IfThenElse(hn::Lt(s, zero), zero, hn::IfThenElse(hn::Gt(s, one), one, s));
  return hn::IfThenElse(hn::Eq(denominator, zero), set(0.5), clamped);
}

struct Part {
  V first, last;
  M alive;
};

void clip(V f0, V f1, Part& part) {
  const V zero = hn::Zero(d);
  const M out0 = hn::Lt(f0, zero);
  const M out1 = hn::Lt(f1, zero);
  const V t = hn::Div(f0, hn::Sub(f0, f1));
  part.alive = hn::AndNot(hn::And(out0, out1), part.alive);
  part.first = hn::IfThenElse(hn::And(out0, hn::Gt(t, part.first)), t, part.first);
  part.last = hn::IfThenElse(hn::And(out1, hn::Lt(t, part.last)), t, part.last);
}

V perimeter(V u, V v) {
  const V zero = hn::Zero(d);
  const M sideways = hn::Ge(hn::Abs(u), hn::Abs(v));
  const V numerator = hn::IfThenElse(sideways, v, u);
  const V denominator = hn::IfThenElse(sideways, u, v);
  const V ratio = hn::Div(numerator, denominator);
  const V side = hn::Add(hn::IfThenElse(hn::Lt(u, zero), set(4.0), zero), ratio);
  const V ends = hn::Sub(hn::IfThenElse(hn::Lt(v, zero), set(6.0), set(2.0)), ratio);
  return hn::IfThenElse(hn::Eq(denominator, zero), zero, hn::IfThenElse(sideways, side, ends));
}

V along(V begin, V t, V direction) { return hn::Add(begin, hn::Mul(t, direction)); }

V value_of(const RectangleTerms& terms, const Point& p) {
  const V u0 = at(terms.ends[0].u, p);
  const V v0 = at(terms.ends[0].v, p);
  const V w0 = at(terms.ends[0].w, p);
  const V u1 = at(terms.ends[1].u, p);
  const V v1 = at(terms.ends[1].v, p);
  const V w1 = at(terms.ends[1].w, p);
  const V zero = hn::Zero(d);
  Part part{zero, set(1.0), hn::Eq(zero, zero)};
  clip(hn::Sub(w0, u0), hn::Sub(w1, u1), part);
  clip(hn::Add(w0, u0), hn::Add(w1, u1), part);
  clip(hn::Sub(w0, v0), hn::Sub(w1, v1), part);
  clip(hn::Add(w0, v0), hn::Add(w1, v1), part);
  part.alive = hn::And(part.alive, hn::Lt(part.first, part.last));
  const V du = hn::Sub(u1, u0);
  const V dv = hn::Sub(v1, v0);
  const V dw = hn::Sub(w1, w0);
  const V pu = along(u0, part.first, du);
  const V pv = along(v0, part.first, dv);
  const V qu = along(u0, part.last, du);
  const V qv = along(v0, part.last, dv);
  const V w = hn::Mul(along(w0, part.first, dw), along(w0, part.last, dw));
  part.alive = hn::And(part.alive, hn::Gt(w, zero));
  V turn = hn::Sub(perimeter(qu, qv), perimeter(pu, pv));
  turn = hn::IfThenElse(hn::Gt(turn, set(4.0)), hn::Sub(turn, set(8.0)), turn);
  turn = hn::IfThenElse(hn::Lt(turn, set(-4.0)), hn::Add(turn, set(8.0)), turn);
  const V cross = hn::Div(hn::Sub(hn::Mul(pu, qv), hn::Mul(pv, qu)), w);
  return hn::IfThenElseZero(part.alive, hn::Mul(hn::Abs(hn::Sub(turn, cross)), set(0.125)));
}

V upper_angles(V y, V x) {
  const V zero = hn::Zero(d);
  const V ax = hn::Abs(x);
  const M steep = hn::Lt(ax, y);
  const V small = hn::IfThenElse(steep, ax, y);
  const V large = hn::IfThenElse(steep, y, ax);
  const M shift = hn::Gt(small, hn::Mul(set(kTanEighthPi), large));
  const V r = hn::Div(hn::IfThenElse(shift, hn::Sub(small, large), small),
                      hn::IfThenElse(shift, hn::Add(small, large), large));
  const V w = hn::Mul(r, r);
  V p = set(kAtanCoefficients.back());
  for (std::size_t i = kAtanCoefficients.size() - 1; i-- > 0;) {
    p = hn::Add(hn::Mul(p, w), set(kAtanCoefficients[i]));
  }
  V angle = hn::Add(hn::Mul(r, p), hn::IfThenElse(shift, set(kQuarterPi), zero));
  angle = hn::IfThenElse(steep, hn::Sub(set(kHalfPi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(set(kPi), angle), angle);
  return hn::IfThenElse(hn::Eq(large, zero), zero, angle);
}

struct Vector {
  V x, y, z;
};
V dot(const Vector& a, const Vector& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
Vector broadcast(const glm::dvec3& v) { return {set(v.x), set(v.y), set(v.z)}; }
Vector scale(V w, const Vector& a) { return {hn::Mul(w, a.x), hn::Mul(w, a.y), hn::Mul(w, a.z)}; }
Vector minus(const Vector& a, const Vector& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
Vector along(const Vector& begin, V t, const Vector& direction) {
  return {along(begin.x, t, direction.x), along(begin.y, t, direction.y),
          along(begin.z, t, direction.z)};
}

V value_of(const SphereTerms& terms, const Point& point) {
  const V zero = hn::Zero(d);
  const Vector p{at(terms.x, point), at(terms.y, point), at(terms.z, point)};
  const V w = at(terms.w, point);
  const V pp = dot(p, p);
  const V g = hn::Sub(pp, hn::Mul(w, w));
  M alive = hn::Gt(g, zero);
  const Vector v = minus(scale(w, broadcast(terms.begin)), p);
  const Vector e = scale(w, broadcast(terms.edge));
  const V vp = dot(v, p);
  const V ep = dot(e, p);
  const V a = hn::Sub(hn::Mul(ep, ep), hn::Mul(g, dot(e, e)));
  const V b = hn::Sub(hn::Mul(vp, ep), hn::Mul(g, dot(v, e)));
  const V c = hn::Sub(hn::Mul(vp, vp), hn::Mul(g, dot(v, v)));
  const V discriminant = hn::Sub(hn::Mul(b, b), hn::Mul(a, c));
  const M positive = hn::Gt(discriminant, zero);
  const M crosses = hn::Lt(a, zero);
  alive = hn::And(alive, hn::Or(positive, hn::Not(crosses)));
  const V root = hn::Sqrt(hn::IfThenElseZero(positive, discriminant));
  const V q = hn::IfThenElse(hn::Lt(b, zero), hn::Sub(root, b), hn::Neg(hn::Add(b, root)));
  const V r0 = hn::Div(q, a);
  const V r1 = hn::Div(c, q);
  const M ordered = hn::Lt(r0, r1);
  const V low = hn::IfThenElse(ordered, r0, r1);
  const V high = hn::IfThenElse(ordered, r1, r0);
  const M towards = hn::Lt(ep, zero);
  const V enter = hn::IfThenElse(crosses, low, high);
  const V leave = hn::IfThenElse(crosses, high, low);
  const M enters = hn::And(hn::Or(crosses, towards), hn::Gt(enter, zero));
  const M leaves = hn::And(hn::Or(crosses, hn::Not(towards)), hn::Lt(leave, set(1.0)));
  const V first = hn::IfThenElse(enters, enter, zero);
  const V last = hn::IfThenElse(leaves, leave, set(1.0));
  const V axial0 = along(vp, first, ep);
  const V axial1 = along(vp, last, ep);
  alive = hn::And(alive, hn::Lt(first, last));
  alive = hn::And(alive, hn::And(hn::Lt(axial0, zero), hn::Lt(axial1, zero)));
  const V axial = hn::Div(hn::Mul(axial0, axial1), pp);
  const V inline_part = hn::Sub(dot(along(v, first, e), along(v, last, e)), axial);
  const V ww = hn::Mul(w, w);
  const V triple = hn::Mul(hn::Mul(hn::Sub(last, first), ww), dot(p, broadcast(terms.normal)));
  const V across = hn::Div(hn::Abs(triple), hn::Sqrt(pp));
  const V cross = hn::Div(hn::Mul(across, g), hn::Mul(axial, ww));
  const V area = hn::Sub(upper_angles(across, inline_part), cross);
  return hn::IfThenElseZero(alive, hn::Mul(area, set(0.5 / kPi)));
}

// Points gathered so that every lane has work.
class Packed {
 public:
  bool full() const { return count_ > kCapacity - kBlock; }
  std::size_t count() const { return count_; }

  void add(const Block& block, std::uint64_t bits) {
    for_each_group(block, bits, [&](std::size_t row, std::size_t column, V z, std::size_t shift) {
      std::array<std::uint8_t, 8> bytes{};
      bytes[0] = static_cast<std::uint8_t>(bits >> shift);
      const M mask = hn::LoadMaskBits(d, bytes.data());
      const V x = hn::Add(hn::Iota(d, static_cast<double>(column)), set(block.bx * 8.0 + 0.5));
      hn::StoreU(set(block.by * 8.0 + static_cast<double>(row) + 0.5), d, &y_[count_]);
      hn::CompressStore(x, mask, d, &x_[count_]);
      count_ += hn::CompressStore(z, mask, d, &z_[count_]);
    });
  }

  /// Evaluates and forgets all points; returns the end of their words.
  template <typename Terms>
  std::int64_t* flush(const Terms& terms, double one, std::int64_t* words) {
    std::array<std::int64_t, kCapacity + kBlock> rounded;
    const auto magic = hn::BitCast(di, set(kRoundMagic));
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d)) {
      const Point p{hn::LoadU(d, &x_[i]), hn::LoadU(d, &y_[i]), hn::LoadU(d, &z_[i])};
      const V shifted = hn::Add(hn::Mul(value_of(terms, p), set(one)), set(kRoundMagic));
      hn::StoreU(hn::Sub(hn::BitCast(di, shifted), magic), di, &rounded[i]);
    }
    std::memcpy(words, rounded.data(), count_ * sizeof(std::int64_t));
    words += count_;
    count_ = 0;
    return words;
  }

 private:
  static constexpr std::size_t kCapacity = 256;
  std::array<double, kCapacity + kBlock> x_{}, y_{}, z_{};
  std::size_t count_ = 0;
};

template <typename Terms>
void words_of(const Terms& terms, double one, std::span<const Block> blocks,
              const std::uint64_t* sets, std::int64_t* result) {
  Packed packed;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (int row = 0; row < kBlock; ++row) {
      const std::uint64_t bits = sets[i] & (std::uint64_t{0xff} << (8 * row));
      if (bits == 0) continue;
      packed.add(blocks[i], bits);
      if (packed.full()) result = packed.flush(terms, one, result);
    }
  }
  packed.flush(terms, one, result);
}

void words(const LightTerms& terms, double one, std::span<const Block> blocks,
           const std::uint64_t* sets, std::int64_t* result) {
  std::visit([&](const auto& kind) { words_of(kind, one, blocks, sets, result); }, terms);
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

#pragma once

#include <cstdint>

#include "model/datapath/inside_test.h"
#include "traces/trace.h"

namespace wedgesim::model {

struct ZInterval {
  double min = 0.0;
  double max = 0.0;
};

/// A tile's extent: pixel edges in x and y, the closed interval of its stored depths in z.
struct Box {
  double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
  ZInterval z;
};

/// A value linear in (x, y, z, 1), window space, evaluated in the one order that every kernel
/// keeps.
template <typename Real>
struct RowOf {
  Real a{}, b{}, c{}, d{};
  Real at(Real x, Real y, Real z) const { return ((a * x + b * y) + c * z) + d; }
};
using Row = RowOf<double>;

/// What evaluates a plane. single_precision: its coefficients are floats, and so is every result.
/// fixed: integers; z is in steps.
enum class Arithmetic { double_precision, single_precision, fixed };

/// A plane reference, resolved. With v = ((a*x + b*y) + c*z) + d and s = (v >= 0) a plus reference
/// is inside iff s, a minus reference iff not s.
struct Plane {
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
  bool minus = false;
  Arithmetic arithmetic = Arithmetic::double_precision;
  datapath::FixedForm form{};  // of the fixed datapath, which decides by it

  double value(double x, double y, double z) const {
    if (arithmetic != Arithmetic::single_precision) return Row{a, b, c, d}.at(x, y, z);
    const auto single = [](double real) { return static_cast<float>(real); };
    return RowOf<float>{single(a), single(b), single(c), single(d)}.at(single(x), single(y),
                                                                       single(z));
  }
  bool inside(double x, double y, double z) const {
    if (arithmetic == Arithmetic::fixed) return (form.at(datapath::place(x, y, z)) >= 0) != minus;
    return (value(x, y, z) >= 0.0) != minus;
  }
  /// The value seen from inside: positive inside, whatever the sign of the reference.
  double inward(double x, double y, double z) const {
    return minus ? -value(x, y, z) : value(x, y, z);
  }
  /// The sign of d(inside)/dz: positive if far points are inside.
  double inward_c() const { return minus ? -c : c; }
  Plane complement() const {
    Plane other = *this;
    other.minus = !minus;
    return other;
  }

  /// Is the box's corner in x and y that is the most inside, at depth z, inside? If not, no point
  /// of the box at that depth is: rounding is monotone and corners are evaluated as pixels are.
  bool reaches(const Box& box, double z) const {
    return inside((a >= 0.0) != minus ? box.x1 : box.x0, (b >= 0.0) != minus ? box.y1 : box.y0, z);
  }
  /// Is the corner that is the least inside, at depth z, inside? If so, every point is.
  bool holds(const Box& box, double z) const {
    return inside((a >= 0.0) != minus ? box.x0 : box.x1, (b >= 0.0) != minus ? box.y0 : box.y1, z);
  }
};

/// \param reference  2 * index + sign, index in range
inline Plane resolve(const traces::TraceView& trace, std::uint32_t reference) {
  const traces::fb::Plane& plane = trace.planes[traces::plane_index(reference)];
  // d + 0 turns -0 into +0, so that no value is ever -0 and its sign bit alone decides.
  return {plane.a(), plane.b(), plane.c(), plane.d() + 0.0, traces::is_minus(reference)};
}

}  // namespace wedgesim::model

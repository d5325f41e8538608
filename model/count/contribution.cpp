#include "model/count/contribution.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/count/atan.h"
#include "model/datapath/disc_frame.h"

namespace wedgesim::model {
namespace {

glm::dvec3 vec(const traces::fb::Vec3& v) { return {v.x(), v.y(), v.z()}; }

Row matrix_row(const traces::fb::Matrix4& matrix, std::uint16_t row) {
  const auto& columns = *matrix.columns();
  const auto at = [&](std::uint16_t column) {
    return columns[static_cast<std::uint16_t>(4 * column + row)];
  };
  return {at(0), at(1), at(2), at(3)};
}

// p f + q g + r h
Row combine(const Row& p, double f, const Row& q, double g, const Row& r = {}, double h = 0.0) {
  const auto form = [](const Row& row) { return datapath::LinearForm{row.a, row.b, row.c, row.d}; };
  const datapath::LinearForm sum = datapath::combine(form(p), f, form(q), g, form(r), h);
  return {sum.a, sum.b, sum.c, sum.d};
}

// With H the point's distance from the light's plane and h the edge's, the line from the point
// through the edge end meets the plane at (H*u - h*U, H*v - h*V) / (H - h*W).
RectangleTerms rectangle_terms(const traces::fb::Matrix4& light_from_window,
                               const glm::dvec3& begin, const glm::dvec3& end) {
  const Row u = matrix_row(light_from_window, 0);
  const Row v = matrix_row(light_from_window, 1);
  const Row h = matrix_row(light_from_window, 2);
  const Row w = matrix_row(light_from_window, 3);
  const auto project = [&](const glm::dvec3& e) {
    return RectangleTerms::End{combine(h, e.x, u, -e.z), combine(h, e.y, v, -e.z),
                               combine(h, 1.0, w, -e.z)};
  };
  return {{project(begin), project(end)}};
}

RowOf<float> single(const Row& row) {
  return {static_cast<float>(row.a), static_cast<float>(row.b), static_cast<float>(row.c),
          static_cast<float>(row.d)};
}

LinearTermsOf<float> single(const LinearTerms& terms) {
  LinearTermsOf<float> result;
  std::ranges::transform(terms.planes, result.planes.begin(), single_plane);
  std::ranges::transform(terms.factors, result.factors.begin(),
                         [](double factor) { return static_cast<float>(factor); });
  return result;
}

RectangleTermsOf<float> single(const RectangleTerms& terms) {
  const auto end = [](const RectangleTerms::End& e) {
    return RectangleTermsOf<float>::End{single(e.u), single(e.v), single(e.w)};
  };
  return {{end(terms.ends[0]), end(terms.ends[1])}};
}

SphereTermsOf<float> single(const SphereTerms& terms) {
  const auto real = [](double x) { return static_cast<float>(x); };
  return {single(terms.along),
          single(terms.out),
          single(terms.normal),
          single(terms.w),
          real(terms.distance),
          real(terms.distance_squared),
          {real(terms.ends[0]), real(terms.ends[1])}};
}

// What is left of a segment: shares of its length that are cut off from its begin and from its end,
// and those left from there on to the other end. Neither is 1 less the other: a point next to one
// end keeps its digits, however far away the other is.
template <typename Real>
struct Cut {
  Real begin = 0.0, left_of_begin = 1.0;
  Real end = 0.0, left_of_end = 1.0;
};

// Keeps the part where a value that goes linearly from f0 to f1 is not negative. False: nothing.
template <typename Real>
bool clip(Real f0, Real f1, Cut<Real>& cut) {
  if (f0 < 0.0 && f1 < 0.0) return false;
  const Real per_length = Real(1.0) / (f0 - f1);
  const Real share = (f0 < 0.0 ? f0 : -f1) * per_length;  // of the end that is outside
  const Real left = (f0 < 0.0 ? -f1 : f0) * per_length;
  if (f0 < 0.0 && share > cut.begin) {
    cut.begin = share;
    cut.left_of_begin = left;
  }
  if (f1 < 0.0 && share > cut.end) {
    cut.end = share;
    cut.left_of_end = left;
  }
  return true;
}

// Where the ray from the centre through (u, v) leaves the square [-1, 1]^2, as a distance along
// its outline from (1, 0), counter-clockwise: [-1, 7]. 0 at the centre itself.
template <typename Real>
Real perimeter(Real u, Real v) {
  const bool sideways = std::fabs(u) >= std::fabs(v);
  const Real numerator = sideways ? v : u;
  const Real denominator = sideways ? u : v;
  if (denominator == 0.0) return 0.0;
  const Real ratio = numerator / denominator;
  return sideways ? Real(u < 0.0 ? 4 : 0) + ratio : Real(v < 0.0 ? 6 : 2) - ratio;
}

}  // namespace

template <typename Real>
Real upper_angle(Real y, Real x) {
  const Real ax = std::fabs(x);
  const Real small = ax < y ? ax : y;
  const Real large = ax < y ? y : ax;
  if (large == 0.0) return 0.0;
  const bool shift =
      small > Real(kTanEighthPi) * large;  // atan(m) = pi/4 + atan((m - 1) / (m + 1))
  const Real r = shift ? (small - large) / (small + large) : small / large;
  const Real w = r * r;
  auto p = Real(kAtanCoefficients.back());
  for (std::size_t i = kAtanCoefficients.size() - 1; i-- > 0;)
    p = p * w + Real(kAtanCoefficients[i]);
  Real angle = r * p + (shift ? Real(kQuarterPi) : Real(0));
  if (ax < y) angle = Real(kHalfPi) - angle;
  return x < 0.0 ? Real(kPi) - angle : angle;
}

SphereTerms sphere_terms(const std::array<Row, 4>& light, const glm::dvec3& begin,
                         const glm::dvec3& end) {
  const datapath::DiscFrame frame = datapath::disc_frame(begin, end);
  const auto component = [&](const glm::dvec3& axis) {
    return combine(light[0], axis.x, light[1], axis.y, light[2], axis.z);
  };
  return {component(frame.along),
          component(frame.out),
          component(frame.normal),
          light[3],
          frame.distance,
          frame.distance * frame.distance,
          frame.ends};
}

LightTerms light_terms(const traces::TraceView& trace, const traces::fb::Wedge& wedge) {
  if (wedge.kind() == traces::fb::WedgeKind_linear) {
    LinearTerms terms;
    for (std::uint16_t i = 0; i < 4; ++i) terms.planes[i] = resolve(trace, (*wedge.planes())[i]);
    for (std::uint16_t i = 0; i < 6; ++i) terms.factors[i] = (*wedge.linear_factors())[i];
    return terms;
  }
  const traces::Light& light = trace.header.lights[wedge.light()];
  const glm::dvec3 begin = vec(wedge.edge_begin());
  const glm::dvec3 end = vec(wedge.edge_end());
  if (light.shape == traces::fb::LightShape_sphere) {
    const auto row = [&](std::uint16_t i) { return matrix_row(light.light_from_window, i); };
    return sphere_terms({row(0), row(1), row(2), row(3)}, begin, end);
  }
  return rectangle_terms(light.light_from_window, begin, end);
}

Plane single_plane(const Plane& plane) {
  const auto single = [](double real) { return static_cast<double>(static_cast<float>(real)); };
  return {single(plane.a), single(plane.b), single(plane.c),
          single(plane.d), plane.minus,     Arithmetic::single_precision};
}

SingleTerms single_terms(const traces::TraceView& trace, const traces::fb::Wedge& wedge) {
  const LightTerms terms = light_terms(trace, wedge);
  if (const auto* linear = std::get_if<LinearTerms>(&terms)) return single(*linear);
  if (const auto* sphere = std::get_if<SphereTerms>(&terms)) return single(*sphere);
  return single(std::get<RectangleTerms>(terms));
}

template <typename Real>
Real intensity(const LinearTermsOf<Real>& terms, std::type_identity_t<Real> x,
               std::type_identity_t<Real> y, std::type_identity_t<Real> z) {
  const auto inward = [&](std::size_t i) { return Real(terms.planes[i].inward(x, y, z)); };
  const Real front = inward(0);
  const Real back = inward(1);
  const Real left = inward(2);
  const Real right = inward(3);
  const Real back_left = back * terms.factors[1];
  const Real back_right = back * terms.factors[3];
  const Real thick_left = front * terms.factors[0] + back_left;
  const Real thick_right = front * terms.factors[2] + back_right;
  const Real to_left = left * terms.factors[4];
  const Real to_right = right * terms.factors[5];
  // s = (to_right * s_left + to_left * s_right) / (to_right + to_left), over one denominator.
  const Real numerator = to_right * back_left * thick_right + to_left * back_right * thick_left;
  const Real denominator = thick_left * thick_right * (to_right + to_left);
  if (denominator == 0.0) return Real(0.5);
  const Real s = numerator / denominator;
  return s < 0.0 ? Real(0) : (s > 1.0 ? Real(1) : s);
}

template <typename Real>
Real coverage(const RectangleTermsOf<Real>& terms, std::type_identity_t<Real> x,
              std::type_identity_t<Real> y, std::type_identity_t<Real> z) {
  const Real u0 = terms.ends[0].u.at(x, y, z);
  const Real v0 = terms.ends[0].v.at(x, y, z);
  const Real w0 = terms.ends[0].w.at(x, y, z);
  const Real u1 = terms.ends[1].u.at(x, y, z);
  const Real v1 = terms.ends[1].v.at(x, y, z);
  const Real w1 = terms.ends[1].w.at(x, y, z);
  Cut<Real> cut;
  if (!clip(w0 - u0, w1 - u1, cut) || !clip(w0 + u0, w1 + u1, cut) ||
      !clip(w0 - v0, w1 - v1, cut) || !clip(w0 + v0, w1 + v1, cut)) {
    return 0.0;
  }
  if (!(cut.begin + cut.end < 1.0)) return 0.0;
  const auto first = [&](Real at0, Real at1) { return cut.left_of_begin * at0 + cut.begin * at1; };
  const auto last = [&](Real at0, Real at1) { return cut.end * at0 + cut.left_of_end * at1; };
  const Real pu = first(u0, u1);
  const Real pv = first(v0, v1);
  const Real qu = last(u0, u1);
  const Real qv = last(v0, v1);
  const Real w = first(w0, w1) * last(w0, w1);
  if (!(w > 0.0)) return 0.0;
  Real turn = perimeter(qu, qv) - perimeter(pu, pv);
  if (turn > 4.0) turn = turn - Real(8);
  if (turn < -4.0) turn = turn + Real(8);
  return std::fabs(turn - (pu * qv - pv * qu) / w) * Real(0.125);
}

template <typename Real>
Real coverage(const SphereTermsOf<Real>& terms, std::type_identity_t<Real> x,
              std::type_identity_t<Real> y, std::type_identity_t<Real> z) {
  const Real along = terms.along.at(x, y, z);
  const Real out = terms.out.at(x, y, z);
  const Real normal = terms.normal.at(x, y, z);
  const Real w = terms.w.at(x, y, z);
  const Real beyond = w * terms.distance - out;
  const Real normal2 = normal * normal;
  const Real w2 = w * w;
  const Real radius2 = along * along + out * out + normal2;
  const Real tangent2 = radius2 - w2;
  const Real reach2 = normal2 + beyond * beyond;
  if (!(tangent2 > 0.0) || !(reach2 > 0.0)) return 0.0;
  const Real height2 = terms.distance_squared * normal2 / reach2;
  if (!(height2 < 1.0)) return 0.0;
  // The tangents of the ends' angles from the centre: disc_coverage.cpp.
  const Real limit = std::sqrt((Real(1) - height2) * w2 / tangent2);
  const Real reach = std::sqrt(reach2);
  const Real axial_out = normal2 - out * beyond;
  std::array<Real, 2> tangents{-limit, limit};
  int ahead = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Real axial = axial_out - along * (w * terms.ends[i] - along);
    if (!(axial > 0.0)) continue;
    const Real turn = along * terms.distance - out * terms.ends[i];
    const Real tangent = w * (normal2 * terms.ends[i] + beyond * turn) / (reach * axial);
    tangents[i] = tangent < -limit ? -limit : (tangent > limit ? limit : tangent);
    ++ahead;
  }
  const auto [first, last] = tangents;
  if (ahead == 0 || !(first < last)) return 0.0;
  const Real point2 = radius2 / w2;
  const Real length = std::sqrt(height2 * point2) * (last - first);
  const Real inline_part = height2 + point2 * (first * last);
  const Real triangle = length * tangent2 / (radius2 - height2 * w2);
  return (upper_angle(length, inline_part) - triangle) * Real(0.5 / kPi);
}

template float upper_angle(float, float);
template double upper_angle(double, double);
template float intensity(const LinearTermsOf<float>&, float, float, float);
template double intensity(const LinearTerms&, double, double, double);
template float coverage(const RectangleTermsOf<float>&, float, float, float);
template double coverage(const RectangleTerms&, double, double, double);
template float coverage(const SphereTermsOf<float>&, float, float, float);
template double coverage(const SphereTerms&, double, double, double);

float unsaturated(const SingleTerms& terms, float x, float y, float z) {
  if (const auto* linear = std::get_if<LinearTermsOf<float>>(&terms)) {
    return intensity(*linear, x, y, z);
  }
  if (const auto* sphere = std::get_if<SphereTermsOf<float>>(&terms)) {
    return coverage(*sphere, x, y, z);
  }
  return coverage(std::get<RectangleTermsOf<float>>(terms), x, y, z);
}

double contribution(const LightTerms& terms, double x, double y, double z) {
  if (const auto* fixed = std::get_if<FixedTerms>(&terms)) {
    return datapath::contribution(fixed->setup, datapath::place(x, y, z), fixed->round);
  }
  if (const auto* single = std::get_if<SingleTerms>(&terms)) {
    const float value =
        unsaturated(*single, static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    if (!(value > 0.0F)) return 0.0;
    return value < 1.0F ? static_cast<double>(value) : 1.0;
  }
  if (const auto* linear = std::get_if<LinearTerms>(&terms)) return intensity(*linear, x, y, z);
  if (const auto* sphere = std::get_if<SphereTerms>(&terms)) return coverage(*sphere, x, y, z);
  return coverage(std::get<RectangleTerms>(terms), x, y, z);
}

}  // namespace wedgesim::model

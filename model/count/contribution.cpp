#include "model/count/contribution.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/count/atan.h"

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

// p * f - q * g
Row combine(const Row& p, double f, const Row& q, double g) {
  return {p.a * f - q.a * g, p.b * f - q.b * g, p.c * f - q.c * g, p.d * f - q.d * g};
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
    return RectangleTerms::End{combine(h, e.x, u, e.z), combine(h, e.y, v, e.z),
                               combine(h, 1.0, w, e.z)};
  };
  return {{project(begin), project(end)}};
}

SphereTerms sphere_terms(const traces::fb::Matrix4& light_from_window, const glm::dvec3& begin,
                         const glm::dvec3& end) {
  return {matrix_row(light_from_window, 0),
          matrix_row(light_from_window, 1),
          matrix_row(light_from_window, 2),
          matrix_row(light_from_window, 3),
          begin,
          end - begin,
          glm::cross(begin, end)};
}

// The part [first, last] of a segment, 0 at its begin and 1 at its end.
struct Part {
  double first = 0.0;
  double last = 1.0;
};

// Keeps the part where a value that goes linearly from f0 to f1 is not negative. False: nothing.
bool clip(double f0, double f1, Part& part) {
  if (f0 < 0.0 && f1 < 0.0) return false;
  const double t = f0 / (f0 - f1);
  if (f0 < 0.0 && t > part.first) part.first = t;
  if (f1 < 0.0 && t < part.last) part.last = t;
  return true;
}

// Where the ray from the centre through (u, v) leaves the square [-1, 1]^2, as a distance along
// its outline from (1, 0), counter-clockwise: [-1, 7]. 0 at the centre itself.
double perimeter(double u, double v) {
  const bool sideways = std::fabs(u) >= std::fabs(v);
  const double numerator = sideways ? v : u;
  const double denominator = sideways ? u : v;
  if (denominator == 0.0) return 0.0;
  const double ratio = numerator / denominator;
  return sideways ? (u < 0.0 ? 4.0 : 0.0) + ratio : (v < 0.0 ? 6.0 : 2.0) - ratio;
}

}  // namespace

double upper_angle(double y, double x) {
  const double ax = std::fabs(x);
  const double small = ax < y ? ax : y;
  const double large = ax < y ? y : ax;
  if (large == 0.0) return 0.0;
  const bool shift = small > kTanEighthPi * large;  // atan(m) = pi/4 + atan((m - 1) / (m + 1))
  const double r = shift ? (small - large) / (small + large) : small / large;
  const double w = r * r;
  double p = kAtanCoefficients.back();
  for (std::size_t i = kAtanCoefficients.size() - 1; i-- > 0;) p = p * w + kAtanCoefficients[i];
  double angle = r * p + (shift ? kQuarterPi : 0.0);
  if (ax < y) angle = kHalfPi - angle;
  return x < 0.0 ? kPi - angle : angle;
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
    return sphere_terms(light.light_from_window, begin, end);
  }
  return rectangle_terms(light.light_from_window, begin, end);
}

double intensity(const LinearTerms& terms, double x, double y, double z) {
  const double front = terms.planes[0].inward(x, y, z);
  const double back = terms.planes[1].inward(x, y, z);
  const double left = terms.planes[2].inward(x, y, z);
  const double right = terms.planes[3].inward(x, y, z);
  const double back_left = back * terms.factors[1];
  const double back_right = back * terms.factors[3];
  const double thick_left = front * terms.factors[0] + back_left;
  const double thick_right = front * terms.factors[2] + back_right;
  const double to_left = left * terms.factors[4];
  const double to_right = right * terms.factors[5];
  // s = (to_right * s_left + to_left * s_right) / (to_right + to_left), over one denominator.
  const double numerator = to_right * back_left * thick_right + to_left * back_right * thick_left;
  const double denominator = thick_left * thick_right * (to_right + to_left);
  if (denominator == 0.0) return 0.5;
  const double s = numerator / denominator;
  return s < 0.0 ? 0.0 : (s > 1.0 ? 1.0 : s);
}

double coverage(const RectangleTerms& terms, double x, double y, double z) {
  const double u0 = terms.ends[0].u.at(x, y, z);
  const double v0 = terms.ends[0].v.at(x, y, z);
  const double w0 = terms.ends[0].w.at(x, y, z);
  const double u1 = terms.ends[1].u.at(x, y, z);
  const double v1 = terms.ends[1].v.at(x, y, z);
  const double w1 = terms.ends[1].w.at(x, y, z);
  Part part;
  if (!clip(w0 - u0, w1 - u1, part) || !clip(w0 + u0, w1 + u1, part) ||
      !clip(w0 - v0, w1 - v1, part) || !clip(w0 + v0, w1 + v1, part)) {
    return 0.0;
  }
  if (!(part.first < part.last)) return 0.0;
  const double du = u1 - u0;
  const double dv = v1 - v0;
  const double dw = w1 - w0;
  const double pu = u0 + part.first * du;
  const double pv = v0 + part.first * dv;
  const double qu = u0 + part.last * du;
  const double qv = v0 + part.last * dv;
  const double w = (w0 + part.first * dw) * (w0 + part.last * dw);
  if (!(w > 0.0)) return 0.0;
  double turn = perimeter(qu, qv) - perimeter(pu, pv);
  if (turn > 4.0) turn = turn - 8.0;
  if (turn < -4.0) turn = turn + 8.0;
  return std::fabs(turn - (pu * qv - pv * qu) / w) * 0.125;
}

double coverage(const SphereTerms& terms, double x, double y, double z) {
  const double px = terms.x.at(x, y, z);
  const double py = terms.y.at(x, y, z);
  const double pz = terms.z.at(x, y, z);
  const double w = terms.w.at(x, y, z);
  const double pp = px * px + py * py + pz * pz;
  const double g = pp - w * w;
  if (!(g > 0.0)) return 0.0;
  // From the point towards the edge, times w: v(t) = v + t*d.
  const double vx = w * terms.begin.x - px;
  const double vy = w * terms.begin.y - py;
  const double vz = w * terms.begin.z - pz;
  const double dx = w * terms.edge.x;
  const double dy = w * terms.edge.y;
  const double dz = w * terms.edge.z;
  const double vp = vx * px + vy * py + vz * pz;
  const double dp = dx * px + dy * py + dz * pz;
  // In the tangent cone iff f(t) = (v.p)^2 - g*|v|^2 = A*t^2 + 2*B*t + C >= 0, and v.p < 0.
  const double a = dp * dp - g * (dx * dx + dy * dy + dz * dz);
  const double b = vp * dp - g * (vx * dx + vy * dy + vz * dz);
  const double c = vp * vp - g * (vx * vx + vy * vy + vz * vz);
  double discriminant = b * b - a * c;
  if (a < 0.0 && !(discriminant > 0.0)) return 0.0;
  if (!(discriminant > 0.0)) discriminant = 0.0;
  const double root = std::sqrt(discriminant);
  const double q = b < 0.0 ? root - b : -(b + root);
  const double r0 = q / a;
  const double r1 = c / q;
  const double low = r0 < r1 ? r0 : r1;
  const double high = r0 < r1 ? r1 : r0;
  // Outside the double cone the line is within one half of it between the roots; along it, beyond
  // the root on the side that goes towards the light.
  Part part;
  if ((a < 0.0 || dp < 0.0) && (a < 0.0 ? low : high) > 0.0) part.first = a < 0.0 ? low : high;
  if ((a < 0.0 || !(dp < 0.0)) && (a < 0.0 ? high : low) < 1.0) part.last = a < 0.0 ? high : low;
  if (!(part.first < part.last)) return 0.0;
  const double axial0 = vp + part.first * dp;
  const double axial1 = vp + part.last * dp;
  if (!(axial0 < 0.0) || !(axial1 < 0.0)) return 0.0;
  const double x0 = vx + part.first * dx;
  const double y0 = vy + part.first * dy;
  const double z0 = vz + part.first * dz;
  const double x1 = vx + part.last * dx;
  const double y1 = vy + part.last * dy;
  const double z1 = vz + part.last * dz;
  const double axial = axial0 * axial1 / pp;
  const double inline_part = (x0 * x1 + y0 * y1 + z0 * z1) - axial;
  // p . (v0 x v1) = (last - first) * w^2 * p . (begin x end)
  const double triple = (part.last - part.first) * (w * w) *
                        (px * terms.normal.x + py * terms.normal.y + pz * terms.normal.z);
  const double across = std::fabs(triple) / std::sqrt(pp);
  const double cross = across * g / (axial * (w * w));
  return (upper_angle(across, inline_part) - cross) * (0.5 / kPi);
}

double contribution(const LightTerms& terms, double x, double y, double z) {
  if (const auto* fixed = std::get_if<FixedTerms>(&terms)) {
    return datapath::contribution(fixed->setup, datapath::place(x, y, z), fixed->round);
  }
  if (const auto* linear = std::get_if<LinearTerms>(&terms)) return intensity(*linear, x, y, z);
  if (const auto* sphere = std::get_if<SphereTerms>(&terms)) return coverage(*sphere, x, y, z);
  return coverage(std::get<RectangleTerms>(terms), x, y, z);
}

}  // namespace wedgesim::model

#include "model/datapath/angle.h"

#include <cmath>

namespace wedgesim::model::datapath {
namespace {

constexpr double kTanEighthPi = 0.41421356237309503;
// atan(r) = r + r w (k0 + k1 w + k2 w^2) with w = r^2, fitted at the Chebyshev nodes of
// [0, tan^2(pi/8)].
constexpr double kAtan[] = {-0.3333189655778905, 0.19848097811090756, -0.11819444409601954};

}  // namespace

double upper_angle(double y, double x, Rounder round) {
  const double ax = std::fabs(x);
  const double small = ax < y ? ax : y;
  const double large = ax < y ? y : ax;
  if (large == 0.0) return 0.0;
  // atan(m) = pi/4 + atan((m - 1) / (m + 1))
  const bool shift = small > round(round(kTanEighthPi) * large);
  const double r =
      shift ? round(round(small - large) / round(small + large)) : round(small / large);
  const double w = round(r * r);
  double p = round(kAtan[2]);
  for (int i = 1; i >= 0; --i) p = round(round(p * w) + round(kAtan[i]));
  double angle = round(r + round(r * round(w * p)));
  if (shift) angle = round(round(kPi / 4) + angle);
  if (ax < y) angle = round(round(kPi / 2) - angle);
  return x < 0.0 ? round(round(kPi) - angle) : angle;
}

}  // namespace wedgesim::model::datapath

#include "model/datapath/linear_intensity.h"

#include <algorithm>

namespace wedgesim::model::datapath {

double intensity(const LinearSetup& setup, const Place& at, Rounder round) {
  const auto& k = setup.factors;
  const double front = setup.planes[0].at(at, round);
  const double back = setup.planes[1].at(at, round);
  const double left = setup.planes[2].at(at, round);
  const double right = setup.planes[3].at(at, round);
  const double back_left = round(back * k[1]);
  const double back_right = round(back * k[3]);
  const double thick_left = round(round(front * k[0]) + back_left);
  const double thick_right = round(round(front * k[2]) + back_right);
  const double to_left = round(left * k[4]);
  const double to_right = round(right * k[5]);
  const double lit_left = round(round(to_right * back_left) * thick_right);
  const double lit_right = round(round(to_left * back_right) * thick_left);
  const double thick = round(thick_left * thick_right);
  const double denominator = round(thick * round(to_right + to_left));
  if (denominator == 0.0) return 0.5;
  return std::clamp(round(round(lit_left + lit_right) / denominator), 0.0, 1.0);
}

}  // namespace wedgesim::model::datapath

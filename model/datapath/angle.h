#pragma once

#include "model/datapath/rounder.h"

namespace wedgesim::model::datapath {

inline constexpr double kPi = 3.14159265358979323846;

/// The angle of (x, y) from the x axis, y >= 0: [0, pi]; 0 at the origin. One division and six
/// multiplies: reduced to |angle| <= pi/8, then an odd polynomial.
/// Accuracy: with 18 bits within 2e-5, of which the polynomial is 9e-7 (angle_test.cpp).
double upper_angle(double y, double x, Rounder round);

}  // namespace wedgesim::model::datapath

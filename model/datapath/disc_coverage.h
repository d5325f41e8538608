#pragma once

#include <array>

#include "model/datapath/form.h"
#include "model/datapath/rounder.h"

namespace wedgesim::model::datapath {

/// Per-wedge constants of a spherical light's coverage, in an orthonormal frame about the light's
/// centre, in radii: `along` the silhouette edge, `out` from the centre to the edge's line, and
/// their normal. Each form has an exponent of its own; all values are homogeneous.
struct DiscSetup {
  FixedForm along, out, normal, w;  // the point P, and its homogeneous coordinate
  FixedForm beyond;                 // w distance - out: from the point to the edge's line
  struct End {
    FixedForm along;   // from the point to the edge's end
    FixedForm turn;    // P x end, about the normal
    double end = 0.0;  // the end's own coordinate along the edge, radii
  };
  std::array<End, 2> ends;        // increasing along the edge
  double distance_squared = 0.0;  // of the edge's line from the centre, radii^2
};

/// The fraction of the light's disc that the shadow of one edge hides, without a sign; the disc is
/// bounded by the circle in which the tangent cone from the point touches the sphere: the area
/// between the edge's projection, clipped to the disc, and the circle, as seen between the rays
/// from the centre through its ends.
/// \return      [0, 0.5]; 0 if the edge's projection misses the disc or the point is in the light
/// Source: Paper III, section 3.2.1. Differs: closed form, no table. The plane through the point
/// and the edge passes the centre at H radii, H^2 = distance^2 normal^2 / (normal^2 + beyond^2),
/// and within that plane the edge's ends are at angles from the centre whose tangents come from
/// linear forms alone: nothing that is small is the difference of what is large.
/// Cost: 9 products c * z, 31 multiplies, 7 divisions, 3 roots.
/// Accuracy: with 18 bits within 2e-5 of the exact value (setup_test.cpp).
double coverage(const DiscSetup& setup, const Place& at, Rounder round);

}  // namespace wedgesim::model::datapath

#include "model/datapath/disc_coverage.h"

#include <algorithm>
#include <cmath>

#include "model/datapath/angle.h"

namespace wedgesim::model::datapath {

double coverage(const DiscSetup& setup, const Place& at, Rounder round) {
  const double along = setup.along.at(at, round);
  const double out = setup.out.at(at, round);
  const double normal = setup.normal.at(at, round);
  const double w = setup.w.at(at, round);
  const double beyond = setup.beyond.at(at, round);
  const double normal2 = round(normal * normal);
  const double w2 = round(w * w);
  const double radius2 = round(round(round(along * along) + round(out * out)) + normal2);
  const double tangent2 = round(radius2 - w2);
  const double reach2 = round(normal2 + round(beyond * beyond));
  if (!(tangent2 > 0.0) || reach2 == 0.0) return 0.0;
  const double height2 = round(round(setup.distance_squared * normal2) / reach2);
  if (height2 >= 1.0) return 0.0;

  // The tangents of the ends' angles from the centre, increasing along the edge; beyond +-limit an
  // end is outside the disc, and so it is at more than a right angle, its sign then given by which
  // end it is: the edge spans less than two right angles.
  const double limit = round(std::sqrt(round(round(round(1.0 - height2) * w2) / tangent2)));
  const double reach = round(std::sqrt(reach2));
  const double axial_out = round(normal2 - round(out * beyond));
  std::array<double, 2> tangents{-limit, limit};
  int ahead = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const DiscSetup::End& end = setup.ends[i];
    const double axial = round(axial_out - round(along * end.along.at(at, round)));
    if (!(axial > 0.0)) continue;
    const double turn = round(beyond * end.turn.at(at, round));
    const double sideways = round(w * round(round(normal2 * end.end) + turn));
    tangents[i] = std::clamp(round(sideways / round(reach * axial)), -limit, limit);
    ++ahead;
  }
  const auto [first, last] = tangents;
  if (ahead == 0 || !(first < last)) return 0.0;

  // On the disc the chord is at height H and its ends at P * first and P * last, in one scale.
  const double point2 = round(radius2 / w2);
  const double length = round(round(std::sqrt(round(height2 * point2))) * round(last - first));
  const double inline_part = round(height2 + round(point2 * round(first * last)));
  const double triangle = round(round(length * tangent2) / round(radius2 - round(height2 * w2)));
  const double area = round(upper_angle(length, inline_part, round) - triangle);
  return std::clamp(round(area * round(0.5 / kPi)), 0.0, 0.5);
}

}  // namespace wedgesim::model::datapath

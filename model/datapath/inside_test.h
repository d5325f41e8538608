#pragma once

#include "model/datapath/form.h"

namespace wedgesim::model::datapath {

/// A plane reference. With s = (value >= 0), a plus reference is inside iff s, a minus reference
/// iff not s, so a point on a shared plane is in exactly one wedge.
struct FixedPlane {
  FixedForm form;
  bool minus = false;

  bool inside(const Place& place) const { return (form.at(place) >= 0) != minus; }
};

/// A tile's box in half pixels and steps.
struct FixedBox {
  Place low, high;
};

/// Is the corner of a box that is the most inside a plane, inside? If not, no point of it is.
inline bool reaches(const FixedPlane& plane, const FixedBox& box) {
  const auto pick = [&](std::int64_t slope, std::int64_t low, std::int64_t high) {
    return (slope >= 0) != plane.minus ? high : low;
  };
  return plane.inside({pick(plane.form.a, box.low.x, box.high.x),
                       pick(plane.form.b, box.low.y, box.high.y),
                       pick(plane.form.c, box.low.z, box.high.z)});
}

/// Is the corner that is the least inside, inside? If so, every point of the box is.
inline bool holds(const FixedPlane& plane, const FixedBox& box) {
  FixedPlane outside = plane;
  outside.minus = !plane.minus;
  return !reaches(outside, box);
}

}  // namespace wedgesim::model::datapath

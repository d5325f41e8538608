#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/count/operands.h"
#include "model/count/primitive.h"

namespace wedgesim::model {

/// How far a primitive's share in a pixel's light intensity may be off, units of full light.
struct Doubt {
  std::size_t pixel = 0;               // row-major
  double li = 0.0;                     // at least 0
  double nearer = 0.0, farther = 0.0;  // what the share changes if the stored z moves one step
};

/// What rounding in the datapath may change, said of itself: from its forms, its words and its
/// formulas, without a second arithmetic and without a judge.
///
/// A form a x + b y + c z + d is off at a pixel by at most E:
/// - `fixed`: half a unit in each coefficient, (X + Y + Z + 1) / 2 units, X and Y the pixel's in
///   half pixels, Z its depth in steps;
/// - in floating point: 4 u (|a| X + |b| Y + |c| Z + |d|), u = 2^-24 or 2^-53.
/// A plane within E of 0 may be decided either way. The light intensity or coverage is off by the
/// sum of what moving each of its forms by up to 2 E changes: sides are told by differences of two.
/// Where several stored depths share one depth of the datapath, the next depths on either side are
/// asked, too. A bound to first order: forms are moved one at a time; an edge of which too little
/// is sure may hide all. What the trace's own numbers, in double, have lost is not in it.
class RoundingBound {
 public:
  /// \param operands  of the same datapath
  RoundingBound(const Operands& operands, const Datapath& datapath);

  /// The pixels at which a primitive's share may be off, or changes with a step of z, in order.
  std::vector<Doubt> operator()(const Primitive& primitive) const;

 private:
  struct Pixel {
    std::size_t index = 0;
    int column = 0, row = 0;
    std::array<double, 3> z{};  // the datapath's, and where depths share one, its neighbours
    std::size_t depths = 1;     // how many of z
    double nearer = 0.0, farther = 0.0;  // of the stored depths beside it
  };
  std::vector<Pixel> pixels_;
};

}  // namespace wedgesim::model

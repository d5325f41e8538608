#pragma once

#include <array>
#include <span>
#include <vector>

#include "functional/reference/judge_end.h"
#include "functional/reference/judge_plane.h"

namespace wedgesim::functional {

/// A unit vector, and how many times its own rounding the vectors that it was made from lost.
struct Direction {
  RealVector way;
  double loss = 1.0;
};

/// Of a rectangular light, from its centre, in the order of light_corners: LinearCorner::touched
/// says which.
std::array<RealVector, 4> rectangle_corners(const Light& light);

/// A `linear` wedge in 200 bits, for places relative to the light's centre.
class JudgedWedge {
 public:
  /// Light intensity that it adds at a place (Paper I, Eqs. 2 and 3); 0 outside.
  Real share(const JudgedPlace& place) const;
  /// Front, back, left, right, end.
  const std::array<JudgedPlane, kLinearPlanes>& planes() const { return planes_; }

 private:
  friend class JudgedLoop;
  std::array<JudgedPlane, kLinearPlanes> planes_;
  // How fast one gets nearer to front and back plane along the directions in the left and the right
  // side plane, and to the side planes along the edge.
  std::array<std::array<Real, 2>, 2> slopes_;
  std::array<Real, 2> along_edge_;
};

/// The planes of the wedges of a silhouette loop by Paper I, 4.1, and of a rectangle, 8, from the
/// mesh's vertices and the light. Data are which edges were left out and what is in LinearCorner;
/// of `touched` no more than which of several corners that all touch a plane.
class JudgedLoop {
 public:
  JudgedLoop(const Scene& scene, const LinearLoop& loop, const RealPlane& end);
  /// \param planes  for their signs
  JudgedWedge wedge(std::size_t place, std::span<const SidedPlane> planes) const;
  /// Of an umbra polygon made from an edge of this loop.
  JudgedPlane umbra_plane(const UmbraSource& source, bool minus) const;

 private:
  struct Edge {
    RealVector begin, end, along;
    Direction quad;                    // normal, into the shadow
    std::array<RealVector, 2> from;    // the light's points that rays come from, front and back
    std::array<Direction, 2> normals;  // of front and back plane, into the wedge
  };
  struct Corner {
    std::array<Direction, 2> lines;  // in the side plane, away from the light: front, back
    Direction side;                  // normal, to the edge that ends here
    Direction across;                // in the side plane
  };
  Edge make_edge(const Light& light, const RealVector& begin, const RealVector& end,
                 const LinearCorner& decided) const;
  Corner make_corner(const Edge& ending, const Edge& starting, const LinearCorner& decided) const;
  RealVector far_corner(std::size_t place) const;
  std::size_t next(std::size_t place) const { return (place + 1) % edges_.size(); }

  RealPlane end_;
  std::vector<Edge> edges_;
  std::vector<Corner> corners_;  // where each edge begins
};

}  // namespace wedgesim::functional

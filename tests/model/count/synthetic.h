#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "traces/trace.h"

namespace wedgesim::model::test {

/// A position in window space: pixels and depth.
struct Point {
  double x = 0.0, y = 0.0, z = 0.0;
};

enum class Facing { eye, away };

/// Builds traces by hand, without a renderer.
class SyntheticTrace {
 public:
  /// A frame of one depth under a light.
  SyntheticTrace(std::uint32_t width, std::uint32_t height, double depth,
                 traces::fb::LightShape shape = traces::fb::LightShape_rectangle,
                 traces::fb::DepthFormat format = traces::fb::DepthFormat_unorm24);

  void set_depth(std::uint32_t x, std::uint32_t y, double depth);

  std::uint32_t add_vertex(const Point& point);
  /// A reference to the plane whose inside has ((a*x + b*y) + c*z) + d >= 0; a minus reference to
  /// it turned around if asked for, which is inside for > 0.
  std::uint32_t add_plane(double a, double b, double c, double d, bool as_minus = false);
  /// The plane through three points, inside where `within` is.
  std::uint32_t add_plane(const std::array<Point, 3>& through, const Point& within,
                          bool as_minus = false);

  /// A face of the wedge to come. z interval from the vertices. Vertices are snapped.
  void add_face(std::vector<Point> outline, Facing facing, std::uint32_t plane);
  /// A wedge of all faces added since the last.
  std::uint32_t add_wedge(traces::fb::WedgeKind kind, const std::vector<std::uint32_t>& planes,
                          double z_min, double z_max);
  /// \param wedge  that it belongs to, or traces::kNone
  std::uint32_t add_umbra(std::vector<Point> outline, Facing facing, std::uint32_t plane,
                          std::uint32_t wedge,
                          traces::fb::UmbraRole role = traces::fb::UmbraRole_side);

  traces::Trace trace;

 private:
  std::uint32_t add_indices(std::vector<Point> outline, Facing facing);

  std::uint32_t first_face_ = 0;
};

/// A trace of polygons and planes that have nothing to do with each other: tile tests are then
/// wrong now and then, which must show in LI as it would in a block.
traces::Trace random_nonsense(std::mt19937& random, std::uint32_t width, std::uint32_t height,
                              unsigned wedges);

/// A trace of sound wedges: tetrahedra with snapped vertices, an umbra polygon in each, and closed
/// umbra volumes without wedges.
/// \param thickness  of a tetrahedron across its first edge, as a fraction of a random one's: small
///                   ones are slivers, as the wedges of fine meshes are
traces::Trace random_tetrahedra(std::mt19937& random, std::uint32_t width, std::uint32_t height,
                                unsigned wedges, double thickness = 1.0);

}  // namespace wedgesim::model::test

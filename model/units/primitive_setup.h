#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/datapath/edge_function.h"
#include "model/datapath/setup.h"
#include "traces/trace.h"

namespace wedgesim::model::units {

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// A closed interval of depth, in steps.
struct ZSpan {
  std::int64_t min = 0, max = 0;
  bool holds(std::int64_t z) const { return z >= min && z <= max; }
};

/// A convex polygon ready for the tile walk: a pixel is covered iff it is inside every edge.
struct SetupPolygon {
  std::vector<datapath::EdgeFunction> edges;
  PixelBox bounds;  // of its pixels, clipped to the frame
  bool eye_facing = false;
};

struct SetupFace {
  SetupPolygon polygon;
  datapath::FixedPlane plane;  // inside: the wedge's side
  ZSpan z;
};

struct SetupUmbra {
  SetupPolygon polygon;
  datapath::FixedPlane inner;
  ZSpan z;
  bool cap = false;         // hit everywhere, untested
  bool hits_inner = false;  // a point is hit iff `inner`, or iff not
  int step = 0;             // what a hit adds, in full lights

  /// Inside iff a point is hit.
  datapath::FixedPlane hit_plane() const { return {inner.form, inner.minus != !hits_inner}; }
};

/// What setup hands to the tile walk: a wedge with its umbra polygon, or one of them alone.
struct SetupPrimitive {
  std::optional<std::uint32_t> wedge;  // index in the trace
  std::uint64_t record_bytes = 0;      // fetched for it; the walk knows
  bool coverage = false;
  std::vector<datapath::FixedPlane> planes;
  ZSpan z;
  std::vector<SetupFace> faces;
  datapath::FixedBox vertices;  // around those of all its faces; x and y in 1/256 pixel
  datapath::LightSetup light;
  datapath::FixedPlane inner;
  std::optional<SetupUmbra> umbra;

  /// Pixels of all its polygons.
  PixelBox bounds() const;
};

/// Turns records of a trace into primitives.
class PrimitiveSetup {
 public:
  /// \param z_fail  faces that do not face the eye take part, and caps and bottoms
  PrimitiveSetup(const traces::TraceView& trace, bool z_fail, const datapath::Formats& formats);

  /// A wedge's faces, planes and light; no umbra polygon, no bytes. \param index  of the wedge
  SetupPrimitive penumbra(std::uint32_t index) const;
  /// The umbra polygon of a wedge that takes part, or nothing.
  std::optional<SetupUmbra> umbra_of_wedge(std::uint32_t index) const;
  /// An umbra polygon that takes part, or nothing. \param index  of the polygon
  std::optional<SetupUmbra> umbra(std::uint32_t index) const;
  /// The umbra polygons without a wedge that may take part.
  std::vector<std::uint32_t> lone_umbras() const;

 private:
  template <typename Polygon>
  SetupPolygon polygon(const Polygon& source) const;
  datapath::FixedPlane plane(std::uint32_t reference) const;
  ZSpan span(double z_min, double z_max) const;

  const traces::TraceView& trace_;
  bool z_fail_;
  datapath::Formats formats_;
  datapath::ZSteps steps_;
};

}  // namespace wedgesim::model::units

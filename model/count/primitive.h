#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/count/contribution.h"
#include "model/count/operands.h"
#include "model/count/plane.h"
#include "model/count/raster.h"
#include "traces/trace.h"

namespace wedgesim::model {

enum class ZMethod { pass, fail };

/// A face of a wedge that the block rasterizes.
struct RasterFace {
  Outline outline;
  Plane plane;  // inside: the wedge's side
  ZInterval z;
};

/// An umbra polygon that the block rasterizes.
struct RasterUmbra {
  Outline outline;
  Plane inner;  // inside: the umbra volume's side
  ZInterval z;
  bool eye_facing = false;
  bool cap = false;         // hits everywhere, without a test
  bool hits_inner = false;  // a pixel is hit iff `inner`, or iff not; so iff it faces as the faces
  int stencil_step = 0;     // what a hit adds, in units of full light: -1 or +1

  /// Inside iff a point is hit: passed in z-pass, failed in z-fail.
  Plane hit_plane() const { return hits_inner ? inner : inner.complement(); }
};

/// What the block takes in at once: a wedge with its umbra polygon, or an umbra polygon alone.
/// Only what takes part under the z method and has a snapped area is here.
struct Primitive {
  std::optional<std::uint32_t> wedge;  // index in the trace
  std::optional<std::uint32_t> umbra;  // index in the trace
  // The wedge.
  bool coverage = false;      // its kind
  std::vector<Plane> planes;  // inside all: inside
  ZInterval z;
  std::vector<RasterFace> faces;
  std::vector<std::uint32_t> face_numbers;  // of `faces` in the trace
  Box vertex_box;                           // holds the vertices of all its faces
  LightTerms terms;
  /// Of the wedge's umbra polygon, whether it takes part or not: the sign of `coverage`.
  Plane inner;
  // The umbra polygon.
  std::optional<RasterUmbra> polygon;

  /// Does one of the wedge's rasterized faces cover a pixel?
  bool faces_cover(int x, int y) const {
    return std::any_of(faces.begin(), faces.end(),
                       [&](const RasterFace& face) { return face.outline.covers(x, y); });
  }
  /// In single-pass the polygon shares the wedge's visit if it faces as the wedge's rasterized
  /// faces do, under `share` `all` always if the wedge is a `coverage` one.
  bool shares(bool share_all) const {
    return wedge && polygon && (polygon->hits_inner || (share_all && coverage));
  }
};

/// The umbra polygons that come without a wedge and take part.
std::vector<std::uint32_t> lone_polygons(const traces::TraceView& trace, ZMethod method);

Primitive wedge_primitive(const Operands& operands, ZMethod method, std::uint32_t wedge);
Primitive lone_primitive(const Operands& operands, ZMethod method, std::uint32_t polygon);

/// The one predicate at a pixel: is the point on the inner side of the umbra polygon?
/// \param covered  the polygon covers the pixel: then a z outside its own interval decides first
inline bool is_inner(const RasterUmbra& umbra, bool covered, double x, double y, double z) {
  if (covered && z < umbra.z.min) return !umbra.eye_facing;  // the polygon is behind the point
  if (covered && z > umbra.z.max) return umbra.eye_facing;
  return umbra.inner.inside(x, y, z);
}

}  // namespace wedgesim::model

#pragma once

#include "model/count/plane.h"
#include "model/count/primitive.h"

namespace wedgesim::model {

/// The tests of a tile's box. Each errs on the side of not culling and not accepting: a culled
/// tile holds no pixel that the test's face or wedge would change, an accepted tile none that the
/// umbra polygon would not. In z-fail all of them are mirrored: zmin for zmax, far for near.
namespace tile_test {

/// `zmax`: the whole tile is in front of the face (z-fail: behind it), so outside the wedge.
bool culls_zmax(const RasterFace& face, const Box& box, ZMethod method);

/// `zrange`: the wedge's depths and the tile's do not meet.
bool culls_zrange(const Primitive& wedge, const Box& box);

/// `planes`: the whole box is outside one of the wedge's planes.
bool culls_planes(const Primitive& wedge, const Box& box);

/// The part of `sat` that goes beyond `both`: all vertices of the wedge's faces are beyond one side
/// of the box.
bool culls_sat(const Primitive& wedge, const Box& box);

/// The box is inside the wedge: no pixel needs a test.
bool is_inside(const Primitive& wedge, const Box& box);

/// Umbra `zmax`: the polygon hits no pixel of the tile.
bool culls_umbra(const RasterUmbra& umbra, const Box& box, ZMethod method);

/// Umbra accept `zmin`: the polygon hits every pixel of the tile that it covers.
bool accepts_umbra(const RasterUmbra& umbra, const Box& box, ZMethod method);

}  // namespace tile_test
}  // namespace wedgesim::model

#include "model/count/tile_test.h"

#include <gtest/gtest.h>

#include "model/count/primitive.h"
#include "tests/model/count/synthetic.h"

namespace wedgesim::model::tile_test {
namespace {

const Box kBox{8.0, 16.0, 8.0, 16.0, {0.4, 0.6}};

Plane from_depth(double z) { return {0.0, 0.0, 1.0, -z, false}; }   // inside: at z or beyond
Plane until_depth(double z) { return {0.0, 0.0, -1.0, z, false}; }  // inside: before z or at it

Primitive wedge_of(std::vector<Plane> planes, ZInterval z) {
  Primitive wedge;
  wedge.planes = std::move(planes);
  wedge.z = z;
  return wedge;
}

RasterFace face_of(const Plane& plane, ZInterval z) { return {Outline{}, plane, z}; }

RasterUmbra umbra_of(const Plane& inner, ZInterval z) {
  RasterUmbra umbra;
  umbra.inner = inner;
  umbra.z = z;
  umbra.hits_inner = true;
  return umbra;
}

TEST(TileTest, ZmaxCullsFacesBehindTheTile) {
  const auto culled = [](const Plane& plane, ZInterval z) {
    return culls_zmax(face_of(plane, z), kBox, ZMethod::pass);
  };
  EXPECT_TRUE(culled(from_depth(0.0), {0.61, 0.9})) << "it begins behind the tile";
  EXPECT_FALSE(culled(from_depth(0.0), {0.6, 0.9}));
  EXPECT_TRUE(culled(from_depth(0.7), {0.1, 0.9})) << "every point is in front of its plane";
  EXPECT_FALSE(culled(from_depth(0.5), {0.1, 0.9}));
  // x + 20 z - d at the corner hardest to cull, (16, 0.6): 28 - d.
  EXPECT_TRUE(culled({1.0, 0.0, 20.0, -28.5, false}, {0.1, 0.9}));
  EXPECT_FALSE(culled({1.0, 0.0, 20.0, -27.5, false}, {0.1, 0.9}));
  EXPECT_FALSE(culled(until_depth(0.3), {0.1, 0.9})) << "a plane that faces away decides nothing";
}

TEST(TileTest, ZFailMirrorsZmax) {
  const auto culled = [](const Plane& plane, ZInterval z) {
    return culls_zmax(face_of(plane, z), kBox, ZMethod::fail);
  };
  EXPECT_TRUE(culled(until_depth(1.0), {0.1, 0.39})) << "it ends in front of the tile";
  EXPECT_FALSE(culled(until_depth(1.0), {0.1, 0.4}));
  EXPECT_TRUE(culled(until_depth(0.3), {0.1, 0.9})) << "every point is behind its plane";
  EXPECT_FALSE(culled(until_depth(0.5), {0.1, 0.9}));
  EXPECT_FALSE(culled(from_depth(0.7), {0.1, 0.9})) << "a plane that faces the eye decides nothing";
}

TEST(TileTest, ZrangeCullsDisjointIntervals) {
  EXPECT_TRUE(culls_zrange(wedge_of({}, {0.61, 0.9}), kBox));
  EXPECT_FALSE(culls_zrange(wedge_of({}, {0.6, 0.9}), kBox));
  EXPECT_TRUE(culls_zrange(wedge_of({}, {0.1, 0.39}), kBox));
  EXPECT_FALSE(culls_zrange(wedge_of({}, {0.1, 0.4}), kBox));
}

TEST(TileTest, PlanesCullWhereNoCornerIsInside) {
  const auto culled = [](const Plane& plane) {
    return culls_planes(wedge_of({from_depth(0.0), plane}, {0.0, 1.0}), kBox);
  };
  EXPECT_FALSE(culled(from_depth(0.6))) << "on the plane of a plus reference is inside";
  EXPECT_TRUE(culled(from_depth(0.61)));
  EXPECT_TRUE(culled({0.0, 0.0, 1.0, -0.4, true})) << "on the plane of a minus reference is not";
  EXPECT_FALSE(culled({0.0, 0.0, 1.0, -0.41, true}));
  EXPECT_TRUE(culled({1.0, 1.0, 0.0, -32.5, false})) << "the corner (16, 16)";
  EXPECT_FALSE(culled({1.0, 1.0, 0.0, -32.0, false}));
  EXPECT_TRUE(culled({-1.0, 1.0, 0.0, -8.5, false})) << "the corner (8, 16)";
  EXPECT_FALSE(culled({-1.0, 1.0, 0.0, -8.0, false}));
}

TEST(TileTest, SatCullsDisjointBoxes) {
  const auto culled = [](const Box& vertices) {
    Primitive wedge;
    wedge.vertex_box = vertices;
    return culls_sat(wedge, kBox);
  };
  EXPECT_FALSE(culled({9.0, 10.0, 9.0, 10.0, {0.5, 0.55}}));
  EXPECT_TRUE(culled({16.1, 20.0, 9.0, 10.0, {0.5, 0.55}}));
  EXPECT_TRUE(culled({2.0, 7.9, 9.0, 10.0, {0.5, 0.55}}));
  EXPECT_TRUE(culled({9.0, 10.0, 16.1, 20.0, {0.5, 0.55}}));
  EXPECT_TRUE(culled({9.0, 10.0, 2.0, 7.9, {0.5, 0.55}}));
  EXPECT_TRUE(culled({9.0, 10.0, 9.0, 10.0, {0.61, 0.7}}));
  EXPECT_TRUE(culled({9.0, 10.0, 9.0, 10.0, {0.3, 0.39}}));
  EXPECT_FALSE(culled({16.005, 20.0, 9.0, 10.0, {0.5, 0.55}})) << "as near as snapping moves";
}

// The near plane cuts a wedge that the eye is in, and there it has no face: what is nearer than all
// its vertices may be inside.
TEST(TileTest, SatKeepsWhatIsBeforeAllFacesAroundTheEye) {
  const auto culled = [](double z_min) {
    test::SyntheticTrace synthetic(24, 24, 0.5);
    const std::uint32_t bottom = synthetic.add_plane(0, 0, -1, 0.9);
    synthetic.add_face({{0, 0, 0.8}, {24, 0, 0.8}, {24, 24, 0.9}, {0, 24, 0.9}}, test::Facing::eye,
                       bottom);
    synthetic.add_wedge(traces::fb::WedgeKind_coverage, {bottom}, z_min, 0.9);
    return culls_sat(wedge_primitive(synthetic.trace.view(), ZMethod::pass, 0), kBox);
  };
  EXPECT_TRUE(culled(0.8));
  EXPECT_FALSE(culled(0.0));
  EXPECT_FALSE(culled(-1e-9));
}

// A pixel inside all planes by rounding may be beyond all vertices by as much window depth,
// whatever the arithmetic's unit of depth is.
TEST(TileTest, SatsSlackIsWindowDepth) {
  constexpr double kDepth = 1.0 - 0x1p-26;
  test::SyntheticTrace synthetic(24, 24, 1.0 - 0x1p-25, traces::fb::LightShape_rectangle,
                                 traces::fb::DepthFormat_float32_reversed);
  const std::uint32_t bottom = synthetic.add_plane(0, 0, -1, 1.0);
  synthetic.add_face({{0, 0, kDepth}, {24, 0, kDepth}, {24, 24, kDepth}, {0, 24, kDepth}},
                     test::Facing::eye, bottom);
  synthetic.add_wedge(traces::fb::WedgeKind_coverage, {bottom}, kDepth - 1e-9, kDepth + 1e-9);
  const traces::TraceView trace = synthetic.trace.view();
  for (const DatapathKind kind : {DatapathKind::exact, DatapathKind::fixed}) {
    const Operands operands(trace, Datapath(kind));
    const Primitive wedge = wedge_primitive(operands, ZMethod::pass, 0);
    const auto culled_at = [&](double z) {
      return culls_sat(wedge, {8.0, 16.0, 8.0, 16.0, operands.around(z, z)});
    };
    EXPECT_FALSE(culled_at(kDepth + 0.9e-9)) << spelling(kind);
    EXPECT_TRUE(culled_at(kDepth + 1.1e-9)) << spelling(kind);
    EXPECT_FALSE(culled_at(kDepth - 0.9e-9)) << spelling(kind);
    EXPECT_TRUE(culled_at(kDepth - 1.1e-9)) << spelling(kind);
  }
}

TEST(TileTest, InsideIffEveryCornerIs) {
  const auto inside = [](const Plane& plane, ZInterval z) {
    return is_inside(wedge_of({from_depth(0.0), plane}, z), kBox);
  };
  EXPECT_TRUE(inside(from_depth(0.4), {0.4, 0.6}));
  EXPECT_FALSE(inside(from_depth(0.41), {0.4, 0.6}));
  EXPECT_FALSE(inside(from_depth(0.4), {0.41, 0.6}));
  EXPECT_FALSE(inside(from_depth(0.4), {0.4, 0.59}));
  EXPECT_TRUE(inside({-1.0, 0.0, 0.0, 16.0, false}, {0.4, 0.6})) << "on its edge, plus reference";
  EXPECT_FALSE(inside({1.0, 0.0, 0.0, -16.0, true}, {0.4, 0.6})) << "on its edge, minus reference";
}

TEST(TileTest, UmbraPolygonsInZPass) {
  const auto culled = [](double depth, ZInterval z) {
    return culls_umbra(umbra_of(from_depth(depth), z), kBox, ZMethod::pass);
  };
  const auto accepted = [](double depth, ZInterval z) {
    return accepts_umbra(umbra_of(from_depth(depth), z), kBox, ZMethod::pass);
  };
  EXPECT_TRUE(culled(0.7, {0.1, 0.9}));
  EXPECT_FALSE(culled(0.5, {0.1, 0.9}));
  EXPECT_FALSE(culled(0.7, {0.1, 0.5})) << "beyond the polygon's end every pixel is hit";
  EXPECT_TRUE(culled(0.5, {0.61, 0.9})) << "the polygon is behind the tile";
  EXPECT_TRUE(accepted(0.3, {0.1, 0.9}));
  EXPECT_FALSE(accepted(0.5, {0.1, 0.9}));
  EXPECT_FALSE(accepted(0.3, {0.5, 0.9})) << "before the polygon's begin no pixel is hit";
  EXPECT_TRUE(accepted(0.5, {0.1, 0.39})) << "the polygon is in front of the tile";
}

TEST(TileTest, UmbraPolygonsInZFail) {
  const auto culled = [](double depth, ZInterval z) {
    return culls_umbra(umbra_of(until_depth(depth), z), kBox, ZMethod::fail);
  };
  const auto accepted = [](double depth, ZInterval z) {
    return accepts_umbra(umbra_of(until_depth(depth), z), kBox, ZMethod::fail);
  };
  EXPECT_TRUE(culled(0.3, {0.1, 0.9}));
  EXPECT_FALSE(culled(0.5, {0.1, 0.9}));
  EXPECT_FALSE(culled(0.3, {0.5, 0.9}));
  EXPECT_TRUE(culled(0.5, {0.1, 0.39}));
  EXPECT_TRUE(accepted(0.7, {0.1, 0.9}));
  EXPECT_FALSE(accepted(0.5, {0.1, 0.9}));
  EXPECT_FALSE(accepted(0.7, {0.1, 0.5}));
  EXPECT_TRUE(accepted(0.5, {0.61, 0.9}));
}

}  // namespace
}  // namespace wedgesim::model::tile_test

// Does each test of a tile's box decide exactly from the step on that it should?
#include "model/units/tile_decision.h"

#include <gtest/gtest.h>

namespace wedgesim::model::units {
namespace {

using datapath::FixedBox;
using datapath::FixedForm;
using datapath::FixedPlane;

// A tile of 8x8 pixels at the origin, in half pixels, between two depths.
FixedBox box(std::int64_t z_min, std::int64_t z_max) { return {{0, 0, z_min}, {16, 16, z_max}}; }
FixedPlane beyond_z(std::int64_t z) { return {FixedForm{0, 0, 1, -z, 0}, false}; }
FixedPlane beyond_x(std::int64_t x) { return {FixedForm{1, 0, 0, -x, 0}, false}; }

SetupPrimitive wedge() {
  SetupPrimitive primitive;
  primitive.z = {100, 200};
  primitive.vertices = {{0, 0, 100}, {4096, 4096, 200}};  // x and y in 1/256 pixel
  return primitive;
}

Cull cull(Cull enabled, const SetupPrimitive& primitive, const FixedBox& box, bool z_fail = false) {
  const SetupFace face{{}, beyond_z(150), {100, 200}};
  return cull_face(enabled, primitive, face, box, z_fail);
}

TEST(TileDecision, ZRangeCullsWhatIsOutsideTheWedgesDepths) {
  EXPECT_EQ(cull(Cull::zrange, wedge(), box(201, 300)), Cull::zrange);
  EXPECT_EQ(cull(Cull::zrange, wedge(), box(200, 300)), Cull::none);
  EXPECT_EQ(cull(Cull::zrange, wedge(), box(0, 99)), Cull::zrange);
  EXPECT_EQ(cull(Cull::zrange, wedge(), box(0, 100)), Cull::none);
  EXPECT_EQ(cull(Cull::none, wedge(), box(0, 99)), Cull::none);
}

// The farthest depth before the face's plane, at 150: nothing in the tile is inside the wedge.
TEST(TileDecision, ZMaxCullsWhatLiesBeforeTheFace) {
  EXPECT_EQ(cull(Cull::zmax, wedge(), box(0, 149)), Cull::zmax);
  EXPECT_EQ(cull(Cull::zmax, wedge(), box(0, 150)), Cull::none);
  // z-fail asks for the nearest depth beyond the face: by its interval, as the plane faces the eye.
  EXPECT_EQ(cull(Cull::zmax, wedge(), box(201, 300), true), Cull::zmax);
  EXPECT_EQ(cull(Cull::zmax, wedge(), box(200, 300), true), Cull::none);
}

TEST(TileDecision, PlanesCullWhatOneOfThemLeavesOut) {
  SetupPrimitive primitive = wedge();
  primitive.planes = {beyond_z(0), beyond_x(17)};
  EXPECT_EQ(cull(Cull::planes, primitive, box(120, 130)), Cull::planes);
  EXPECT_EQ(cull(Cull::both, primitive, box(120, 130)), Cull::planes);
  EXPECT_EQ(cull(Cull::both, primitive, box(201, 300)), Cull::zrange);  // the cheaper test first
  primitive.planes[1] = beyond_x(16);
  EXPECT_EQ(cull(Cull::planes, primitive, box(120, 130)), Cull::none);
}

// Beyond the vertices by more than snapping moves them.
TEST(TileDecision, SatCullsWhatIsApartFromTheVertices) {
  SetupPrimitive primitive = wedge();
  primitive.vertices.low.x = 16 * 128 + 3;
  EXPECT_EQ(cull(Cull::sat, primitive, box(120, 130)), Cull::sat);
  primitive.vertices.low.x = 16 * 128 + 2;
  EXPECT_EQ(cull(Cull::sat, primitive, box(120, 130)), Cull::none);
}

TEST(TileDecision, ATileIsInsideIfAllOfItIs) {
  SetupPrimitive primitive = wedge();
  primitive.planes = {beyond_z(150), beyond_x(0)};
  EXPECT_TRUE(inside_wedge(primitive, box(150, 200)));
  EXPECT_FALSE(inside_wedge(primitive, box(149, 200)));
  EXPECT_FALSE(inside_wedge(primitive, box(150, 201)));
  primitive.planes[1] = beyond_x(1);
  EXPECT_FALSE(inside_wedge(primitive, box(150, 200)));
}

// Hit from 150 on, and beyond 200 whatever the plane says.
TEST(TileDecision, UmbraPolygonsAreCulledAndAccepted) {
  SetupUmbra umbra;
  umbra.inner = beyond_z(150);
  umbra.hits_inner = true;
  umbra.z = {100, 200};
  const auto decide = [&](UmbraCull cull, Accept accept, const FixedBox& tile) {
    return decide_umbra(cull, accept, umbra, tile, false);
  };
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::zmin, box(0, 149)), UmbraDecision::culled);
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::zmin, box(0, 150)), UmbraDecision::read);
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::zmin, box(149, 180)), UmbraDecision::read);
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::zmin, box(150, 180)), UmbraDecision::accepted);
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::zmin, box(201, 300)), UmbraDecision::accepted);
  EXPECT_EQ(decide(UmbraCull::none, Accept::zmin, box(0, 149)), UmbraDecision::read);
  EXPECT_EQ(decide(UmbraCull::zmax, Accept::none, box(201, 300)), UmbraDecision::read);
}

}  // namespace
}  // namespace wedgesim::model::units

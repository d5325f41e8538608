#include "traces/verify.h"

#include <functional>
#include <limits>
#include <ostream>

#include "tests/traces/files.h"
#include "tests/traces/sample.h"

namespace wedgesim::traces {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  std::string message;  // without the place
  std::function<void(Trace&)> damage;
};

void PrintTo(const Case& value, std::ostream* out) { *out << value.message; }

/// One thing made wrong in the sample at a time; each has one line of its own.
class Verify : public testing::TestWithParam<Case> {};

TEST_P(Verify, NamesWhatIsWrong) {
  Trace trace = sample_trace();
  GetParam().damage(trace);
  EXPECT_EQ(input_error([&] { verify(trace.view(), "a.wtrace"); }),
            "a.wtrace: " + GetParam().message);
}

fb::Matrix4 with_element(fb::Matrix4 matrix, std::uint32_t index, double value) {
  matrix.mutable_columns()->Mutate(index, value);
  return matrix;
}

const Case kFrame[] = {
    {"width is 0; expected 1 to 16384", [](Trace& t) { t.header.width = 0; }},
    {"width is 16385; expected 1 to 16384", [](Trace& t) { t.header.width = 16385; }},
    {"height is 0; expected 1 to 16384", [](Trace& t) { t.header.height = 0; }},
    {"height is 4294967295; expected 1 to 16384", [](Trace& t) { t.header.height = 0xffffffffU; }},
    {"depth_format is 4; expected 0 to 3",
     [](Trace& t) { t.header.depth_format = static_cast<fb::DepthFormat>(4); }},
    {"expected_z_method is 2; expected 0 to 1",
     [](Trace& t) { t.header.expected_z_method = static_cast<fb::ZMethod>(2); }},
    {"depth.length is 11; expected 12, width x height", [](Trace& t) { t.depth.pop_back(); }},
    {"depth.length is 0; expected 12, width x height", [](Trace& t) { t.depth.clear(); }},
    {"expected_li.length is 13; expected 12, width x height, or absent",
     [](Trace& t) { t.expected_li.push_back(1.0); }},
    {"li_sensitivity.length is 11; expected 12, width x height, or absent",
     [](Trace& t) { t.li_sensitivity.pop_back(); }},
    {"depth[7] is 16777216; expected 0 to 16777215", [](Trace& t) { t.depth[7] = 1U << 24; }},
    {"depth[1] is 1525201; expected 0 to 65535",
     [](Trace& t) { t.header.depth_format = fb::DepthFormat_unorm16; }},
    {"depth[0] is 2143289344; expected 0 to 1065353216",  // NaN
     [](Trace& t) {
       t.header.depth_format = fb::DepthFormat_float32;
       t.depth.assign(12, 0x7fc00000U);
     }},
    {"depth[11] is 1065353217; expected 0 to 1065353216",  // just above 1
     [](Trace& t) {
       t.header.depth_format = fb::DepthFormat_float32_reversed;
       t.depth.assign(12, 0x3f800000U);
       t.depth.back() += 1;
     }},
    {"expected_li[5] is nan; expected a finite number", [](Trace& t) { t.expected_li[5] = kNaN; }},
    {"li_sensitivity[2] is inf; expected a finite number",
     [](Trace& t) { t.li_sensitivity[2] = std::numeric_limits<float>::infinity(); }},
    {"li_sensitivity[2] is -1; expected 0 or more", [](Trace& t) { t.li_sensitivity[2] = -1.0F; }},
};

const Case kHeader[] = {
    {"lights.length is 1025; expected 0 to 1024", [](Trace& t) { t.header.lights.resize(1025); }},
    {"casters.length is 65537; expected 0 to 65536",
     [](Trace& t) { t.header.casters.resize(65537); }},
    {"camera.eye is (0, nan, 0); expected finite numbers",
     [](Trace& t) {
       t.header.camera.eye = {0.0, kNaN, 0.0};
     }},
    {"camera.near_rectangle[3] is (inf, 0, 0); expected finite numbers",
     [](Trace& t) {
       t.header.camera.near_rectangle[3] = {kInfinity, 0.0, 0.0};
     }},
    {"camera.window_from_world.columns[15] is nan; expected a finite number",
     [](Trace& t) {
       Camera& camera = t.header.camera;
       camera.window_from_world = with_element(camera.window_from_world, 15, kNaN);
     }},
    {"camera.world_from_window.columns[0] is -inf; expected a finite number",
     [](Trace& t) {
       Camera& camera = t.header.camera;
       camera.world_from_window = with_element(camera.world_from_window, 0, -kInfinity);
     }},
    {"lights[1].shape is 3; expected 0 to 2",
     [](Trace& t) { t.header.lights[1].shape = static_cast<fb::LightShape>(3); }},
    {"lights[0].centre is (nan, 0, 0); expected finite numbers",
     [](Trace& t) {
       t.header.lights[0].centre = {kNaN, 0.0, 0.0};
     }},
    {"lights[0].half_u is (nan, 0, 0); expected finite numbers",
     [](Trace& t) {
       t.header.lights[0].half_u = {kNaN, 0.0, 0.0};
     }},
    {"lights[0].half_v is (nan, 0, 0); expected finite numbers",
     [](Trace& t) {
       t.header.lights[0].half_v = {kNaN, 0.0, 0.0};
     }},
    {"lights[0].radius is nan; expected a finite number",
     [](Trace& t) { t.header.lights[0].radius = kNaN; }},
    {"lights[0].radius is -0.5; expected 0 or more",
     [](Trace& t) { t.header.lights[0].radius = -0.5; }},
    {"lights[0].colour is (1, 1, inf); expected finite numbers",
     [](Trace& t) {
       t.header.lights[0].colour = {1.0, 1.0, kInfinity};
     }},
    {"lights[0].light_from_window.columns[7] is nan; expected a finite number",
     [](Trace& t) {
       Light& light = t.header.lights[0];
       light.light_from_window = with_element(light.light_from_window, 7, kNaN);
     }},
    {"lights[0].texture_width is 16385; expected 0 to 16384",
     [](Trace& t) { t.header.lights[0].texture_width = 16385; }},
    {"lights[0].texture_height is 16385; expected 0 to 16384",
     [](Trace& t) { t.header.lights[0].texture_height = 16385; }},
    {"lights[0].texture.length is 6; expected 12, texture_width x texture_height x 3",
     [](Trace& t) { t.header.lights[0].texture_height = 2; }},
    {"lights[0].texture[4] is nan; expected a finite number",
     [](Trace& t) { t.header.lights[0].texture[4] = std::numeric_limits<float>::quiet_NaN(); }},
    {"z_fail_needed is false; expected true, as a caster's is",
     [](Trace& t) { t.header.z_fail_needed = false; }},
    {"z_fail_needed is true; expected false, as no caster's is true",
     [](Trace& t) { t.header.casters[0].z_fail_needed = false; }},
};

const Case kGeometry[] = {
    {"vertices[3].x is 16777217; expected -16777216 to 16777216",
     [](Trace& t) { t.vertices[3].mutate_x((1 << 24) + 1); }},
    {"vertices[0].y is -2147483648; expected -16777216 to 16777216",
     [](Trace& t) { t.vertices[0].mutate_y(std::numeric_limits<std::int32_t>::min()); }},
    {"vertices[1].z is inf; expected a finite number",
     [](Trace& t) { t.vertices[1].mutate_z(kInfinity); }},
    {"indices[12] is 4; expected below 4, the number of vertices",
     [](Trace& t) { t.indices[12] = 4; }},
    {"planes[0].a is nan; expected a finite number", [](Trace& t) { t.planes[0].mutate_a(kNaN); }},
    {"planes[1].b is nan; expected a finite number", [](Trace& t) { t.planes[1].mutate_b(kNaN); }},
    {"planes[2].c is nan; expected a finite number", [](Trace& t) { t.planes[2].mutate_c(kNaN); }},
    {"planes[2].d is inf; expected a finite number",
     [](Trace& t) { t.planes[2].mutate_d(kInfinity); }},
    {"faces[0].index_count is 2; expected 3 to 64",
     [](Trace& t) { t.faces[0].mutate_index_count(2); }},
    {"faces[0].index_count is 65; expected 3 to 64",
     [](Trace& t) { t.faces[0].mutate_index_count(65); }},
    {"faces[2].first_index + index_count is 14; expected at most 13, the number of indices",
     [](Trace& t) { t.faces[2].mutate_first_index(10); }},
    {"faces[1].first_index + index_count is 4294967298; expected at most 13, the number of "
     "indices",
     [](Trace& t) { t.faces[1].mutate_first_index(0xffffffffU); }},
    {"faces[1].plane is 6; expected below 6, twice the number of planes",
     [](Trace& t) { t.faces[1].mutate_plane(6); }},
    {"faces[1].z_min is nan; expected a finite number",
     [](Trace& t) { t.faces[1].mutate_z_min(kNaN); }},
    {"faces[1].z_max is inf; expected a finite number",
     [](Trace& t) { t.faces[1].mutate_z_max(kInfinity); }},
    {"faces[1].z_min is 2; expected at most its z_max, 1.5",
     [](Trace& t) { t.faces[1].mutate_z_min(2.0); }},
};

const Case kWedges[] = {
    {"wedges[0].kind is 2; expected 0 to 1",
     [](Trace& t) { t.wedges[0].mutate_kind(static_cast<fb::WedgeKind>(2)); }},
    {"wedges[0].plane_count is 0; expected 1 to 8",
     [](Trace& t) { t.wedges[0].mutate_plane_count(0); }},
    {"wedges[0].plane_count is 9; expected 1 to 8",
     [](Trace& t) { t.wedges[0].mutate_plane_count(9); }},
    {"wedges[1].plane_count is 3; expected 4 to 8",
     [](Trace& t) { t.wedges[1].mutate_plane_count(3); }},
    {"wedges[0].planes[2] is 6; expected below 6, twice the number of planes",
     [](Trace& t) { t.wedges[0].mutable_planes()->Mutate(2, 6); }},
    {"wedges[0].face_count is 65; expected 0 to 64",
     [](Trace& t) { t.wedges[0].mutate_face_count(65); }},
    {"wedges[1].first_face + face_count is 4; expected at most 3, the number of faces",
     [](Trace& t) { t.wedges[1].mutate_face_count(2); }},
    {"wedges[0].light is 2; expected below 2, the number of lights",
     [](Trace& t) { t.wedges[0].mutate_light(2); }},
    {"wedges[0].light is 1; expected a light with an extent: a point has no penumbra",
     [](Trace& t) { t.wedges[0].mutate_light(1); }},
    {"wedges[1].caster is 2; expected below 2, the number of casters",
     [](Trace& t) { t.wedges[1].mutate_caster(2); }},
    {"wedges[0].z_min is nan; expected a finite number",
     [](Trace& t) { t.wedges[0].mutate_z_min(kNaN); }},
    {"wedges[0].z_max is inf; expected a finite number",
     [](Trace& t) { t.wedges[0].mutate_z_max(kInfinity); }},
    {"wedges[0].z_min is 0.8; expected at most its z_max, 0.75",
     [](Trace& t) { t.wedges[0].mutate_z_min(0.8); }},
    {"wedges[0].edge_begin is (nan, 0.25, 3); expected finite numbers",
     [](Trace& t) { t.wedges[0].mutable_edge_begin().mutate_x(kNaN); }},
    {"wedges[0].edge_end is (0.5, inf, 3.5); expected finite numbers",
     [](Trace& t) { t.wedges[0].mutable_edge_end().mutate_y(kInfinity); }},
    {"wedges[1].linear_factors[5] is nan; expected a finite number",
     [](Trace& t) { t.wedges[1].mutable_linear_factors()->Mutate(5, kNaN); }},
    {"wedges[1].umbra_plane is 4294967295; expected below 6, twice the number of planes",
     [](Trace& t) { t.wedges[1].mutate_umbra_plane(kNone); }},
    {"wedges[0].umbra is 3; expected below 3, the number of umbra_polygons, or 4294967295 for "
     "none",
     [](Trace& t) { t.wedges[0].mutate_umbra(3); }},
    {"wedges[1].umbra is 0; expected an umbra polygon that names this wedge, not 0",
     [](Trace& t) { t.wedges[1].mutate_umbra(0); }},
    {"wedges[0].umbra_plane is 4; expected 5, its umbra polygon's plane",
     [](Trace& t) { t.wedges[0].mutate_umbra_plane(4); }},
    {"wedges[0].caster is 1; expected 0, its umbra polygon's",
     [](Trace& t) { t.wedges[0].mutate_caster(1); }},
};

const Case kUmbraPolygons[] = {
    {"umbra_polygons[0].index_count is 0; expected 3 to 64",
     [](Trace& t) { t.umbra_polygons[0].mutate_index_count(0); }},
    {"umbra_polygons[1].first_index + index_count is 15; expected at most 13, the number of "
     "indices",
     [](Trace& t) { t.umbra_polygons[1].mutate_first_index(11); }},
    {"umbra_polygons[2].z_min is nan; expected a finite number",
     [](Trace& t) { t.umbra_polygons[2].mutate_z_min(kNaN); }},
    {"umbra_polygons[2].z_min is 1; expected at most its z_max, 0.75",
     [](Trace& t) { t.umbra_polygons[2].mutate_z_min(1.0); }},
    {"umbra_polygons[0].role is 3; expected 0 to 2",
     [](Trace& t) { t.umbra_polygons[0].mutate_role(static_cast<fb::UmbraRole>(3)); }},
    {"umbra_polygons[1].plane is 6; expected below 6, twice the number of planes",
     [](Trace& t) { t.umbra_polygons[1].mutate_plane(6); }},
    {"umbra_polygons[2].plane is 4294967295; expected below 6, twice the number of planes",
     [](Trace& t) { t.umbra_polygons[2].mutate_role(fb::UmbraRole_side); }},
    {"umbra_polygons[2].caster is 2; expected below 2, the number of casters",
     [](Trace& t) { t.umbra_polygons[2].mutate_caster(2); }},
    {"umbra_polygons[1].wedge is 2; expected below 2, the number of wedges, or 4294967295 for "
     "none",
     [](Trace& t) { t.umbra_polygons[1].mutate_wedge(2); }},
    {"umbra_polygons[1].wedge is 0; expected a wedge that names this umbra polygon",
     [](Trace& t) { t.umbra_polygons[1].mutate_wedge(0); }},
    {"umbra_polygons[0].wedge is 0; expected 4294967295, none: only a side shares a visit",
     [](Trace& t) { t.umbra_polygons[0].mutate_role(fb::UmbraRole_bottom); }},
};

INSTANTIATE_TEST_SUITE_P(Frame, Verify, testing::ValuesIn(kFrame));
INSTANTIATE_TEST_SUITE_P(Header, Verify, testing::ValuesIn(kHeader));
INSTANTIATE_TEST_SUITE_P(Geometry, Verify, testing::ValuesIn(kGeometry));
INSTANTIATE_TEST_SUITE_P(Wedges, Verify, testing::ValuesIn(kWedges));
INSTANTIATE_TEST_SUITE_P(UmbraPolygons, Verify, testing::ValuesIn(kUmbraPolygons));

TEST(VerifySound, SampleAndRandomTraces) {
  EXPECT_NO_THROW(verify(sample_trace().view(), "sample"));
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    EXPECT_NO_THROW(verify(random_trace(seed).view(), "random")) << "seed " << seed;
  }
}

TEST(VerifySound, LimitsThemselvesAreSound) {
  Trace trace = sample_trace();
  trace.vertices[0] = {kMaxSnapped, -kMaxSnapped, 0.0};
  trace.faces[0].mutate_z_min(trace.faces[0].z_max());
  trace.expected_li.clear();
  trace.li_sensitivity.clear();
  EXPECT_NO_THROW(verify(trace.view(), "limits"));
}

}  // namespace
}  // namespace wedgesim::traces

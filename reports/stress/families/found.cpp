#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <string_view>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/random_case.h"

namespace wedgesim::reports::stress {
namespace {

// What random_search_test.cpp found and made simple, each once wrong for the reason above it. Their
// order never changes, new ones are last: a frame is called by its place.
constexpr std::array<std::string_view, 65> kFound{
    // The eye in a wedge much wider than the view: the wedge's interval of depth ended at its
    // faces.
    "light_size=4 floor_tilt_x=3 view=-6 first.size=-6",
    "view=-6 first.size=-13",
    // A ray along an edge between front planes, parallel to the end plane: no corner.
    "kind=1 grid=1 first.shape=5",
    "kind=1 first.shape=5 first.move=1 first.move_a=5 first.move_b=4",
    // A loop that turns back along its edge: no side plane.
    "kind=1 axes=1 turn=5 view=-4 first.shape=1 first.thick=-24 first.move=3 first.move_b=2",
    "kind=1 view=-3 target_z=-2 up=1 first.shape=4 first.move=1 first.move_a=2 first.move_b=3",
    "kind=1 format=2 turn=2 eye_z=-4 near=7 target_z=-5 first.shape=3 first.thick=-36 "
    "first.pyramid=1 first.z=2",
    // A near plane nearer than the floor's coordinates are exact: points without a distance.
    "floor_size=14 eye_y=-6 eye_distance=-2 near=16 first.size=-19",
    // Edges, or lights, small beside the other: sides of the wedge were dropped as rounding.
    "light_size=-21 target_z=1 close_up=1 first.shape=1 first.thick=2 first.z2=4",
    "light_size=-1 turn=7 close_up=1 first.shape=2 first.depth=18 first.pyramid=1 first.x=-8",
    "eye_place=3 first.size=-15 first.thick=-4 first.x=1 first.move=3",
    "floor_tilt_z=-8 first.size=-15 first.z=-4",
    "light_flat=20 view=-1 first.size=-16 first.move=1 first.move_a=2",
    // Casters near a sphere, or small beside it: its coverage as a difference of large terms.
    "light=1 first.depth=-14",
    "light=1 light_size=-14 close_up=1 first.shape=4",
    "light=1 first.size=-15",
    "light=1 first.depth=-2 first.size=-12",
    // A near plane tiny beside the eye's coordinates: points of the renderer left their rays.
    "format=3 light_size=-20 near=10 close_up=1 first.x=5 first.x0=7",
    // Edges in one line with the light's centre, all but: their quad's plane was mostly rounding.
    "offset=17 axes=1 turn=2 grid=2 first.shape=2 first.size=-15 first.thick=1 first.move=4",
    "light=6 turn=1 first.shape=2 first.depth=9 first.size=-15 first.pyramid=1 first.x=8",
    "light_roll=3 eye_x=-8 eye_z=2 first.shape=5 first.pyramid=1 first.x=3 first.turn=7 "
    "first.x0=-5 "
    "first.move=3 first.move_a=1 first.move_by=42",
    // A view all but along up: rays were off by 2^-34.
    "turn=1 grid=3 eye_place=5 first.shape=4 first.depth=-23",
    // An edge 2^28 times as long as its way from a sphere, in one line with its centre: no number.
    "light=1 light_size=-26 first.shape=2 first.thick=-35 first.z=8 first.turn=1 first.move=5 "
    "first.move_a=1 first.move_by=56",
    // An edge whose line passes the light's very border: its front and its back plane are one.
    "kind=1 first.shape=3 first.x=5",
    // An edge in the side plane at its end: rounding said on which side of it the next edge is.
    "kind=1 grid=9 casters=1 second.shape=5 second.depth=-8 second.pyramid=1",
    // An edge in both its side planes: the ways to them along it have no end.
    "kind=1 grid=2 first.shape=2 first.z=6 first.then=2",
    // Edges 2^-50 long, whose direction is rounding: their planes were any.
    "kind=1 casters=1 second.move=1 second.move_b=3 second.move_by=50",
    "kind=1 first.shape=1 first.then=1 first.then_a=2 first.then_by=52",
    // Lines of meeting 2^-25 apart: which side of the side plane an edge is on was their rounding.
    "kind=1 light=1 first.shape=2 first.thick=-25 first.x=-1 first.z=-3 first.move=2 "
    "first.move_b=7",
    // A vertex 2^20 to 2^28 away: the side plane there was what rounding left of it, near the
    // light.
    "kind=1 light=1 first.move=5 first.move_a=3 first.move_by=56 first.then=1 first.then_a=5 "
    "first.then_by=48",
    "kind=1 first.pyramid=1 first.z=-2 first.z1=-7 first.x2=-2 first.z3=-2 first.move=5 "
    "first.move_a=2 first.move_by=54",
    "kind=1 view=1 first.thick=-15 first.x=-5 first.move=5 first.move_a=2 first.move_by=56",
    "kind=1 first.shape=2 first.z=-6 first.turn=7 first.y0=-1 first.then=5 first.then_by=56",
    "kind=1 light_flat=4 turn=1 first.size=-7 first.z=1 first.move=5 first.move_by=40",
    // Wedges thinner than the rounding of the scene that they are cut from: they had no near part.
    "kind=1 light_flat=14 first.shape=3 first.pyramid=1 first.x=-4 first.z=3 first.then=5 "
    "first.then_by=60",
    "kind=1 light_size=-21 view=-3 first.shape=3 first.size=-12 first.then=5 first.then_a=7 "
    "first.then_by=58",
    // An edge whose line goes through a corner of the light: the plane through both was any.
    "kind=1 turn=6 first.shape=2 first.x=-8 first.z=-4",
    // Corners so sharp, seen from the light, that both edges are in the side plane between them:
    // which is on which side was rounding.
    "kind=1 light=1 first.shape=3 first.thick=-26 first.z=-4 first.move_a=2 first.move_b=1 "
    "first.then=2 first.then_b=6 first.then_by=6",
    "kind=1 light=1 view=-6 first.shape=4 first.x=-5 first.move=2 first.move_a=6 first.move_b=2 "
    "first.move_by=29 first.then_a=7 first.then_b=3",
    "kind=1 light=1 first.shape=5 first.thick=-24 first.x=-8 first.z=-2 first.turn=7 "
    "first.move_b=3 first.move_by=-53 first.then=2 first.then_a=7 first.then_by=-53",
    // Loops that turn back where their quads are in one plane: no edge is on a side of it.
    "kind=1 close_up=1 first.shape=1 first.x1=3 first.move=3 first.move_a=5 first.move_by=41 "
    "first.then_a=4",
    "kind=1 first.shape=3 first.x=-2 first.z=4 first.z2=-8 first.move=4 first.move_a=4 "
    "first.move_by=29 first.then_b=5",
    "kind=1 close_up=1 first.shape=2 first.thick=-25 first.move_a=2 first.move_b=5 "
    "first.move_by=60 first.then=2 first.then_a=5 first.then_b=1",
    "kind=1 close_up=1 first.shape=1 first.move=3 first.move_a=5 first.move_b=7 "
    "first.move_by=34 first.then_a=1 first.then_b=1 first.then_by=-16",
    "kind=1 close_up=1 first.shape=3 first.z=-4 first.move=1 first.move_b=4 first.move_by=49",
    "kind=1 first.shape=3 first.pyramid=1 first.move=3 first.move_b=4 first.move_by=42 "
    "first.then_a=5",
    "kind=1 first.shape=1 first.x=4 first.move=3 first.move_a=5 first.move_b=7 "
    "first.move_by=26 first.then_a=1 first.then_b=2 first.then_by=-20",
    // The middle of two all but opposite normals: it was their sum, of which little is left.
    "kind=1 light=1 first.shape=3 first.pyramid=1 first.z=-4 first.turn=5 first.move=4 "
    "first.move_b=5 first.move_by=26 first.then_a=6 first.then_b=4",
    // Front, back and side planes that are one, along a side of the light: its volume was torn.
    "kind=1 light_tilt_x=-4 axes=1 target_z=-4 first.shape=3 first.x3=2 first.move=2",
    // Flagged before: light shares of long edges, from the end that they are next to; forms of
    // accurate sums.
    "light=1 first.size=-19 first.turn=4 first.z0=2 first.x1=5 first.then=5 first.then_by=18",
    "light_size=-21 light_flat=21 light_roll=1 floor_tilt_x=1 eye_y=1 close_up=1 first.depth=30 "
    "first.thick=2 first.z=-8",
    "light=1 eye_place=2 eye_z=1 first.shape=1 first.size=-10 first.x=5 first.move=5 "
    "first.move_a=2 first.move_by=56",
    "light_size=-2 eye_y=-4 eye_z=-8 target_z=-2 close_up=1 first.depth=9 first.thick=-18 "
    "first.z1=6 first.z3=2 first.then=5 first.then_a=1 first.then_by=50",
    "format=1 grid=4 floor_tilt_x=6 eye_place=1 eye_x=2 eye_y=1 target_z=4 close_up=1 "
    "first.depth=16 first.size=-2 first.z=6 first.move=5 first.move_a=6 first.move_by=42",
    "kind=1 light=1 turn=4 first.shape=4 first.thick=-20 first.turn=3 first.z2=1 first.move_a=3 "
    "first.move_by=14 first.then=2 first.then_a=7 first.then_b=1 first.then_by=27",
    // Edges all but towards the centre of a sphere: their frame had a part along them.
    "light=1 first.size=-15 first.then=4 first.then_b=6",
    "light=1 first.size=-17 first.y3=3",
    "light=1 first.shape=5 first.size=-20",
    // Near planes so near that rows of the matrix to the light cancel.
    "light=1 near=12 close_up=1 first.size=-17 first.z=5 first.x3=-3",
    "light=1 turn=1 near=12 first.size=-18",
    "light=1 turn=1 near=11 first.size=-19",
    "light=1 turn=3 near=15 first.shape=4 first.size=-13",
    // An end 2^22 away took the digits of the other.
    "eye_x=2 eye_y=3 eye_z=1 near=5 first.then=5 first.then_a=1 first.then_by=44",
    "light_size=-11 close_up=1 first.move=1 first.move_b=3 first.then=5 first.then_by=-44",
    // By z-fail, where z-pass gives other sums.
    "z_fail=1 floor_size=-4",
};

// What some arithmetic can only flag; each was once wrong without. One that is mended moves up.
constexpr std::array<std::string_view, 23> kFlagged{
    // The eye in a quad's plane, pixel centres on the line that it is seen as.
    "light_size=9 turn=6 eye_place=5 up=1 first.x1=-8 first.x2=1",
    "grid=1 eye_x=-7 eye_z=1 eye_distance=6 close_up=1 up=2 first.shape=3",
    // A light 2^-22 wide, seen through a near plane 2^-20 away: the matrix from the window is a
    // difference of terms 2^20 times as large.
    "format=3 light=1 light_size=-22 near=20 close_up=1 first.z=7",
    // The eye in the planes of two quads that have no polygon, and a whole diagonal of the
    // picture.
    "turn=3 eye_place=5 view=-6 up=2 first.z1=-8",
    // Lights 2^-21 to 2^-24 as wide as they are long: the point in light space is mostly rounding.
    "light_flat=23 close_up=1 first.shape=4 first.move=5 first.move_by=58",
    "format=1 light_flat=24 light_tilt_z=-1 eye_y=8 eye_z=3 target_x=-3 close_up=1 "
    "first.shape=1 first.depth=18",
    // `linear`: lines in which planes meet that are all but one.
    "kind=1 first.shape=2 first.turn=5 first.then=1 first.then_a=1 first.then_by=25",
    "kind=1 light=1 offset=6 turn=2 first.shape=3 first.size=-17 first.thick=-19 "
    "first.pyramid=1 first.z0=3",
    "kind=1 light_tilt_z=-6 view=-9 close_up=1 first.shape=3 first.z=5 first.then=2 "
    "first.then_a=2 first.then_by=17",
    // A light 2^-27 wide, the eye beside it.
    "light_size=-26 eye_place=5 target_z=4 close_up=1 casters=1 first.depth=-29 second.x=1 "
    "second.z=-1 second.move=1 second.move_a=3",
    // A reversed depth finer than double: culling by vertices left out a pixel inside all planes.
    "format=3 light_tilt_x=-6 light_roll=-3 axes=4 eye_x=4 eye_y=-3 eye_z=-8 eye_distance=20 "
    "near=27 close_up=1 first.shape=5 first.x=7",
    // The same, of a quad's plane and of a penumbra: `fixed` was not warned by what double lacks.
    "format=3 light=6 eye_distance=12 near=27 up=1",
    "kind=1 format=3 light_roll=-4 grid=9 floor_tilt_x=3 eye_x=-4 eye_z=-6 eye_distance=16 "
    "near=26 far=16 target_x=-7 first.shape=5 first.depth=8",
    // Corners so sharp, seen from the light, that little of the side plane between is left.
    "kind=1 light=1 first.shape=4 first.pyramid=1 first.x=8 first.z=-4 first.move=2 "
    "first.move_a=5 first.move_b=6 first.move_by=27 first.then_b=5 first.then_by=-54",
    // The stored depth's step is longer than the caster's shadow is deep: within it LI is
    // anything.
    "eye_distance=16 near=14",
    "kind=1 light_size=-3 floor_tilt_x=1 eye_y=-4 eye_distance=20 view=-3 near=17 first.x=-3",
    // `fixed`: ends of edges of which no bit is left beside the other end or the light's thin
    // side.
    "light_flat=24 view=2 first.turn=2",
    "format=1 light_flat=16 light_tilt_x=1 eye_place=1 eye_x=5 close_up=1 first.depth=13 "
    "first.thick=-14 first.x=2 first.turn=2 first.z1=7 first.then=1 first.then_b=6",
    "light_flat=20 light_tilt_x=6 floor_tilt_x=5 eye_x=2 eye_y=2 far=6 target_z=8 first.shape=3 "
    "first.depth=-7 first.x=3",
    // The same of a sphere 2^-22 as large as it is far away.
    "light=1 light_size=-22 eye_place=5 first.shape=4 first.depth=-12 first.z3=5",
    // The eye in a quad's plane that is mostly rounding.
    "light_size=-7 turn=1 grid=1 eye_place=1 close_up=1 up=1 first.depth=-20 first.x1=-1",
    // A quad's plane and what its edge covers disagree on which side the point is.
    "light_tilt_x=-1 eye_y=-2 near=20 target_z=7 first.shape=1 first.size=-20 first.thick=-16 "
    "first.x=1 first.z1=-5",
    // All arithmetics are wrong alike: `fixed` and `float32` did not say so.
    "format=3 light_size=-16 turn=5 floor_tilt_z=2 eye_z=1 near=20 far=22 target_z=-2 "
    "close_up=1 casters=1 first.shape=2 first.depth=-14 first.pyramid=1 first.z2=-5 first.y3=-6 "
    "first.move_a=2 first.move_b=4 first.move_by=-10 first.then_a=3 first.then_b=2 "
    "first.then_by=47 second.shape=2 second.thick=-14 second.x=8 second.z=-7 second.y2=4 "
    "second.z2=6 second.z3=-5 second.move=5 second.move_by=34 second.then_a=6 second.then_b=7 "
    "second.then_by=14",
};

Case case_at(std::span<const std::string_view> cases, double index) {
  const double last = static_cast<double>(cases.size() - 1);
  return case_of(genes_of(cases[static_cast<std::size_t>(std::clamp(index, 0.0, last))]));
}
Case found(std::uint64_t, double index) { return case_at(kFound, index); }
Case found_flagged(std::uint64_t, double index) { return case_at(kFlagged, index); }

std::vector<double> places_of(std::span<const std::string_view> cases) {
  std::vector<double> places(cases.size());
  std::iota(places.begin(), places.end(), 0.0);
  return places;
}

}  // namespace

std::vector<Family> found_families() {
  const std::vector<double> found_places = places_of(kFound);
  return {{.name = "found",
           .parameter = "number of a frame that the random search found",
           .unit = "",
           .levels = found_places,
           .required = {found_places.back(), found_places.back()},
           .make = found,
           .step = 1.0,
           .empty_levels = {19.0, 22.0},  // a light so small, or a depth so coarse
           .seeded = false},
          {.name = "found-flagged",
           .parameter = "number of a frame that the random search found, which some arithmetic can "
                        "only flag",
           .unit = "",
           .levels = places_of(kFlagged),
           .required = {},
           .make = found_flagged,
           .step = 1.0,
           .seeded = false}};
}

}  // namespace wedgesim::reports::stress

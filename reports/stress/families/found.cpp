#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/random_case.h"

namespace wedgesim::reports::stress {
namespace {

// What random_search_test.cpp found and made simple, each once wrong for the reason above it. Their
// order never changes: a frame is called by its place.
constexpr std::array<std::string_view, 17> kFound{
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
};

Case found(std::uint64_t, double index) {
  const double last = static_cast<double>(kFound.size() - 1);
  return case_of(genes_of(kFound[static_cast<std::size_t>(std::clamp(index, 0.0, last))]));
}

}  // namespace

std::vector<Family> found_families() {
  std::vector<double> levels;
  for (std::size_t i = 0; i < kFound.size(); ++i) levels.push_back(static_cast<double>(i));
  return {{"found",
           "number of a frame that the random search found",
           "",
           levels,
           {levels.back(), levels.back()},
           found}};
}

}  // namespace wedgesim::reports::stress

// What the papers say their methods get wrong, and where it shows.
#include <array>

#include "reports/accuracy/artifact_scenes.h"
#include "reports/accuracy/artifacts.h"

namespace wedgesim::reports::accuracy {
namespace {

using functional::Scene;
using Kind = Criterion::Kind;

constexpr std::string_view kBoard = "A board over a floor";

Scene board() { return thin_board({1.0, 0.7}, 0.4, 4.0, 1.0); }
Scene square_board() { return thin_board({1.0, 1.0}, 0.0, 4.0, 1.0); }
Scene turned_square() { return thin_board({1.0, 1.0}, 0.4, 4.0, 1.0); }
Scene thin_strip() { return thin_board({0.025, 1.0}, 0.0, 3.0, 1.5); }
Scene kite() {
  return thin_polygon({{-1.4, 0.0}, {1.2, 0.25}, {1.4, 0.0}, {1.2, -0.25}}, 4.0, 0.5);
}
Scene small_box() { return boxes_below_sphere({{{0.3, 0.1, 0.3}, {0.3, 3.0, 0.0}}}, 0.8); }
Scene boxes_apart() {
  return boxes_below_sphere({{{0.8, 0.2, 0.8}, {-1.8, 3.0, -1.0}, {0.0, 25.0, 0.0}},
                             {{0.8, 0.2, 0.8}, {2.0, 3.0, 1.0}, {0.0, 25.0, 0.0}}},
                            0.2);
}
Scene two_boards() {
  return boxes_below_sphere(
      {{{2.4, 0.1, 1.6}, {0.0, 1.0, 0.0}}, {{0.8, 0.1, 2.0}, {0.2, 3.0, 0.0}}}, 0.5);
}
Scene big_light_box() { return built_in_scene("big-light-box"); }
Scene overlap() { return built_in_scene("overlap"); }
Scene columns() { return built_in_scene("columns"); }
Scene eye_in_shadow() { return built_in_scene("eye-in-shadow"); }
Scene fine_fence() { return fence(40, 0.04, 0.04, 4.0, 2.0); }
Scene comb() { return comb_below_sphere(4, 0.5, 0.12, 0.4); }
Scene dense_comb() { return comb_below_sphere(9, 0.12, 0.18, 0.8); }
Scene steep_roof() {
  return boxes_below_sphere(
      {{{1.6, 0.1, 1.2}, {0.3, 4.0, 0.0}}, {{6.0, 0.05, 6.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 55.0}}},
      0.5);
}

constexpr std::array kArtifacts{
    Artifact{.name = "no-penumbra",
             .choice = "hard",
             .remedy = "sampled-64",
             .scene = kBoard,
             .make = board,
             .crop = {20, 30, 200, 180},
             .criterion = {Kind::wrong, 0.15},
             .paper = "Paper I, section 1",
             .says = "Volumes from one point of the light have no penumbra.",
             .look = "The outline is sharp wherever it should fade."},
    Artifact{.name = "banding",
             .choice = "sampled-16",
             .remedy = "sampled-256",
             .scene = kBoard,
             .make = square_board,
             .crop = {20, 20, 80, 80},
             .criterion = {Kind::steps, 0.1},
             .paper = "Paper III, section 5.1, figure 14",
             .says = "Too few points of a large light can be told apart in the shadow.",
             .look = "The penumbra is a stair: each step is one hard shadow's edge."},
    Artifact{.name = "too-large-umbra",
             .choice = "wedge-2002:extra=off",
             .remedy = "ssv",
             .scene = "columns",
             .make = columns,
             .crop = {870, 494, 90, 36},
             .criterion = {Kind::too_dark, 0.05},
             .paper = "Paper III, section 1, figure 2",
             .says = "Of edges of unlike depth the wedges' side planes meet inside them.",
             .look = "The penumbra is too dark, and a spike reaches out of the shadow."},
    Artifact{.name = "leaking-umbra",
             .choice = "wedge-2002:extra=off",
             .remedy = "wedge-restructured",
             .scene = "columns",
             .make = columns,
             .crop = {710, 320, 200, 50},
             .criterion = {Kind::too_light, 0.1},
             .paper = "Paper III, section 1, figure 2",
             .says = "Wedges that do not close together with their neighbours leave holes.",
             .look = "Most of a column's shadow is gone."},
    Artifact{.name = "eye-in-shadow",
             .choice = "wedge-2002",
             .remedy = "wedge-restructured",
             .scene = "eye-in-shadow",
             .make = eye_in_shadow,
             .crop = {100, 420, 200, 160},
             .criterion = {Kind::too_light, 0.3},
             .paper = "Paper I, section 8",
             .says = "A ray that begins in a shadow enters none: its entry is not counted.",
             .look = "From within the roof's shadow nothing is dark."},
    Artifact{.name = "too-large-umbra",
             .choice = "wedge-restructured",
             .remedy = "ssv",
             .scene = "columns",
             .make = columns,
             .crop = {870, 494, 90, 36},
             .criterion = {Kind::too_dark, 0.05},
             .paper = "Paper III, section 1, figure 2",
             .says = "Of edges of unlike depth the wedges' side planes meet inside them.",
             .look = "The penumbra is too dark, and a spike reaches out of the shadow."},
    Artifact{.name = "leaking-umbra",
             .choice = "wedge-restructured",
             .remedy = "ssv",
             .scene = "columns",
             .make = columns,
             .crop = {335, 381, 84, 18},
             .criterion = {Kind::too_light, 0.1},
             .paper = "Paper III, section 1, figure 2",
             .says = "Wedges that do not close together with their neighbours leave holes.",
             .look = "Streaks of light along the umbra."},
    Artifact{.name = "single-silhouette",
             .choice = "ssv",
             .remedy = "sampled-256",
             .scene = "big-light-box",
             .make = big_light_box,
             .crop = {360, 320, 200, 110},
             .criterion = {Kind::too_light, 0.1},
             .paper = "Paper III, section 5.3, figure 17",
             .says = "The silhouette that the light's middle sees stands for those of all its "
                     "points.",
             .look = "The umbra below the box is not dark, and its sides are too light at the "
                     "edges."},
    Artifact{.name = "object-overlap",
             .choice = "ssv",
             .remedy = "sampled-256",
             .scene = "overlap",
             .make = overlap,
             .crop = {404, 336, 80, 30},
             .criterion = {Kind::too_dark, 0.01},
             .paper = "Paper III, section 5.3, figure 18",
             .says = "Of casters that overlap as the light sees them, the hidden parts are added.",
             .look = "The umbra's inner corners are straight where they should be round."},
    Artifact{.name = "texture-quantization",
             .choice = "ssv:texture=8",
             .remedy = "ssv:texture=32,filter=quadlinear",
             .scene = kBoard,
             .make = turned_square,
             .crop = {20, 20, 200, 200},
             .criterion = {Kind::steps, 0.05},
             .paper = "Paper III, sections 3.3 and 5.1, figure 13",
             .says = "A coverage texture has few entries, and its samples show.",
             .look = "The penumbra has steps, one for each pair of entries."},
    Artifact{.name = "v-buffer-overflow",
             .choice = "ssv:vbuffer=8bit",
             .remedy = "ssv",
             .scene = "A fence of forty thin bars below a large light",
             .make = fine_fence,
             .crop = {90, 90, 60, 60},
             .criterion = {Kind::wrong, 0.2},
             .paper = "Paper III, section 4.2",
             .says = "Eight bits hold four lights of what overlapping penumbrae add or take.",
             .look = "The middle is black where every other part of the light is seen."},
    Artifact{.name = "single-silhouette",
             .choice = "ssv-optimized",
             .remedy = "ssv-optimized:split=4",
             .scene = "big-light-box",
             .make = big_light_box,
             .crop = {360, 320, 200, 110},
             .criterion = {Kind::too_light, 0.1},
             .paper = "Paper IV, section 5.2, figure 8",
             .says = "The silhouette that the light's middle sees stands for those of all its "
                     "points; each of several smaller lights has its own.",
             .look = "The umbra below the box is not dark; with sixteen lights it is."},
    Artifact{.name = "object-overlap",
             .choice = "ssv-optimized",
             .remedy = "ssv-optimized:overlap=loops",
             .scene = "overlap",
             .make = overlap,
             .crop = {404, 336, 80, 30},
             .criterion = {Kind::too_dark, 0.01},
             .paper = "Paper IV, section 5.1, figure 7",
             .says = "What silhouettes that overlap hide is added; the larger and half the smaller "
                     "lies between the extremes.",
             .look = "The umbra's inner corners are straight where they should be round."},
    Artifact{.name = "too-dark-small-occluder",
             .choice = "d-buffer",
             .remedy = "d-buffer:falloff=sqrt",
             .scene = "A small box far above a floor",
             .make = small_box,
             .crop = {88, 88, 64, 54},
             .criterion = {Kind::too_dark, 0.02},
             .paper = "D-buffer 2004, section 6.2, figure 8",
             .says =
                 "A point that sees the light past both sides of a small caster gets too little "
                 "of it.",
             .look = "The shadow's middle is too dark; less so with the square root of t."},
    Artifact{.name = "concave-occluder",
             .choice = "d-buffer",
             .remedy = "sampled-256",
             .scene = "A board above another one",
             .make = two_boards,
             .crop = {90, 75, 70, 46},
             .criterion = {Kind::wrong, 0.15},
             .paper = "D-buffer 2004, section 6.2, figure 7",
             .says = "Of casters behind each other the map keeps the distances of the farthest "
                     "alone.",
             .look = "The shadow on the lower board has the wrong place and no right penumbra."},
    Artifact{.name = "acute-corner",
             .choice = "d-buffer",
             .remedy = "sampled-256",
             .scene = "A kite's tip over a floor",
             .make = kite,
             .crop = {20, 95, 50, 50},
             .criterion = {Kind::too_dark, 0.05},
             .paper = "D-buffer 2004, section 6.2",
             .says = "Where silhouette edges meet in a sharp angle, one of the two alone counts.",
             .look = "The tip's shadow reaches too far and is too dark."},
    Artifact{.name = "map-resolution",
             .choice = "d-buffer:resolution=128",
             .remedy = "d-buffer:resolution=2048,lookup=bilinear",
             .scene = "Two boxes far apart, in one map",
             .make = boxes_apart,
             .crop = {184, 130, 56, 72},
             .criterion = {Kind::steps, 0.3},
             .paper = "D-buffer 2004, section 6.2",
             .says = "A map has texels, and they show.",
             .look = "The penumbra is made of squares."},
    Artifact{.name = "overlapping-penumbrae",
             .choice = "occlusion-camera:lookups=1",
             .remedy = "occlusion-camera",
             .scene = "Four bars beside each other",
             .make = comb,
             .crop = {108, 124, 8, 24},
             .criterion = {Kind::too_light, 0.04},
             .paper = "Occlusion camera 2006, section 3.2.3",
             .says = "A texel holds one silhouette; the light that a second one hides has to be "
                     "looked for.",
             .look = "The light through the gaps is too bright, less so with three lookups."},
    Artifact{.name = "crowded-distortion-map",
             .choice = "occlusion-camera",
             .remedy = "sampled-256",
             .scene = "Nine thin bars below a large light",
             .make = dense_comb,
             .crop = {36, 106, 150, 72},
             .criterion = {Kind::wrong, 0.1},
             .paper = "Occlusion camera 2006, section 6, figure 13",
             .says = "With a large light and narrow gaps more silhouettes meet in a texel than it "
                     "can hold.",
             .look = "Dark and light streaks that end at once."},
    Artifact{.name = "false-shadows",
             .choice = "occlusion-camera:bias=0",
             .remedy = "occlusion-camera",
             .scene = "A steep roof below a board",
             .make = steep_roof,
             .crop = {150, 30, 44, 80},
             .criterion = {Kind::too_dark, 0.03},
             .paper = "Occlusion camera 2006, section 3.2",
             .says = "A bent ray may end on a nearer part of the surface that it is for.",
             .look = "The penumbra at the roof's upper edge is black."},
    Artifact{.name = "ring-gradient",
             .choice = "silhouette-rings-5",
             .remedy = "sampled-256",
             .scene = kBoard,
             .make = turned_square,
             .crop = {10, 10, 110, 220},
             .criterion = {Kind::bends, 0.15},
             .paper = "Silhouette rings, section 4, figure 5",
             .says = "Where triangles whose gradients turn meet, their edges can be seen.",
             .look = "Folds from ring to ring across the penumbra."},
    Artifact{.name = "too-narrow-penumbra",
             .choice = "silhouette-rings-3",
             .remedy = "silhouette-rings-25",
             .scene = kBoard,
             .make = board,
             .crop = {180, 110, 44, 70},
             .criterion = {Kind::too_light, 0.05},
             .paper = "Silhouette rings, section 3.2",
             .says = "The outermost ring is the outermost sample's, inside the light's border.",
             .look = "The shadow ends too early, less so with more samples."},
    Artifact{.name = "lost-thin-occluder",
             .choice = "silhouette-rings-9",
             .remedy = "sampled-256",
             .scene = "A thin strip over a floor",
             .make = thin_strip,
             .crop = {80, 40, 80, 160},
             .criterion = {Kind::too_light, 0.02},
             .paper = "Silhouette rings, section 4",
             .says =
                 "Shadows of something thinner than the distance of samples do not overlap, and "
                 "a single one has no darkness.",
             .look = "There is no shadow."},
    Artifact{.name = "grid-steps",
             .choice = "silhouette-rings:samples=9,pattern=grid",
             .remedy = "silhouette-rings-9",
             .scene = kBoard,
             .make = square_board,
             .crop = {20, 20, 200, 200},
             .criterion = {Kind::steps, 0.2},
             .paper = "Silhouette rings, section 3.1",
             .says = "Of samples in rows, the shadows of an edge along them fall on one line.",
             .look = "Steps of three samples at once."},
};

}  // namespace

std::span<const Artifact> artifacts() { return kArtifacts; }

}  // namespace wedgesim::reports::accuracy

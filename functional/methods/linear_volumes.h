#pragma once

#include <vector>

#include "functional/methods/volumes.h"

namespace wedgesim::functional {

struct LinearChoices {
  ZChoice z = ZChoice::automatic;
  bool umbra_polygons = true;  // the wedges' front faces as polygons of their own (Paper II)
  bool round_corners = false;  // extra wedges at acute corners (round_corners.h)
};

/// The wedges of Papers I and II (linear_wedge.h) of all silhouette loops on the screen. Their
/// forms are their planes, inwards, then 1; their constants LinearWedge::factors. \throws
/// InputError if z-pass is asked for where it is wrong
std::vector<ScreenSide> build_linear_volumes(const Scene& scene, const Window& window,
                                             const Light& light,
                                             const std::vector<ShadowCaster>& casters,
                                             const LinearChoices& choices);

}  // namespace wedgesim::functional

#pragma once

#include "model/count/config.h"
#include "model/units/primitive_setup.h"

namespace wedgesim::model::units {

/// What decides a face's visit of a tile: the test that culls it, or none.
Cull cull_face(Cull enabled, const SetupPrimitive& primitive, const SetupFace& face,
               const datapath::FixedBox& box, bool z_fail);

/// Is the whole box inside the wedge? Then its pixels skip their inside tests.
bool inside_wedge(const SetupPrimitive& primitive, const datapath::FixedBox& box);

enum class UmbraDecision { read, culled, accepted };

/// What the enabled tests say of an umbra polygon in a tile. Not for caps.
UmbraDecision decide_umbra(UmbraCull cull, Accept accept, const SetupUmbra& umbra,
                           const datapath::FixedBox& box, bool z_fail);

}  // namespace wedgesim::model::units

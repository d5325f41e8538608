#pragma once

#include "base/counter.h"

namespace wedgesim::model {

/// What one run of the block accesses (docs/counting.md defines each). One word is one access of
/// one pixel or one tile.
struct Counters : Group {
  // clang-format off
  Counter z_reads{*this, "z_reads", Unit::accesses, "Depth words read by inside and umbra tests"};
  Counter z_reads_whole_tile{*this, "z_reads_whole_tile", Unit::accesses, "Depth words read if a surviving tile reads all its pixels"};
  Counter li_writes{*this, "li_writes", Unit::accesses, "Words written to LI, stencil writes included"};
  Counter stencil_writes{*this, "stencil_writes", Unit::accesses, "The part of li_writes that goes to the stencil"};
  Counter stencil_reads{*this, "stencil_reads", Unit::accesses, "Stencil words read to be modified"};
  Counter li_reads{*this, "li_reads", Unit::accesses, "LI words read to be modified"};
  Counter tile_visits{*this, "tile_visits", Unit::visits, "Tiles in which a face or an unshared umbra polygon covers a pixel"};
  Counter tile_reads{*this, "tile_reads", Unit::accesses, "Words of zmin and zmax that the visits' tests name"};
  Counter tile_build_reads{*this, "tile_build_reads", Unit::accesses, "Depth words read to make the tiles' zmin and zmax"};
  Counter tile_words{*this, "tile_words", Unit::words, "Words of zmin and zmax stored"};
  Counter visits_culled_zmax{*this, "visits_culled_zmax", Unit::visits, "Face visits culled by the zmax test"};
  Counter visits_culled_zrange{*this, "visits_culled_zrange", Unit::visits, "Face visits culled by the zrange test"};
  Counter visits_culled_planes{*this, "visits_culled_planes", Unit::visits, "Face visits culled by the planes test"};
  Counter visits_culled_sat{*this, "visits_culled_sat", Unit::visits, "Face visits culled by the sat test"};
  Counter umbra_visits_culled{*this, "umbra_visits_culled", Unit::visits, "Tiles in which an umbra polygon is culled"};
  Counter umbra_visits_accepted{*this, "umbra_visits_accepted", Unit::visits, "Tiles in which an umbra polygon is written without reading depth"};
  Counter tiles_inside{*this, "tiles_inside", Unit::visits, "Surviving face visits whose tile is fully inside the wedge"};
  Counter pixels_covered{*this, "pixels_covered", Unit::pixels, "Pixels covered by faces and umbra polygons, before culling"};
  Counter pixels_inside{*this, "pixels_inside", Unit::pixels, "Pixels inside a wedge, summed over wedges"};
  Counter merge_reads{*this, "merge_reads", Unit::accesses, "Stencil and LI words read to merge the stencil into LI"};
  Counter merge_writes{*this, "merge_writes", Unit::accesses, "LI words written by the merge"};
  Counter clear_writes{*this, "clear_writes", Unit::accesses, "Words written to clear LI and the stencil"};
  Counter wedge_bytes{*this, "wedge_bytes", Unit::bytes, "Wedge records fetched, by every pass"};
  Counter z_reads_min{*this, "z_reads_min", Unit::pixels, "Pixels whose depth this run reads at least once"};
  Counter li_writes_min{*this, "li_writes_min", Unit::pixels, "Pixels that this run writes at least once"};
  Counter z_reads_floor{*this, "z_reads_floor", Unit::pixels, "Pixels inside at least one wedge"};
  Counter li_writes_floor{*this, "li_writes_floor", Unit::pixels, "Pixels whose final LI word is not fully lit"};
  Counter li_overflow_pixels{*this, "li_overflow_pixels", Unit::pixels, "Pixels whose true LI or stencil sum is out of range"};
  Counter contributions_max{*this, "contributions_max", Unit::accesses, "The most contributions to one pixel"};
  Counter degenerate_wedges{*this, "degenerate_wedges", Unit::wedges, "Wedges that cover no pixel"};
  Counter all_bytes{*this, "all_bytes", Unit::bytes, "All traffic at the configured word widths"};
  // clang-format on
};

}  // namespace wedgesim::model

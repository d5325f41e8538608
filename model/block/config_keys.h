#pragma once

#include <array>
#include <string_view>

#include "model/block/config.h"

namespace wedgesim::model {

/// One number of a block's configuration: reader, printer, checks and documents share the table.
struct BlockKey {
  std::string_view section, key;
  int& (*of)(BlockConfig& config);
  int low, high;
  bool power_of_two;
  std::string_view what;
};

inline constexpr std::array<std::string_view, 9> kBlockSections{
    "block",  "wedge_fetch", "wedge_setup", "tile_walk", "tile_cull",
    "z_read", "penumbra",    "li_update",   "memory"};

// clang-format off
inline constexpr std::array kBlockKeys{
    BlockKey{"block", "clock_mhz", [](BlockConfig& c) -> int& { return c.clock_mhz; }, 1, 10000, false, "clock, MHz"},

    BlockKey{"wedge_fetch", "outstanding", [](BlockConfig& c) -> int& { return c.wedge_fetch.outstanding; }, 1, 256, false, "lines under way"},
    BlockKey{"wedge_fetch", "out_depth", [](BlockConfig& c) -> int& { return c.wedge_fetch.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"wedge_fetch", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.wedge_fetch.out.latency_cycles; }, 1, 1024, false, "to the next unit"},

    BlockKey{"wedge_setup", "cycles_a_plane", [](BlockConfig& c) -> int& { return c.wedge_setup.cycles_a_plane; }, 0, 64, false, "to prepare a plane"},
    BlockKey{"wedge_setup", "cycles_an_edge", [](BlockConfig& c) -> int& { return c.wedge_setup.cycles_an_edge; }, 0, 64, false, "to prepare an edge function"},
    BlockKey{"wedge_setup", "out_depth", [](BlockConfig& c) -> int& { return c.wedge_setup.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"wedge_setup", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.wedge_setup.out.latency_cycles; }, 1, 1024, false, "to the next unit"},

    BlockKey{"tile_walk", "cycles_a_tile", [](BlockConfig& c) -> int& { return c.tile_walk.cycles_a_tile; }, 1, 64, false, "to step over a touched tile"},
    BlockKey{"tile_walk", "out_depth", [](BlockConfig& c) -> int& { return c.tile_walk.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"tile_walk", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.tile_walk.out.latency_cycles; }, 1, 1024, false, "to the next unit"},

    BlockKey{"tile_cull", "cache_bytes", [](BlockConfig& c) -> int& { return c.tile_cull.cache.size_bytes; }, 0, 1 << 26, true, "of zmin and zmax; 0: none, else at least a line of 64"},
    BlockKey{"tile_cull", "cache_ways", [](BlockConfig& c) -> int& { return c.tile_cull.cache.ways; }, 1, 64, true, "of that cache"},
    BlockKey{"tile_cull", "outstanding", [](BlockConfig& c) -> int& { return c.tile_cull.outstanding; }, 1, 256, false, "lines under way"},
    BlockKey{"tile_cull", "out_depth", [](BlockConfig& c) -> int& { return c.tile_cull.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"tile_cull", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.tile_cull.out.latency_cycles; }, 1, 1024, false, "to the next unit"},

    BlockKey{"z_read", "cache_bytes", [](BlockConfig& c) -> int& { return c.z_read.cache.size_bytes; }, 0, 1 << 26, true, "of depth; 0: none, else at least a line of 64"},
    BlockKey{"z_read", "cache_ways", [](BlockConfig& c) -> int& { return c.z_read.cache.ways; }, 1, 64, true, "of that cache"},
    BlockKey{"z_read", "outstanding", [](BlockConfig& c) -> int& { return c.z_read.outstanding; }, 1, 256, false, "lines under way"},
    BlockKey{"z_read", "out_depth", [](BlockConfig& c) -> int& { return c.z_read.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"z_read", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.z_read.out.latency_cycles; }, 1, 1024, false, "to the next unit"},

    BlockKey{"penumbra", "lanes", [](BlockConfig& c) -> int& { return c.penumbra.lanes; }, 1, 16, true, "pixels a cycle"},
    BlockKey{"penumbra", "out_depth", [](BlockConfig& c) -> int& { return c.penumbra.out.depth; }, 1, 1024, false, "items in the queue to the next unit"},
    BlockKey{"penumbra", "out_latency_cycles", [](BlockConfig& c) -> int& { return c.penumbra.out.latency_cycles; }, 1, 1024, false, "depth of the datapath's pipeline"},

    BlockKey{"li_update", "cache_bytes", [](BlockConfig& c) -> int& { return c.li_update.cache.size_bytes; }, 0, 1 << 26, true, "of LI; 0: none, else at least a line of 64"},
    BlockKey{"li_update", "cache_ways", [](BlockConfig& c) -> int& { return c.li_update.cache.ways; }, 1, 64, true, "of that cache"},
    BlockKey{"li_update", "stencil_cache_bytes", [](BlockConfig& c) -> int& { return c.li_update.stencil_cache.size_bytes; }, 0, 1 << 26, true, "of the stencil; 0: none, else at least a line of 64"},
    BlockKey{"li_update", "stencil_cache_ways", [](BlockConfig& c) -> int& { return c.li_update.stencil_cache.ways; }, 1, 64, true, "of that cache"},
    BlockKey{"li_update", "outstanding", [](BlockConfig& c) -> int& { return c.li_update.outstanding; }, 1, 256, false, "fills under way"},
    BlockKey{"li_update", "outstanding_writes", [](BlockConfig& c) -> int& { return c.li_update.outstanding_writes; }, 1, 256, false, "lines on their way to memory"},
    BlockKey{"li_update", "update_cycles", [](BlockConfig& c) -> int& { return c.li_update.update_cycles; }, 1, 64, false, "from a word's read to its write"},

    BlockKey{"memory", "latency_cycles", [](BlockConfig& c) -> int& { return c.memory.ideal.latency_cycles; }, 0, 1000000, false, "of the ideal memory, cycles of the block"},
    BlockKey{"memory", "bytes_per_cycle", [](BlockConfig& c) -> int& { return c.memory.ideal.bytes_per_cycle; }, 1, 65536, false, "of the ideal memory"},
};
// clang-format on

}  // namespace wedgesim::model

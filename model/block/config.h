#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/count/config.h"
#include "model/datapath/formats.h"
#include "model/memory/dram_config.h"
#include "model/memory/ideal_memory.h"
#include "model/units/li_update.h"
#include "model/units/penumbra.h"
#include "model/units/tile_cull.h"
#include "model/units/tile_walk.h"
#include "model/units/wedge_fetch.h"
#include "model/units/wedge_setup.h"
#include "model/units/z_read.h"

namespace wedgesim::model {

enum class MemoryKind { ideal, dram };
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<MemoryKind>{"ideal", "dram"};
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<units::Clear>{"none", "write"};

struct MemoryConfig {
  MemoryKind kind = MemoryKind::ideal;
  memory::IdealMemoryConfig ideal;
  memory::DramConfig dram;
};

/// A block and its memory: one checked struct a unit.
struct BlockConfig {
  std::string name = "paper2-single";  // of the preset, or the file
  int clock_mhz = 500;                 // of the block
  CountConfig rasterizer;              // what is done; the rest is how long it takes
  datapath::Formats formats;
  units::WedgeFetchConfig wedge_fetch;
  units::WedgeSetupConfig wedge_setup;
  units::TileWalkConfig tile_walk;
  units::TileCullConfig tile_cull;
  units::ZReadConfig z_read;
  units::PenumbraConfig penumbra;
  units::LiUpdateConfig li_update;
  MemoryConfig memory;
};

/// The names of the built-in configurations.
std::vector<std::string_view> block_presets();

/// A preset by its name, or a TOML file: the preset that its key `preset` names with what it
/// changes, or, without that key, every key there is.
/// \throws InputError naming the file, the line and the key that is unknown, missing or out of
/// range
BlockConfig read_block(const std::string& name_or_file);

/// The same for text. \param file  the name errors give
BlockConfig parse_block(std::string_view text, const std::string& file);

/// Every key, its value and what it is: a file that read_block takes.
std::string to_toml(const BlockConfig& config);

}  // namespace wedgesim::model

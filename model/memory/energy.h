#pragma once

#include <cstdint>
#include <filesystem>

#include "base/toml_table.h"

namespace wedgesim::model::memory {

/// What an access costs, picojoules: the user's numbers, there are no defaults.
struct EnergyTable {
  double datapath_word_pj = 0.0;  // a word that the datapath reads or writes
  double cache_access_pj = 0.0;   // a cache looked up once
  double dram_byte_pj = 0.0;      // a byte on a DRAM's data bus
  double dram_activate_pj = 0.0;  // a row opened, and closed again
};

/// How often that happened.
struct EnergyCounts {
  std::uint64_t datapath_words = 0;
  std::uint64_t cache_accesses = 0;
  std::uint64_t dram_bytes = 0;
  std::uint64_t dram_activates = 0;
};

/// Picojoules.
struct Energy {
  double datapath = 0.0, cache = 0.0, dram_bytes = 0.0, dram_activates = 0.0;
  double total() const { return ((datapath + cache) + dram_bytes) + dram_activates; }
};

/// Reads the four keys of EnergyTable, each a number from 0 to 1,000,000.
/// \throws InputError naming file, line and key if one is missing, unknown or out of range
EnergyTable read_energy(const TomlTable& table);

/// The same from a TOML file.
EnergyTable read_energy(const std::filesystem::path& file);

Energy energy_of(const EnergyTable& table, const EnergyCounts& counts);

}  // namespace wedgesim::model::memory

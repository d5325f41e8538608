#include "model/memory/energy.h"

#include "base/file.h"

namespace wedgesim::model::memory {

EnergyTable read_energy(const TomlTable& table) {
  const auto picojoules = [&](std::string_view key) {
    return table.number(key, {}, {0.0, Range::kLargest});
  };
  EnergyTable energy;
  energy.datapath_word_pj = picojoules("datapath_word_pj");
  energy.cache_access_pj = picojoules("cache_access_pj");
  energy.dram_byte_pj = picojoules("dram_byte_pj");
  energy.dram_activate_pj = picojoules("dram_activate_pj");
  table.reject_unknown();
  return energy;
}

EnergyTable read_energy(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  const toml::table root = parse_toml(mapped.text(), file.string());
  return read_energy(TomlTable(root, file.string()));
}

Energy energy_of(const EnergyTable& table, const EnergyCounts& counts) {
  const auto product = [](double each, std::uint64_t count) {
    return each * static_cast<double>(count);
  };
  return {product(table.datapath_word_pj, counts.datapath_words),
          product(table.cache_access_pj, counts.cache_accesses),
          product(table.dram_byte_pj, counts.dram_bytes),
          product(table.dram_activate_pj, counts.dram_activates)};
}

}  // namespace wedgesim::model::memory

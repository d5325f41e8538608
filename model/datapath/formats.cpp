#include "model/datapath/formats.h"

#include <toml++/toml.h>

#include <optional>

#include "base/file.h"
#include "base/toml_table.h"

namespace wedgesim::model::datapath {

void read_formats(const TomlTable& table, bool complete, Formats& formats) {
  for (const Width& width : kWidths) {
    int& value = width.of(formats);
    const std::optional<int> fallback = complete ? std::nullopt : std::optional<int>(value);
    value = table.integer(width.key, fallback, width.low, width.high);
  }
  table.reject_unknown();
}

Formats read_formats(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  const toml::table root = parse_toml(mapped.text(), file.string());
  Formats formats;
  read_formats(TomlTable(root, file.string()), false, formats);
  return formats;
}

}  // namespace wedgesim::model::datapath

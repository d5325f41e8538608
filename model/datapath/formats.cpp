#include "model/datapath/formats.h"

#include <toml++/toml.h>

#include <string>

#include "base/file.h"
#include "base/toml_table.h"

namespace wedgesim::model::datapath {

Formats read_formats(const std::filesystem::path& file) {
  const MappedFile mapped(file);
  const auto bytes = mapped.bytes();
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const toml::table root = parse_toml(text, file.string());
  const TomlTable table(root, file.string());
  Formats formats;
  for (const Width& width : kWidths) {
    int& value = width.of(formats);
    value = table.integer(width.key, value, width.low, width.high);
  }
  table.reject_unknown();
  return formats;
}

}  // namespace wedgesim::model::datapath

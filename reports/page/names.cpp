#include "reports/page/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "model/count/config.h"
#include "reports/runner/value.h"
#include "reports/table.h"

namespace wedgesim::reports::page {
namespace {

struct Known {
  std::string_view key, label, unit;
  Better better = Better::neither;
};

// clang-format off
constexpr Known kKnown[] = {
  {"size", "resolution", "pixels"},
  {"pixels", "pixels of the frame", ""},
  {"wedges", "silhouette edges (wedges)", ""},
  {"light_scale", "light size", "times the scene's"},
  {"block.tile", "tile", "pixels"},
  {"block.mode", "mode", ""},
  {"block.cull", "culling", ""},
  {"block.umbra_cull", "umbra culling", ""},
  {"block.accept", "acceptance", ""},
  {"block.share", "sharing", ""},
  {"block.z", "z method", ""},
  {"block.tile_build", "tile build", ""},
  {"penumbra.lanes", "lanes", "pixels a cycle"},
  {"memory.kind", "kind of memory", ""},
  {"z_reads", "z reads", "words", Better::less},
  {"li_writes", "LI writes", "words", Better::less},
  {"accesses", "z reads and LI writes", "words", Better::less},
  {"all_bytes", "all traffic", "bytes", Better::less},
  {"over_floor", "accesses over the floor", "times", Better::less},
  {"cull_efficiency", "cull efficiency", "% of a perfect cull", Better::more},
  {"needless_visits", "needless visits", "visits"},
  {"tile_visits", "tile visits", "visits", Better::less},
  {"cycles", "cycles", "", Better::less},
  {"frames_per_second", "frames per second", "", Better::more},
  {"port_gb_per_second", "traffic at the memory port", "GB/s"},
  {"busiest_bytes_per_cycle", "traffic in the busiest cycles", "bytes a cycle"},
  {"bytes_over_floor", "bytes over the floor", "times", Better::less},
  {"measure", "measure", ""},
  {"preset", "preset", ""},
  {"memory.dram.preset", "memory", ""},
  {"max_error", "largest error", "of full light", Better::less},
  {"rms_error", "RMS error", "of full light", Better::less},
  {"rms_penumbra", "RMS error in penumbrae", "of full light", Better::less},
  {"mismatched", "pixels beyond their tolerance", "pixels", Better::less},
  {"format_bits", "varied widths together", "bits", Better::less},
  {"run_seconds", "run time", "s", Better::less},
  {"port_bytes", "bytes at the port", "bytes", Better::less},
};
// clang-format on

template <typename E>
std::size_t rank_in(const std::string& word) {
  const auto& words = model::kSpellings<E>;
  return static_cast<std::size_t>(std::ranges::find(words, word) - words.begin());
}

std::string without_underscores(std::string_view text) {
  std::string words(text);
  std::ranges::replace(words, '_', ' ');
  return words;
}

}  // namespace

Name name_of(std::string_view key) {
  for (const Known& known : kKnown) {
    if (known.key == key) {
      return {std::string(known.label), std::string(known.unit), known.better};
    }
  }
  Name name{without_underscores(key), "", Better::neither};
  std::ranges::replace(name.label, '.', ' ');
  if (key.starts_with("formats.")) {
    name.label = without_underscores(key.substr(8));
    name.unit = name.label.ends_with("bits") ? "" : "bits";
  }
  if (key.starts_with("block.")) name.label = without_underscores(key.substr(6));
  if (key.ends_with("cache_bytes")) name.label = without_underscores(key.substr(0, key.size() - 6));
  std::ranges::replace(name.label, '.', ' ');
  if (key.ends_with("bytes")) name.unit = "bytes";
  if (key.ends_with("cycles")) name.unit = "cycles";
  if (key.ends_with("hit_rate")) name.better = Better::more;
  return name;
}

std::size_t rank_of(std::string_view key, const std::string& word) {
  if (key == "size") return std::strtoul(word.c_str(), nullptr, 10);  // by width
  if (key == "block.cull") return rank_in<model::Cull>(word);
  if (key == "block.umbra_cull") return rank_in<model::UmbraCull>(word);
  if (key == "block.accept") return rank_in<model::Accept>(word);
  if (key == "block.share") return rank_in<model::Share>(word);
  if (key == "block.mode") return rank_in<model::Mode>(word);
  return 0;
}

Value usual_value(std::string_view key) {
  const model::CountConfig usual;
  const auto word = [](auto value) { return Value(std::string(spelling(value))); };
  if (key == "block.tile") return static_cast<std::int64_t>(usual.tile);
  if (key == "block.mode") return word(usual.mode);
  if (key == "block.cull") return word(usual.cull);
  if (key == "block.umbra_cull") return word(usual.umbra_cull);
  if (key == "block.accept") return word(usual.accept);
  if (key == "block.share") return word(usual.share);
  if (key == "block.z") return word(usual.z);
  if (key == "block.tile_build") return word(usual.tile_build);
  if (key == "depth") return std::string("unorm24");
  if (key == "kind") return std::string("coverage");
  if (key == "light") return std::string("rect");
  return {};
}

std::string number_text(double value) {
  if (!std::isfinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "not a number";
  if (value < 0) return "−" + number_text(-value);
  if (value == 0) return "0";
  if (value >= 1000.0) return grouped(static_cast<std::uint64_t>(std::llround(value)));
  if (value == std::floor(value)) return fmt::format("{:.0f}", value);
  if (value >= 100.0) return fmt::format("{:.1f}", value);
  return fmt::format("{:.3g}", value);
}

std::string value_text(const Value& value) {
  const auto number = number_of(value);
  if (!number || (*number == std::floor(*number) && std::abs(*number) < 10000)) {
    return to_text(value);
  }
  return number_text(*number);
}

std::string setting_text(const Column& column, const Value& value) {
  if (column.key == "block.mode") return value_text(value);
  return column.label + ' ' + value_text(value);
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 32);
  return text;
}

std::string percent_text(double share) {
  const double percent = std::abs(100.0 * share);
  const std::string digits = fmt::format("{:.{}f}", percent, percent < 99.95 ? 1 : 0);
  return (share < 0 && digits != "0.0" ? "−" : "") + digits + " %";
}

}  // namespace wedgesim::reports::page

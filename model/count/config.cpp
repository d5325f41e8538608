#include "model/count/config.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>

#include "base/error.h"

namespace wedgesim::model {
namespace {

bool is_tile(unsigned tile) {
  return std::has_single_bit(tile) && tile >= kMinTile && tile <= kMaxTile;
}

[[noreturn]] void refuse_tile(std::string_view option, std::string_view text) {
  throw InputError(option, fmt::format("'{}' is not a tile edge", text),
                   fmt::format("a power of two from {} to {}", kMinTile, kMaxTile));
}

}  // namespace

std::size_t detail::parse_spelling(std::span<const std::string_view> spellings,
                                   std::string_view option, std::string_view text) {
  const auto found = std::find(spellings.begin(), spellings.end(), text);
  if (found == spellings.end()) {
    throw InputError(option, fmt::format("unknown value '{}'", text),
                     fmt::format("one of {}", fmt::join(spellings, ", ")));
  }
  return static_cast<std::size_t>(found - spellings.begin());
}

unsigned parse_tile(std::string_view option, std::string_view text) {
  unsigned tile = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, tile);
  if (error != std::errc{} || stop != end || !is_tile(tile)) refuse_tile(option, text);
  return tile;
}

bool uses_z_fail(ZChoice choice, bool needed) {
  if (choice == ZChoice::pass && needed) {
    throw InputError("--z pass", "the eye's near pyramid meets a shadow volume", "fail or auto");
  }
  return choice == ZChoice::fail || (choice == ZChoice::automatic && needed);
}

void check(const CountConfig& config) {
  if (!is_tile(config.tile)) refuse_tile("--tile", std::to_string(config.tile));
}

}  // namespace wedgesim::model

#include "model/memory/layout.h"

#include "base/check.h"
#include "model/memory/config_check.h"

namespace wedgesim::model::memory {
namespace {

constexpr unsigned kBlockWords = kBlockEdge * kBlockEdge;

unsigned blocks_of(int words) {
  return (static_cast<unsigned>(words) + kBlockEdge - 1) / kBlockEdge;
}

int tiles_of(int pixels, int tile) { return (pixels + tile - 1) / tile; }

void check(const LayoutConfig& config, std::string_view place) {
  check_range(place, "width", config.width, 1, 16384);
  check_range(place, "height", config.height, 1, 16384);
  check_power_of_two(place, "tile", config.tile, 2, 256);
  check_power_of_two(place, "z_bytes", config.z_bytes, 1, 8);
  check_power_of_two(place, "li_bytes", config.li_bytes, 1, 8);
  check_power_of_two(place, "stencil_bytes", config.stencil_bytes, 1, 8);
  check_power_of_two(place, "tile_bytes", config.tile_bytes, 1, 8);
  check_range(place, "wedge_bytes", config.wedge_bytes, std::uint64_t{0}, std::uint64_t{1} << 40);
  check_multiple(place, "base", config.base, LayoutConfig::kPageBytes, std::uint64_t{1} << 48);
}

}  // namespace

std::string_view name_of(Surface surface) {
  constexpr std::array<std::string_view, kSurfaces> kNames{"wedges", "z", "li", "stencil",
                                                           "tile_depths"};
  return kNames[static_cast<std::size_t>(surface)];
}

Layout::Layout(const LayoutConfig& config, std::string_view place) {
  check(config, place);
  const unsigned columns = blocks_of(config.width);
  const unsigned rows = blocks_of(config.height);
  const auto word = [](int bytes) { return static_cast<unsigned>(bytes); };
  grids_[1] = {columns, rows, word(config.z_bytes)};
  grids_[2] = {columns, rows, word(config.li_bytes)};
  grids_[3] = {columns, rows, word(config.stencil_bytes)};
  grids_[4] = {blocks_of(tiles_of(config.width, config.tile)),
               blocks_of(tiles_of(config.height, config.tile)), word(config.tile_bytes)};
  end_ = config.base;
  for (Grid& grid : grids_) {
    grid.base = end_;
    grid.bytes = std::uint64_t{grid.columns} * grid.rows * kBlockWords * grid.word_bytes;
    if (&grid == &grids_.front()) grid.bytes = config.wedge_bytes;
    const std::uint64_t pages =
        (grid.bytes + LayoutConfig::kPageBytes - 1) / LayoutConfig::kPageBytes;
    end_ += pages * LayoutConfig::kPageBytes;
  }
}

std::uint64_t Layout::block_address(const Grid& grid, unsigned bx, unsigned by) const {
  CHECK_LT(bx, grid.columns);
  CHECK_LT(by, grid.rows);
  return grid.base + (std::uint64_t{by} * grid.columns + bx) * kBlockWords * grid.word_bytes;
}

std::uint64_t Layout::address(Surface surface, unsigned x, unsigned y) const {
  const Grid& place = grid(surface);
  const unsigned word = (y % kBlockEdge) * kBlockEdge + x % kBlockEdge;
  return block_address(place, x / kBlockEdge, y / kBlockEdge) +
         std::uint64_t{word} * place.word_bytes;
}

std::uint64_t Layout::wedge_address(std::uint64_t offset) const {
  CHECK_LT(offset, bytes(Surface::wedges));
  return base(Surface::wedges) + offset;
}

Lines Layout::lines(Surface surface, unsigned bx, unsigned by, std::uint64_t mask) const {
  const Grid& place = grid(surface);
  const std::uint64_t first = block_address(place, bx, by);
  const unsigned words = kLineBytes / place.word_bytes;  // of a line; at least a row of the block
  const std::uint64_t all =
      words == kBlockWords ? ~std::uint64_t{0} : (std::uint64_t{1} << words) - 1;
  Lines touched;
  for (unsigned word = 0; word < kBlockWords; word += words) {
    if ((mask & (all << word)) != 0) touched.push(first + std::uint64_t{word} * place.word_bytes);
  }
  return touched;
}

}  // namespace wedgesim::model::memory

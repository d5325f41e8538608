#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace wedgesim::model::memory {

/// What the block keeps in memory, in the order of its addresses.
enum class Surface : std::uint8_t { wedges, z, li, stencil, tile_depths };
inline constexpr std::size_t kSurfaces = 5;
std::string_view name_of(Surface surface);

inline constexpr unsigned kLineBytes = 64;
inline constexpr unsigned kBlockEdge = 8;  // pixels; also of blocks of tile depths, in tiles

struct LayoutConfig {
  int width = 640, height = 427;  // pixels, 1 to 16384
  int tile = 8;                   // pixels, a power of two from 2 to 256
  int z_bytes = 4;                // of a word: 1, 2, 4 or 8; so are the next three
  int li_bytes = 2;
  int stencil_bytes = 1;
  int tile_bytes = 8;             // of a tile: zmin and zmax, or the one of them that is kept
  std::uint64_t wedge_bytes = 0;  // of all records, at most 2^40
  std::uint64_t base = 0;         // address of the first surface, a multiple of kPageBytes

  static constexpr std::uint64_t kPageBytes = 4096;
};

/// The distinct lines that some pixels of one 8x8 block touch, lowest address first.
class Lines {
 public:
  const std::uint64_t* begin() const { return addresses_.data(); }
  const std::uint64_t* end() const { return addresses_.data() + count_; }
  std::size_t size() const { return count_; }
  void push(std::uint64_t address) { addresses_[count_++] = address; }

 private:
  std::array<std::uint64_t, kBlockEdge> addresses_;
  std::size_t count_ = 0;
};

/// Where each word lies. Wedge records lie one after another. The others are grids (of pixels, or
/// of tiles for the tile depths) in blocks of 8x8: a block's words are contiguous, row by row, and
/// the blocks follow each other row by row. Grids are padded to whole blocks, surfaces to pages.
class Layout {
 public:
  /// \throws InputError naming the key and its range; `place` is where the configuration stands
  explicit Layout(const LayoutConfig& config, std::string_view place = "layout");

  /// Address of the word of pixel (x, y), or of tile (x, y) for the tile depths. Not for wedges.
  std::uint64_t address(Surface surface, unsigned x, unsigned y) const;
  /// Address of a byte of the wedge records, counted from the first.
  std::uint64_t wedge_address(std::uint64_t offset) const;
  /// Bytes of a surface, its padding to whole blocks included.
  std::uint64_t bytes(Surface surface) const { return grid(surface).bytes; }
  std::uint64_t base(Surface surface) const { return grid(surface).base; }
  /// First address behind all surfaces.
  std::uint64_t end() const { return end_; }
  unsigned word_bytes(Surface surface) const { return grid(surface).word_bytes; }

  /// The lines that words of one block touch. Not for wedges.
  /// \param bx, by  the block's column and row
  /// \param mask    bit 8y + x stands for the word in column x and row y of the block
  Lines lines(Surface surface, unsigned bx, unsigned by, std::uint64_t mask) const;

 private:
  struct Grid {
    unsigned columns = 0, rows = 0;  // blocks
    unsigned word_bytes = 0;
    std::uint64_t base = 0, bytes = 0;
  };
  const Grid& grid(Surface surface) const { return grids_[static_cast<std::size_t>(surface)]; }
  std::uint64_t block_address(const Grid& grid, unsigned bx, unsigned by) const;

  std::array<Grid, kSurfaces> grids_;
  std::uint64_t end_ = 0;
};

}  // namespace wedgesim::model::memory

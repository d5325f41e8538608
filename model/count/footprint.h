#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/count/kernel.h"
#include "model/count/primitive.h"
#include "model/count/z_frame.h"

namespace wedgesim::model {

/// Rows of a frame that are worked on at once; tiles never straddle two bands.
inline constexpr int kBandRows = 256;

/// The pixels of one primitive in one band, block by block: which its polygons cover, which are
/// inside the wedge, which the umbra polygon hits.
/// Reused from primitive to primitive to keep its memory.
class Footprint {
 public:
  /// What a polygon covers of the 8 rows of a row of blocks: each row's span, the pixels that some
  /// row covers lie in [any_begin, any_end), and all rows cover [all_begin, all_end).
  struct SpanRows {
    std::array<Span, kBlock> spans;
    int any_begin = 0, any_end = 0, all_begin = 0, all_end = 0;
  };

  /// \param band  rows [band * kBandRows, (band + 1) * kBandRows) of the frame
  void build(const Primitive& primitive, const ZFrame& frame, int band, const Kernel& kernel);

  /// Blocks with a covered pixel, by rows of blocks, left to right; those of block row r of the
  /// band are [row_begin(r), row_begin(r + 1)).
  std::span<const Block> blocks() const { return blocks_; }
  std::size_t row_begin(int row) const { return row_begin_[static_cast<std::size_t>(row)]; }
  static constexpr int kRows = kBandRows / kBlock;

  /// Pixels that face i covers.
  std::uint64_t face(std::size_t block, std::size_t i) const {
    return faces_[block * face_count_ + i];
  }
  std::uint64_t outline(std::size_t block) const { return outline_[block]; }  // of all its faces
  std::uint64_t umbra(std::size_t block) const { return umbra_[block]; }      // of the polygon
  std::uint64_t inside(std::size_t block) const { return inside_[block]; }
  std::uint64_t hits(std::size_t block) const { return hits_[block]; }
  /// Pixels whose coverage is subtracted, not added; undefined outside the wedge.
  std::uint64_t negated(std::size_t block) const { return negated_[block]; }
  /// The same for all blocks.
  const std::uint64_t* inside_sets() const { return inside_.data(); }
  const std::uint64_t* negated_sets() const { return negated_.data(); }

 private:
  void find_blocks(const Primitive& primitive, const ZFrame& frame, int band);
  void add_block_row(const Primitive& primitive, const ZFrame& frame, int by);
  void test_pixels(const Primitive& primitive, const Kernel& kernel);

  std::size_t face_count_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::size_t> row_begin_;
  std::vector<std::uint64_t> faces_, outline_, umbra_, inside_, hits_, negated_, scratch_;
  std::vector<UmbraBits> umbra_bits_;
  std::vector<SpanRows> rows_;  // of the faces, then of the umbra polygon, at the block row at hand
};

}  // namespace wedgesim::model

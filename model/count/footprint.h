#pragma once

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
/// inside the wedge, which the umbra polygon hits, and what each inside pixel contributes.
/// Reused from primitive to primitive to keep its memory.
class Footprint {
 public:
  /// \param band  rows [band * kBandRows, (band + 1) * kBandRows) of the frame
  void build(const Primitive& primitive, const ZFrame& frame, int band, const Kernel& kernel,
             double one);

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
  /// Signed words of the block's inside pixels, lowest bit first.
  std::span<const std::int64_t> words(std::size_t block) const {
    return {words_.data() + first_word_[block], words_.data() + first_word_[block + 1]};
  }

 private:
  void find_blocks(const Primitive& primitive, const ZFrame& frame, int band);
  void add_block_row(const Primitive& primitive, const ZFrame& frame, int by);
  void test_pixels(const Primitive& primitive, const Kernel& kernel);
  void evaluate_words(const Primitive& primitive, const Kernel& kernel, double one);

  std::size_t face_count_ = 0;
  std::vector<Block> blocks_;
  std::vector<std::size_t> row_begin_;
  std::vector<std::uint64_t> faces_, outline_, umbra_, inside_, hits_, inner_, scratch_;
  std::vector<UmbraBits> umbra_bits_;
  std::vector<std::size_t> first_word_;
  std::vector<std::int64_t> words_;
  std::vector<Span> spans_;  // (polygons, 8 rows) of the block row at hand
};

}  // namespace wedgesim::model

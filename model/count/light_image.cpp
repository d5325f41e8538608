#include "model/count/light_image.h"

#include <bit>

#include "model/count/shared_words.h"

namespace wedgesim::model {

LightImage::LightImage(const ZFrame& frame)
    : penumbra_(frame.block_count() * kBlockPixels),
      umbra_(penumbra_.size()),
      contributions_(penumbra_.size()),
      inside_any_(frame.block_count()) {}

void LightImage::add(const Primitive& primitive, const Footprint& footprint, const ZFrame& frame) {
  for (std::size_t i = 0; i < footprint.blocks().size(); ++i) {
    const Block& block = footprint.blocks()[i];
    const std::size_t index = frame.block(block.bx, block.by);
    const std::size_t first = index * kBlockPixels;
    if (footprint.inside(i) != 0) set_shared(inside_any_[index], footprint.inside(i));
    const std::int64_t* word = footprint.words(i).data();
    for_each_bit(footprint.inside(i), [&](int bit) {
      const std::size_t position = first + static_cast<std::size_t>(bit);
      add_shared(penumbra_[position], *word++);
      add_shared(contributions_[position], std::uint32_t{1});
    });
    for_each_bit(footprint.hits(i), [&](int bit) {
      const std::size_t position = first + static_cast<std::size_t>(bit);
      add_shared(umbra_[position], std::int32_t{primitive.polygon->stencil_step});
      add_shared(contributions_[position], std::uint32_t{1});
    });
  }
}

std::uint64_t LightImage::pixels_inside_any() const { return count_bits(inside_any_); }

}  // namespace wedgesim::model

#include "model/count/light_image.h"

#include <algorithm>
#include <mutex>

#include "model/count/bits.h"

namespace wedgesim::model {
namespace {

// Adds the words of a block's set, row by row: the rows without any are many.
void add_words(const std::int64_t* __restrict words, std::uint64_t set,
               std::int64_t* __restrict sums) {
  for (int row = 0; row < kBlock; ++row, words += kBlock, sums += kBlock) {
    if ((set >> (kBlock * row) & 0xff) == 0) continue;
    for (int column = 0; column < kBlock; ++column) sums[column] += words[column];
  }
}

// Has a block's sums brought to the cache while its words are computed.
void fetch_early(const std::int64_t* sums) {
  for (int row = 0; row < kBlock; ++row) __builtin_prefetch(sums + kBlock * row, 1);
}

}  // namespace

void PixelCounters::add_high(std::size_t block, std::uint64_t set) {
  High& high = high_[block];
  for (std::uint64_t& slice : high.slices) {
    const std::uint64_t carry = slice & set;
    slice ^= set;
    set = carry;
    if (set == 0) return;
  }
  high.overflowed |= set;
}

std::uint64_t PixelCounters::set(std::size_t block) const {
  std::uint64_t any = high_[block].overflowed;
  for (std::uint64_t slice : low_[block]) any |= slice;
  for (std::uint64_t slice : high_[block].slices) any |= slice;
  return any;
}

LightImage::LightImage(const ZFrame& frame)
    : blocks_(frame.block_count()),
      penumbra_(blocks_ * kBlockPixels),
      inside_(blocks_),
      added_(blocks_),
      subtracted_(blocks_),
      locks_(std::make_unique<tbb::spin_mutex[]>(kLocks)) {}

void LightImage::add(const Primitive& primitive, const Footprint& footprint, const ZFrame& frame,
                     const Kernel& kernel, double one) {
  PixelCounters& hits =
      primitive.polygon && primitive.polygon->stencil_step > 0 ? added_ : subtracted_;
  constexpr std::size_t kChunk = 16;  // blocks whose words stay in the first-level cache
  std::array<std::int64_t, kChunk * kBlockPixels> words;
  std::unique_lock<tbb::spin_mutex> lock;
  const std::span<const Block> blocks = footprint.blocks();
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (primitive.wedge && i % kChunk == 0) {
      lock = {};
      const std::size_t count = std::min(kChunk, blocks.size() - i);
      for (std::size_t k = i; k < i + count; ++k) {
        if (footprint.inside(k) == 0) continue;
        fetch_early(&penumbra_[frame.block(blocks[k].bx, blocks[k].by) * kBlockPixels]);
      }
      kernel.words(primitive.terms, one, blocks.subspan(i, count), footprint.inside_sets() + i,
                   footprint.negated_sets() + i, words.data());
    }
    const std::uint64_t inside = footprint.inside(i);
    if ((inside | footprint.hits(i)) == 0) continue;
    const std::size_t block = frame.block(blocks[i].bx, blocks[i].by);
    tbb::spin_mutex& mutex = locks_[block / kBlocksALock % kLocks];
    if (lock.mutex() != &mutex) {
      lock = {};
      lock = std::unique_lock(mutex);
    }
    if (footprint.hits(i) != 0) hits.add(block, footprint.hits(i));
    if (inside == 0) continue;
    inside_.add(block, inside);
    add_words(&words[i % kChunk * kBlockPixels], inside, &penumbra_[block * kBlockPixels]);
  }
}

void LightImage::sums(std::size_t block, std::int64_t* penumbra, std::int32_t* umbra,
                      std::uint32_t* contributions) const {
  std::copy_n(&penumbra_[block * kBlockPixels], kBlockPixels, penumbra);
  std::fill_n(umbra, kBlockPixels, 0);
  std::fill_n(contributions, kBlockPixels, 0);
  inside_.for_each_term(block, [&](int bit, std::uint32_t count) { contributions[bit] += count; });
  added_.for_each_term(block, [&](int bit, std::uint32_t count) {
    contributions[bit] += count;
    umbra[bit] += static_cast<std::int32_t>(count);
  });
  subtracted_.for_each_term(block, [&](int bit, std::uint32_t count) {
    contributions[bit] += count;
    umbra[bit] -= static_cast<std::int32_t>(count);
  });
}

std::uint64_t LightImage::pixels_inside_any() const {
  std::uint64_t pixels = 0;
  for (std::size_t block = 0; block < blocks_; ++block) pixels += bit_count(inside_.set(block));
  return pixels;
}

}  // namespace wedgesim::model

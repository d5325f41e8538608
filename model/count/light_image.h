#pragma once

#include <tbb/spin_mutex.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/count/bits.h"
#include "model/count/footprint.h"

namespace wedgesim::model {

/// What a wrong culling or acceptance of one configuration does to one pixel: nothing is assumed
/// of the tile tests, so a contribution that is lost is lost.
struct Correction {
  std::size_t position = 0;  // in block order
  std::int64_t penumbra = 0;
  std::int32_t umbra = 0;
};

/// A counter a pixel, stored bit by bit: slice k of a block holds bit k of its 64 counters, so one
/// addition counts a whole set of pixels.
class PixelCounters {
 public:
  explicit PixelCounters(std::size_t blocks) : slices_(blocks) {}

  /// Adds 1 at every pixel of a set.
  void add(std::size_t block, std::uint64_t set);
  /// Calls f(bit, 2^k) for every bit k that is set in one of a block's counters.
  template <typename F>
  void for_each_term(std::size_t block, F&& f) const {
    for (std::size_t k = 0; k < kSlices; ++k) {
      for_each_bit(slices_[block][k], [&](int bit) { f(bit, std::uint32_t{1} << k); });
    }
  }
  /// Pixels of a block that were counted at least once.
  std::uint64_t counted(std::size_t block) const;

 private:
  static constexpr std::size_t kSlices = 20;  // a million contributions a pixel
  std::vector<std::array<std::uint64_t, kSlices>> slices_;
};

/// Sums of contributions, in block order, filled by many threads; integers, so that their order
/// does not matter.
class LightImage {
 public:
  explicit LightImage(const ZFrame& frame);

  /// Adds the contributions of all inside pixels and all hits of a footprint.
  /// \param one  word_one of the format
  void add(const Primitive& primitive, const Footprint& footprint, const ZFrame& frame,
           const Kernel& kernel, double one);

  /// The sums of a block's 64 pixels.
  /// \param penumbra       of coverages and intensities, in words
  /// \param umbra          of hits, in full lights: a wide stencil
  /// \param contributions  how many there were, umbra and penumbra
  void sums(std::size_t block, std::int64_t* penumbra, std::int32_t* umbra,
            std::uint32_t* contributions) const;
  /// Distinct pixels inside at least one wedge.
  std::uint64_t pixels_inside_any() const;

 private:
  static constexpr std::size_t kLocks = 4096;
  static constexpr std::size_t kBlocksALock = 16;

  std::size_t blocks_;
  std::vector<std::int64_t> penumbra_;
  PixelCounters inside_, added_, subtracted_;
  std::unique_ptr<tbb::spin_mutex[]> locks_;
};

}  // namespace wedgesim::model

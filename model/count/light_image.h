#pragma once

#include <tbb/spin_mutex.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "model/count/bits.h"
#include "model/count/footprint.h"

namespace wedgesim::model {

/// What a wrong culling, acceptance or skipped inside test of one configuration does to one pixel:
/// nothing is assumed of the tile tests, so a contribution that is lost is lost.
struct Correction {
  std::size_t position = 0;  // in block order
  std::int64_t penumbra = 0;
  std::int32_t umbra = 0;
};

/// The most hits of one sign, and the most coverages, that a pixel takes: their sum fits its word.
inline constexpr std::uint32_t kMostContributions = (1U << 20) - 1;

/// A counter a pixel, stored bit by bit: slice k of a block holds bit k of its 64 counters, so one
/// addition counts a whole set of pixels. The low slices are apart: most additions end there, and
/// less memory moves.
class PixelCounters {
 public:
  explicit PixelCounters(std::size_t blocks) : low_(blocks), high_(blocks) {}

  /// Adds 1 at every pixel of a set.
  void add(std::size_t block, std::uint64_t set) {
    for (std::uint64_t& slice : low_[block]) {
      const std::uint64_t carry = slice & set;
      slice ^= set;
      set = carry;
    }
    if (set != 0) add_high(block, set);
  }
  /// Calls f(bit, 2^k) for every bit k that is set in one of a block's counters.
  template <typename F>
  void for_each_term(std::size_t block, F&& f) const {
    const auto each = [&](std::uint64_t slice, std::size_t k) {
      for_each_bit(slice, [&](int bit) { f(bit, std::uint32_t{1} << k); });
    };
    for (std::size_t k = 0; k < kLow; ++k) each(low_[block][k], k);
    for (std::size_t k = 0; k < kHigh; ++k) each(high_[block].slices[k], kLow + k);
  }
  /// Pixels of a block that were counted at least once.
  std::uint64_t set(std::size_t block) const;
  /// Pixels of a block that were counted more than kMostContributions times.
  std::uint64_t overflowed(std::size_t block) const { return high_[block].overflowed; }

 private:
  static constexpr std::size_t kLow = 4;
  static constexpr std::size_t kHigh = 16;
  static_assert(kMostContributions == (1U << (kLow + kHigh)) - 1);
  struct High {
    std::array<std::uint64_t, kHigh> slices{};
    std::uint64_t overflowed = 0;
  };
  void add_high(std::size_t block, std::uint64_t set);

  std::vector<std::array<std::uint64_t, kLow>> low_;
  std::vector<High> high_;
};

/// Sums of contributions, in block order, filled by many threads; integers, so that their order
/// does not matter.
class LightImage {
 public:
  explicit LightImage(const ZFrame& frame);

  /// Adds the contributions of all inside pixels and all hits of a footprint.
  /// \param one  Datapath::one()
  void add(const Primitive& primitive, const Footprint& footprint, const ZFrame& frame,
           const Kernel& kernel, double one);

  /// The sums of a block's 64 pixels.
  /// \param penumbra       of coverages and intensities, in words
  /// \param umbra          of hits, in full lights: a wide stencil
  /// \param contributions  how many there were, umbra and penumbra
  void sums(std::size_t block, std::int64_t* penumbra, std::int32_t* umbra,
            std::uint32_t* contributions) const;
  /// Pixels of a block that took more contributions than their sum can hold.
  std::uint64_t overflowed(std::size_t block) const {
    return inside_.overflowed(block) | added_.overflowed(block) | subtracted_.overflowed(block);
  }
  /// Pixels of a block that are inside at least one wedge.
  std::uint64_t inside_any(std::size_t block) const { return inside_.set(block); }
  /// How many they are in the frame.
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

#pragma once

#include <cmath>
#include <cstdint>

namespace wedgesim::model::datapath {

/// A word of the LI buffer: signed two's complement fixed point, 1.0 is fully lit.
struct LiWord {
  int integer_bits = 5;  // the sign among them
  int fraction_bits = 11;

  int bits() const { return integer_bits + fraction_bits; }
  /// Fully lit, as a word.
  std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  /// A contribution as a word, rounded to nearest, ties to even.
  /// \param value  [-1, 1]
  std::int64_t of(double value) const {
    return static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, fraction_bits)));
  }
  /// What the buffer holds after a sum: the sum modulo 2^bits. Order does not matter.
  std::int64_t wrap(std::int64_t sum) const {
    const int unused = 64 - bits();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) << unused) >> unused;
  }
  /// Does the buffer hold the true sum? If not, the pixel overflows.
  bool holds(std::int64_t sum) const { return wrap(sum) == sum; }
};

}  // namespace wedgesim::model::datapath

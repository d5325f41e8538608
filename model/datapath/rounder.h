#pragma once

#include <bit>
#include <cstdint>

namespace wedgesim::model::datapath {

/// One operator's rounding: to a number of significant bits, to nearest, ties to even.
///
/// The datapath's reals are a sign, an integer significand and a power of two. A double carries
/// them: the exact result of +, -, *, / or a root of operands of p bits, rounded to 53 bits and
/// then to p, is the exact result rounded to p as long as 53 >= 2p + 2. So `round(a * b)` is bit
/// for bit what a multiplier with p-bit significands gives. Write one call for every operator.
/// Source: Figueroa, When is double rounding innocuous? (1995).
class Rounder {
 public:
  static constexpr int kMinBits = 8;
  static constexpr int kMaxBits = 25;

  /// \param bits  kMinBits to kMaxBits
  explicit constexpr Rounder(int bits)
      : drop_(53 - bits), below_half_((std::uint64_t{1} << (drop_ - 1)) - 1) {}

  /// \param x  finite, zero or normal; the result is finite if |x| < 2^1023
  double operator()(double x) const {
    const auto word = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t rounded = word + below_half_ + (word >> drop_ & 1);
    return std::bit_cast<double>(rounded >> drop_ << drop_);
  }

  /// integer * 2^exponent, rounded; |integer| < 2^63.
  double operator()(std::int64_t integer, int exponent) const {
    // The low bits of what a double cannot hold matter only in whether they are all zero.
    const auto kept = static_cast<double>(integer >> kSticky | ((integer & kLow) != 0 ? 1 : 0));
    const bool wide = integer > kExact || integer < -kExact;
    const double value = wide ? kept : static_cast<double>(integer);
    return (*this)(value * power(exponent + (wide ? kSticky : 0)));
  }

 private:
  static constexpr int kSticky = 11;
  static constexpr std::int64_t kLow = (1 << kSticky) - 1;
  static constexpr std::int64_t kExact = std::int64_t{1} << 53;

  // 2^exponent, normal.
  static double power(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
  }

  int drop_;
  std::uint64_t below_half_;
};

}  // namespace wedgesim::model::datapath

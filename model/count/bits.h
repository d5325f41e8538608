#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <span>

namespace wedgesim::model {

/// Calls f(bit) for every set bit, lowest first.
template <typename F>
void for_each_bit(std::uint64_t bits, F&& f) {
  for (; bits != 0; bits &= bits - 1) f(std::countr_zero(bits));
}

/// The number of set bits. By sums of neighbouring fields: without the processor's own
/// instruction, which the oldest x86-64 lacks, std::popcount is a call.
constexpr std::uint64_t bit_count(std::uint64_t bits) {
  bits -= bits >> 1 & 0x5555555555555555U;
  bits = (bits & 0x3333333333333333U) + (bits >> 2 & 0x3333333333333333U);
  bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fU;
  return bits * 0x0101010101010101U >> 56;
}
inline std::uint64_t bit_count(std::span<const std::uint64_t> sets) {
  std::uint64_t sum = 0;
  for (std::uint64_t set : sets) sum += bit_count(set);
  return sum;
}

/// Adds to a value that other threads add to.
inline void add_shared(std::uint32_t& value, std::uint32_t amount) {
  std::atomic_ref<std::uint32_t>(value).fetch_add(amount, std::memory_order_relaxed);
}

/// Sets bits of a word that other threads set bits of.
inline void set_shared(std::uint64_t& word, std::uint64_t bits) {
  std::atomic_ref<std::uint64_t> shared(word);
  if ((shared.load(std::memory_order_relaxed) & bits) != bits) {
    shared.fetch_or(bits, std::memory_order_relaxed);
  }
}

}  // namespace wedgesim::model

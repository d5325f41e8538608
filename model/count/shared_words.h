#pragma once

#include <atomic>
#include <bit>
#include <cstdint>
#include <span>

namespace wedgesim::model {

/// Adds to a value that other threads add to: integers, so that the order does not matter.
template <typename T>
void add_shared(T& value, T amount) {
  std::atomic_ref<T>(value).fetch_add(amount, std::memory_order_relaxed);
}

/// Sets bits of a word that other threads set bits of.
inline void set_shared(std::uint64_t& word, std::uint64_t bits) {
  std::atomic_ref<std::uint64_t> shared(word);
  if ((shared.load(std::memory_order_relaxed) & bits) != bits) {
    shared.fetch_or(bits, std::memory_order_relaxed);
  }
}

inline std::uint64_t count_bits(std::span<const std::uint64_t> words) {
  std::uint64_t count = 0;
  for (std::uint64_t word : words) count += static_cast<std::uint64_t>(std::popcount(word));
  return count;
}

}  // namespace wedgesim::model

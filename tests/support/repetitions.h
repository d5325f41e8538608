#pragma once

namespace wedgesim {

/// How many of `n` random cases to run: all, or under the sanitizers, which are ten times slower
/// and look for other mistakes, the first fifth (at least two).
constexpr unsigned repetitions(unsigned n) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return n / 5 > 2 ? n / 5 : 2;
#else
  return n;
#endif
}

}  // namespace wedgesim

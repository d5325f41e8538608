#pragma once

#include <sstream>
#include <string>

#include "base/error.h"

namespace wedgesim::detail {

[[noreturn]] inline void check_failed(const char* file, int line, const std::string& what) {
  std::ostringstream text;
  text << file << ':' << line << ": check failed: " << what;
  throw CheckError(text.str());
}

template <typename A, typename B>
[[noreturn]] void check_op_failed(const char* file, int line, const char* expression, const A& a,
                                  const B& b) {
  std::ostringstream text;
  text << expression << " (" << +a << " against " << +b << ')';
  check_failed(file, line, text.str());
}

}  // namespace wedgesim::detail

/// Checks of invariants, always on; a failure throws CheckError and prints both values.
#define WEDGESIM_CHECK(condition)                                       \
  do {                                                                  \
    if (!(condition)) {                                                 \
      ::wedgesim::detail::check_failed(__FILE__, __LINE__, #condition); \
    }                                                                   \
  } while (false)
#define WEDGESIM_CHECK_OP(op, a, b)                                                        \
  do {                                                                                     \
    const auto& check_a_ = (a);                                                            \
    const auto& check_b_ = (b);                                                            \
    if (!(check_a_ op check_b_)) {                                                         \
      ::wedgesim::detail::check_op_failed(__FILE__, __LINE__, #a " " #op " " #b, check_a_, \
                                          check_b_);                                       \
    }                                                                                      \
  } while (false)
#define CHECK_EQ(a, b) WEDGESIM_CHECK_OP(==, a, b)
#define CHECK_NE(a, b) WEDGESIM_CHECK_OP(!=, a, b)
#define CHECK_LT(a, b) WEDGESIM_CHECK_OP(<, a, b)
#define CHECK_LE(a, b) WEDGESIM_CHECK_OP(<=, a, b)
#define CHECK_GT(a, b) WEDGESIM_CHECK_OP(>, a, b)
#define CHECK_GE(a, b) WEDGESIM_CHECK_OP(>=, a, b)

#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace wedgesim::cli {

/// Values of options. Each throws InputError naming the option, the text and what is expected.

/// A whole number from `low` to `high`.
int parse_integer(std::string_view option, std::string_view text, int low, int high);

/// A finite number above 0.
double parse_positive(std::string_view option, std::string_view text);

/// "640x427": two whole numbers from 1 to 16384, pixels.
std::pair<int, int> parse_size(std::string_view option, std::string_view text);

/// "12,34": two whole numbers, not negative.
std::pair<int, int> parse_point(std::string_view option, std::string_view text);

/// "a,b,c": the parts between commas, none empty.
std::vector<std::string> parse_list(std::string_view option, std::string_view text);

template <typename Value>
using Choices = std::initializer_list<std::pair<std::string_view, Value>>;

/// One of the named values.
template <typename Value>
Value parse_choice(std::string_view option, std::string_view text, Choices<Value> choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    names += names.empty() ? "" : ", ";
    names += name;
  }
  throw InputError(option, fmt::format("unknown value '{}'", text), "one of " + names);
}

}  // namespace wedgesim::cli

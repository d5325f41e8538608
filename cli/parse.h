#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"

namespace wedgesim::cli {

/// Values of options. Each throws InputError naming the option, the text and what is expected.

/// A whole number from `low` to `high`.
int parse_integer(std::string_view option, std::string_view text, int low, int high);

/// A number from `low` to `high`.
double parse_number(std::string_view option, std::string_view text, double low, double high);

/// "640x427": two whole numbers from 1 to 16384, pixels.
std::pair<int, int> parse_size(std::string_view option, std::string_view text);

/// "12,34": two whole numbers, not negative.
std::pair<int, int> parse_point(std::string_view option, std::string_view text);

/// "100,2000": two whole numbers, the first below the second: the cycles from 100 to before 2000.
std::pair<std::uint64_t, std::uint64_t> parse_window(std::string_view option,
                                                     std::string_view text);

/// "a,b,c": the parts between commas, none empty.
std::vector<std::string> parse_list(std::string_view option, std::string_view text);

/// The same, each part parsed: a set, in which no value may stand twice.
template <typename ParseOne>
auto parse_set(std::string_view option, std::string_view text, ParseOne parse_one) {
  std::vector<decltype(parse_one(std::string_view()))> values;
  for (const std::string& part : parse_list(option, text)) {
    const auto value = parse_one(part);
    if (std::ranges::find(values, value) != values.end()) {
      throw InputError(option, fmt::format("'{}' is given twice", part), "each value once");
    }
    values.push_back(value);
  }
  return values;
}

template <typename Value>
using Choices = std::initializer_list<std::pair<std::string_view, Value>>;

/// One of the named values.
template <typename Value>
Value parse_choice(std::string_view option, std::string_view text,
                   std::span<const std::pair<std::string_view, Value>> choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == text) return value;
    names += names.empty() ? "" : ", ";
    names += name;
  }
  throw InputError(option, fmt::format("unknown value '{}'", text), "one of " + names);
}
template <typename Value>
Value parse_choice(std::string_view option, std::string_view text, Choices<Value> choices) {
  return parse_choice<Value>(option, text, std::span(choices.begin(), choices.size()));
}

}  // namespace wedgesim::cli

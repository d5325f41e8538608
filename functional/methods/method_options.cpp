#include "functional/methods/method_options.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace wedgesim::functional {
namespace {

template <typename Number>
bool parse(const std::string& text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

}  // namespace

const std::string* MethodOptions::find(std::string_view key) const {
  asked_[std::string(key)] = true;
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

void MethodOptions::refuse(std::string_view key, const std::string& expected) const {
  throw OptionError(place_, fmt::format("{} = '{}'", key, values_.find(key)->second), expected);
}

int MethodOptions::integer(std::string_view key, int fallback, int low, int high) const {
  const std::string* text = find(key);
  if (text == nullptr) return fallback;
  int value = 0;
  if (!parse(*text, value) || value < low || value > high) {
    refuse(key, fmt::format("a whole number from {} to {}", low, high));
  }
  return value;
}

double MethodOptions::number(std::string_view key, double fallback, double low, double high) const {
  const std::string* text = find(key);
  if (text == nullptr) return fallback;
  double value = 0.0;
  if (!parse(*text, value) || !(value >= low && value <= high)) {
    refuse(key, fmt::format("a number from {} to {}", low, high));
  }
  return value;
}

void MethodOptions::refuse_without_effect(std::initializer_list<std::string_view> keys,
                                          const std::string& expected) const {
  for (const std::string_view key : keys) {
    const std::string* text = find(key);
    if (text == nullptr) continue;
    throw OptionError(place_, fmt::format("{} = '{}' has no effect", key, *text), expected);
  }
}

void MethodOptions::check_all_known() const {
  for (const auto& [key, value] : values_) {
    if (asked_.contains(key)) continue;
    std::string known;
    for (const auto& [name, asked] : asked_) known += (known.empty() ? "" : ", ") + name;
    throw OptionError(place_, fmt::format("unknown option '{}'", key),
                      known.empty() ? "no options" : "one of " + known);
  }
}

}  // namespace wedgesim::functional

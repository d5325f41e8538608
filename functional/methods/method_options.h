#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"

namespace wedgesim::functional {

/// An option of a method is wrong, whatever the scene.
class OptionError : public InputError {
 public:
  using InputError::InputError;
};

/// The options of a shadow method: KEY=VALUE pairs, each read once by the method that knows it.
class MethodOptions {
 public:
  MethodOptions() = default;
  /// \param place  what names the method, for errors: "--method ssv:texture=32"
  MethodOptions(std::string place, std::map<std::string, std::string, std::less<>> values)
      : place_(std::move(place)), values_(std::move(values)) {}

  // Each throws OptionError if the value is not what is expected.

  /// A whole number from `low` to `high`; `fallback` if it was not given.
  int integer(std::string_view key, int fallback, int low, int high) const;
  /// A number from `low` to `high`.
  double number(std::string_view key, double fallback, double low, double high) const;
  /// One of the named values; the first one if it was not given.
  template <typename Value>
  Value choice(std::string_view key,
               std::initializer_list<std::pair<std::string_view, Value>> choices) const;

  /// For options that the others leave without effect: says with which others they have one.
  /// \throws OptionError if one of the keys was given
  void refuse_without_effect(std::initializer_list<std::string_view> keys,
                             const std::string& expected) const;

  /// \throws OptionError if a key was given that no call above has asked for
  void check_all_known() const;

 private:
  const std::string* find(std::string_view key) const;
  [[noreturn]] void refuse(std::string_view key, const std::string& expected) const;

  std::string place_;
  std::map<std::string, std::string, std::less<>> values_;
  mutable std::map<std::string, bool, std::less<>> asked_;
};

template <typename Value>
Value MethodOptions::choice(
    std::string_view key, std::initializer_list<std::pair<std::string_view, Value>> choices) const {
  const std::string* text = find(key);
  if (text == nullptr) return choices.begin()->second;
  std::string names;
  for (const auto& [name, value] : choices) {
    if (name == *text) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  refuse(key, "one of " + names);
}

}  // namespace wedgesim::functional

#pragma once

#include <toml++/toml.h>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wedgesim {

/// A closed interval that a number must lie in.
struct Range {
  double low = -kLargest;
  double high = kLargest;

  static constexpr double kLargest = 1e12;
  /// Above zero: the smallest size that still has an inverse worth the name.
  static constexpr Range size() { return {1e-12, kLargest}; }
};

/// One table of a TOML file, read key by key. Knows what was asked for, so that
/// `reject_unknown` can name the keys that exist. Every problem is an InputError at FILE:LINE.
class TomlTable {
 public:
  /// \param table  outlives the reader
  /// \param file   the name users know the file by
  TomlTable(const toml::table& table, std::string file);

  bool has(std::string_view key) const;

  /// The value of a key, or `fallback` where the key is missing.
  /// \throws InputError if the key is missing without a fallback, of another type, not finite or
  ///         out of range
  double number(std::string_view key, std::optional<double> fallback = {}, Range range = {}) const;
  int integer(std::string_view key, std::optional<int> fallback = {}, int low = 0,
              int high = std::numeric_limits<int>::max()) const;
  bool boolean(std::string_view key, std::optional<bool> fallback = {}) const;
  std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
  glm::dvec2 vec2(std::string_view key, std::optional<glm::dvec2> fallback = {},
                  Range range = {}) const;
  glm::dvec3 vec3(std::string_view key, std::optional<glm::dvec3> fallback = {},
                  Range range = {}) const;
  /// Four rows of four numbers.
  glm::dmat4 matrix4(std::string_view key) const;
  std::vector<std::string> text_list(std::string_view key) const;
  std::vector<glm::dvec2> vec2_list(std::string_view key) const;
  std::vector<glm::dvec3> vec3_list(std::string_view key) const;

  /// The table of a key.
  TomlTable table(std::string_view key) const;
  /// The tables of a key written as [[key]]; none if it is missing.
  std::vector<TomlTable> tables(std::string_view key) const;
  /// The table of a key written as [key], or the tables of one written as [[key]].
  std::vector<TomlTable> one_or_more_tables(std::string_view key) const;

  /// \throws InputError naming the first key that nobody asked for and the keys that exist
  void reject_unknown() const;

  /// Where a key stands, FILE:LINE; the table itself if it has no such key.
  std::string place(std::string_view key = {}) const;
  [[noreturn]] void fail(std::string_view key, std::string_view problem,
                         std::string_view expected) const;

 private:
  const toml::node* find(std::string_view key) const;
  const toml::node& need(std::string_view key, std::string_view expected) const;
  std::vector<double> components(const toml::node& node, std::string_view key, std::size_t count,
                                 Range range) const;
  double checked_number(const toml::node& node, std::string_view key, std::string_view expected,
                        Range range) const;

  const toml::table* table_;
  std::string file_;
  mutable std::vector<std::string> asked_;  // keys in the order they were first asked for
};

/// Reads TOML text.
/// \throws InputError at FILE:LINE where the text is not TOML
toml::table parse_toml(std::string_view text, const std::string& file);

}  // namespace wedgesim

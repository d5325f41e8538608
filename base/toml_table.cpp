#include "base/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace wedgesim {
namespace {

std::string place_of(const std::string& file, const toml::source_region& region) {
  return fmt::format("{}:{}", file, region.begin.line);
}

std::string describe(Range range) {
  return range.low == -Range::kLargest && range.high == Range::kLargest
             ? "a finite number"
             : fmt::format("a number from {:g} to {:g}", range.low, range.high);
}

}  // namespace

toml::table parse_toml(std::string_view text, const std::string& file) {
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(file, error.source()), error.description());
  }
}

TomlTable::TomlTable(const toml::table& table, std::string file)
    : table_(&table), file_(std::move(file)) {}

std::string TomlTable::place(std::string_view key) const {
  const toml::node* node = key.empty() ? nullptr : table_->get(key);
  return place_of(file_, node != nullptr ? node->source() : table_->source());
}

void TomlTable::fail(std::string_view key, std::string_view problem,
                     std::string_view expected) const {
  throw InputError(place(key), fmt::format("'{}' {}", key, problem), expected);
}

const toml::node* TomlTable::find(std::string_view key) const {
  if (std::find(asked_.begin(), asked_.end(), key) == asked_.end()) {
    asked_.emplace_back(key);
  }
  return table_->get(key);
}

const toml::node& TomlTable::need(std::string_view key, std::string_view expected) const {
  const toml::node* node = find(key);
  if (node == nullptr) {
    fail(key, "is missing", expected);
  }
  return *node;
}

bool TomlTable::has(std::string_view key) const { return find(key) != nullptr; }

double TomlTable::checked_number(const toml::node& node, std::string_view key,
                                 std::string_view expected, Range range) const {
  const std::optional<double> value = node.value<double>();
  if (!node.is_number() || !value) {
    throw InputError(place_of(file_, node.source()), fmt::format("'{}' is not a number", key),
                     expected);
  }
  if (!(*value >= range.low && *value <= range.high)) {
    throw InputError(place_of(file_, node.source()), fmt::format("'{}' is {:g}", key, *value),
                     describe(range));
  }
  return *value;
}

double TomlTable::number(std::string_view key, std::optional<double> fallback, Range range) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  return checked_number(need(key, "a number"), key, "a number", range);
}

int TomlTable::integer(std::string_view key, std::optional<int> fallback, int low, int high) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  const std::optional<std::int64_t> value = need(key, "an integer").value_exact<std::int64_t>();
  if (!value) {
    fail(key, "is not an integer", "an integer");
  }
  if (*value < low || *value > high) {
    fail(key, fmt::format("is {}", *value), fmt::format("an integer from {} to {}", low, high));
  }
  return static_cast<int>(*value);
}

bool TomlTable::boolean(std::string_view key, std::optional<bool> fallback) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  const std::optional<bool> value = need(key, "true or false").value_exact<bool>();
  if (!value) {
    fail(key, "is not a boolean", "true or false");
  }
  return *value;
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  const std::optional<std::string> value = need(key, "a string").value_exact<std::string>();
  if (!value) {
    fail(key, "is not a string", "a string");
  }
  return *value;
}

std::vector<double> TomlTable::components(const toml::node& node, std::string_view key,
                                          std::size_t count, Range range) const {
  const std::string expected = fmt::format("an array of {} numbers", count);
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != count) {
    throw InputError(place_of(file_, node.source()), fmt::format("'{}' is not {}", key, expected),
                     expected);
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    values.push_back(checked_number(element, key, expected, range));
  }
  return values;
}

glm::dvec2 TomlTable::vec2(std::string_view key, std::optional<glm::dvec2> fallback,
                           Range range) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  const std::vector<double> v = components(need(key, "an array of 2 numbers"), key, 2, range);
  return {v[0], v[1]};
}

glm::dvec3 TomlTable::vec3(std::string_view key, std::optional<glm::dvec3> fallback,
                           Range range) const {
  if (fallback && !has(key)) {
    return *fallback;
  }
  const std::vector<double> v = components(need(key, "an array of 3 numbers"), key, 3, range);
  return {v[0], v[1], v[2]};
}

glm::dmat4 TomlTable::matrix4(std::string_view key) const {
  const toml::array* rows = need(key, "4 rows of 4 numbers").as_array();
  if (rows == nullptr || rows->size() != 4) fail(key, "is no matrix", "4 rows of 4 numbers");
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    const auto i = static_cast<std::size_t>(row);
    const std::vector<double> values = components((*rows)[i], key, 4, {});
    for (int column = 0; column < 4; ++column) {
      matrix[column][row] = values[static_cast<std::size_t>(column)];
    }
  }
  return matrix;
}

std::vector<std::string> TomlTable::text_list(std::string_view key) const {
  const toml::array* array = need(key, "an array of strings").as_array();
  if (array == nullptr || array->empty() || !array->is_homogeneous(toml::node_type::string)) {
    fail(key, "is not an array of strings", "an array of strings, at least one");
  }
  std::vector<std::string> texts;
  for (const toml::node& element : *array) texts.push_back(element.as_string()->get());
  return texts;
}

std::vector<glm::dvec2> TomlTable::vec2_list(std::string_view key) const {
  const toml::array* array = need(key, "an array of points").as_array();
  if (array == nullptr) {
    fail(key, "is not an array", "an array of points [x, y]");
  }
  std::vector<glm::dvec2> points;
  for (const toml::node& element : *array) {
    const std::vector<double> v = components(element, key, 2, {});
    points.emplace_back(v[0], v[1]);
  }
  return points;
}

std::vector<glm::dvec3> TomlTable::vec3_list(std::string_view key) const {
  const toml::array* array = need(key, "an array of points").as_array();
  if (array == nullptr) {
    fail(key, "is not an array", "an array of points [x, y, z]");
  }
  std::vector<glm::dvec3> points;
  for (const toml::node& element : *array) {
    const std::vector<double> v = components(element, key, 3, {});
    points.emplace_back(v[0], v[1], v[2]);
  }
  return points;
}

TomlTable TomlTable::table(std::string_view key) const {
  const toml::table* found = need(key, fmt::format("a table [{}]", key)).as_table();
  if (found == nullptr) {
    fail(key, "is not a table", fmt::format("a table [{}]", key));
  }
  return {*found, file_};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const toml::node* node = find(key);
  std::vector<TomlTable> found;
  if (node == nullptr) {
    return found;
  }
  const toml::array* array = node->as_array();
  if (array == nullptr || !array->is_homogeneous(toml::node_type::table)) {
    fail(key, "is not an array of tables", fmt::format("tables [[{}]]", key));
  }
  for (const toml::node& element : *array) {
    found.emplace_back(*element.as_table(), file_);
  }
  return found;
}

std::vector<TomlTable> TomlTable::one_or_more_tables(std::string_view key) const {
  if (need(key, fmt::format("a table [{}]", key)).is_array()) return tables(key);
  return {table(key)};
}

void TomlTable::reject_unknown() const {
  const toml::key* first = nullptr;  // by line: a table's own order is alphabetical
  for (const auto& [key, node] : *table_) {
    const bool known = std::find(asked_.begin(), asked_.end(), key.str()) != asked_.end();
    if (!known && (first == nullptr || key.source().begin < first->source().begin)) {
      first = &key;
    }
  }
  if (first != nullptr) {
    throw InputError(place_of(file_, first->source()),
                     fmt::format("unknown key '{}'", first->str()),
                     fmt::format("one of {}", fmt::join(asked_, ", ")));
  }
}

}  // namespace wedgesim

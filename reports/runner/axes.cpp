#include "reports/runner/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>

#include "base/error.h"
#include "base/toml_table.h"

namespace wedgesim::reports {
namespace {

std::string place_of(const std::string& file, const toml::node& node) {
  return fmt::format("{}:{}", file, node.source().begin.line);
}

Value read_value(const std::string& key, const toml::node& node, const std::string& file) {
  if (const auto number = node.value_exact<std::int64_t>()) return *number;
  if (const auto number = node.value_exact<double>()) return *number;
  if (const auto word = node.value_exact<std::string>()) return *word;
  throw InputError(place_of(file, node), fmt::format("'{}' is neither a number nor a word", key),
                   "a value, a list of values, or a range {low = ..., high = ...}");
}

std::vector<Value> range_values(const std::string& key, const toml::table& node,
                                const std::string& file) {
  const TomlTable table(node, file);
  constexpr int kMost = 1 << 30;
  const int low = table.integer("low", {}, 0, kMost);
  const int high = table.integer("high", {}, low, kMost);
  const bool doubles = table.boolean("log2", false);
  const int step = doubles ? 0 : table.integer("step", 1, 1, kMost);
  table.reject_unknown();
  if (doubles && low == 0) table.fail("low", "is 0", "at least 1 with log2");
  std::vector<Value> values;
  for (std::int64_t value = low; value <= high; value = doubles ? 2 * value : value + step) {
    values.emplace_back(value);
    if (values.size() > kMostPoints) {
      throw InputError(table.place(), fmt::format("'{}' has too many values", key),
                       fmt::format("at most {}", kMostPoints));
    }
  }
  return values;
}

void flatten(const toml::table& table, const std::string& prefix, const std::string& file,
             const std::vector<std::string>& reserved,
             std::vector<std::pair<toml::source_position, Axis>>& found) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + std::string(key.str());
    if (prefix.empty() && std::ranges::find(reserved, name) != reserved.end()) continue;
    const toml::table* inner = node.as_table();
    if (inner != nullptr && !inner->contains("low")) {
      flatten(*inner, name + '.', file, reserved, found);
    } else {
      found.emplace_back(key.source().begin, read_axis(name, node, file));
    }
  }
}

// The i-th of all combinations, the last axis changing fastest.
Settings combination(const std::vector<Axis>& axes, std::size_t i) {
  Settings settings(axes.size());
  for (std::size_t k = axes.size(); k-- > 0;) {
    const Axis& axis = axes[k];
    settings[k] = {axis.key, axis.values[i % axis.values.size()], axis.line};
    i /= axis.values.size();
  }
  return settings;
}

// Combinations, or kMostPoints + 1 if there are more; a value twice is a slip.
std::size_t combinations(const std::vector<Axis>& axes, const std::string& file) {
  std::size_t product = 1;
  for (const Axis& axis : axes) {
    std::vector<Value> sorted = axis.values;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) continue;
    throw InputError(fmt::format("{}:{}", file, axis.line),
                     fmt::format("'{}' names a value twice", axis.key), "each value once");
  }
  for (const Axis& axis : axes) product = std::min(product * axis.values.size(), kMostPoints + 1);
  return product;
}

}  // namespace

Axis read_axis(const std::string& key, const toml::node& node, const std::string& file) {
  Axis axis{key, {}, static_cast<int>(node.source().begin.line)};
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& element : *list) axis.values.push_back(read_value(key, element, file));
  } else if (const toml::table* range = node.as_table()) {
    axis.values = range_values(key, *range, file);
  } else {
    axis.values.push_back(read_value(key, node, file));
  }
  if (axis.values.empty()) {
    throw InputError(place_of(file, node), fmt::format("'{}' is an empty list", key), "values");
  }
  return axis;
}

std::vector<Axis> read_axes(const toml::table& table, const std::string& file,
                            const std::vector<std::string>& reserved) {
  std::vector<std::pair<toml::source_position, Axis>> found;
  flatten(table, "", file, reserved, found);
  std::ranges::stable_sort(
      found, {}, [](const auto& entry) { return std::pair(entry.first.line, entry.first.column); });
  std::vector<Axis> axes;
  for (auto& entry : found) axes.push_back(std::move(entry.second));
  return axes;
}

std::vector<Settings> grid_points(const std::vector<Axis>& axes, const std::string& file,
                                  int line) {
  const std::size_t count = combinations(axes, file);
  if (count > kMostPoints) {
    throw InputError(fmt::format("{}:{}", file, line), "has too many points",
                     fmt::format("at most {}", kMostPoints));
  }
  std::vector<Settings> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(combination(axes, i));
  return points;
}

std::vector<Settings> list_points(const std::vector<Axis>& axes, const std::string& file) {
  std::size_t count = 1;
  const Axis* first = nullptr;
  for (const Axis& axis : axes) {
    if (axis.values.size() == 1) continue;
    if (first != nullptr && axis.values.size() != count) {
      throw InputError(fmt::format("{}:{}", file, axis.line),
                       fmt::format("'{}' has {} values, '{}' {}", axis.key, axis.values.size(),
                                   first->key, count),
                       "as many, or one");
    }
    count = axis.values.size();
    if (first == nullptr) first = &axis;
  }
  std::vector<Settings> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Axis& axis : axes) {
      points[i].push_back({axis.key, axis.values[axis.values.size() == 1 ? 0 : i], axis.line});
    }
  }
  return points;
}

std::vector<Settings> random_points(const std::vector<Axis>& axes, std::size_t count,
                                    std::uint64_t seed, const std::string& file, int line) {
  const std::size_t all = combinations(axes, file);
  if (count > all || count > kMostPoints) {
    throw InputError(fmt::format("{}:{}", file, line),
                     fmt::format("{} different points are asked for", count),
                     fmt::format("at most {}", std::min(all, kMostPoints)));
  }
  // Not the library's distributions: their numbers differ from one library to another.
  std::mt19937_64 random(seed);
  std::set<std::vector<std::size_t>> seen;
  std::vector<Settings> points;
  while (points.size() < count) {
    std::vector<std::size_t> choice;
    for (const Axis& axis : axes) choice.push_back((random() >> 11) % axis.values.size());
    if (!seen.insert(choice).second) continue;
    Settings settings;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      settings.push_back({axes[k].key, axes[k].values[choice[k]], axes[k].line});
    }
    points.push_back(std::move(settings));
  }
  return points;
}

}  // namespace wedgesim::reports

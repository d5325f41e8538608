#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <string>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports {

/// One key of a point, and the line that sets it.
struct Setting {
  std::string key;  // dotted: "block.tile"
  Value value;      // a whole number or a word
  int line = 0;
};
using Settings = std::vector<Setting>;

/// A key of a study file with all that it may be.
struct Axis {
  std::string key;
  std::vector<Value> values;
  int line = 0;
};

/// The most values of a key, and the most points of a block.
inline constexpr std::size_t kMostPoints = 100000;

/// The values of a node: one, a list, or a range {low, high, step} or {low, high, log2 = true}.
/// \throws InputError at FILE:LINE
Axis read_axis(const std::string& key, const toml::node& node, const std::string& file);

/// The dotted keys of a table in the order of the file.
/// \param reserved  keys of the table itself that are no axes
std::vector<Axis> read_axes(const toml::table& table, const std::string& file,
                            const std::vector<std::string>& reserved);

/// Every combination, the last key changing fastest.
/// \param line  of the block
/// \throws InputError if there are more than kMostPoints, or if a key names a value twice
std::vector<Settings> grid_points(const std::vector<Axis>& axes, const std::string& file, int line);

/// Point i takes the i-th value of each key; a key with one value is the same in all.
/// \throws InputError if the lists are not equally long
std::vector<Settings> list_points(const std::vector<Axis>& axes, const std::string& file);

/// `count` different points, each value drawn evenly; the same for the same seed everywhere.
/// \throws InputError if there are not so many, or if a key names a value twice
std::vector<Settings> random_points(const std::vector<Axis>& axes, std::size_t count,
                                    std::uint64_t seed, const std::string& file, int line);

}  // namespace wedgesim::reports

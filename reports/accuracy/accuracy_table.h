#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {

/// A column of a scene's table, as text and page have it.
struct Column {
  std::string_view name;
  bool number = true;
  std::string_view group = "";  // over this column and those after it; empty: still the last one
};
std::span<const Column> columns();

/// The cells of a choice that was not refused, one for each column.
std::vector<std::string> cells_of(const Measured& measured, bool on_front);

/// "640x427, 1,234 triangles cast, 2 lights; reference in 3.1 s"
std::string facts_of(const SceneResult& result);

}  // namespace wedgesim::reports::accuracy

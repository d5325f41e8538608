#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/error.h"
#include "traces/trace_generated.h"

namespace wedgesim::traces {

/// Where in a trace a value stands; made into text only when the value is refused.
struct Spot {
  static constexpr std::size_t kNoIndex = ~std::size_t{0};

  std::string_view section = {};  // empty: the trace itself
  std::size_t index = kNoIndex;

  /// "planes[3].c", "camera.eye", "depth[7]", "width"
  std::string text(std::string_view field) const {
    std::string result(section);
    if (index != kNoIndex) result += fmt::format("[{}]", index);
    if (!result.empty() && !field.empty()) result += '.';
    return result.append(field);
  }
};

/// What is expected of the values of a trace. Each function throws InputError where it does not
/// hold: "<place>: <spot and field> is <value>; expected <what>".
class Expect {
 public:
  explicit Expect(std::string_view place) : place_(place) {}

  template <typename Value>
  [[noreturn]] void refuse(Spot at, std::string_view field, const Value& value,
                           std::string_view expected) const {
    throw InputError(place_, fmt::format("{} is {}", at.text(field), value), expected);
  }

  void finite(Spot at, std::string_view field, double value) const {
    if (!std::isfinite(value)) refuse(at, field, value, "a finite number");
  }
  void finite(Spot at, std::string_view field, const fb::Vec3& value) const {
    if (!std::isfinite(value.x()) || !std::isfinite(value.y()) || !std::isfinite(value.z())) {
      refuse(at, field, fmt::format("({}, {}, {})", value.x(), value.y(), value.z()),
             "finite numbers");
    }
  }
  template <std::uint16_t size>
  void finite(Spot at, std::string_view field,
              const flatbuffers::Array<double, size>& values) const {
    for (std::uint16_t i = 0; i < size; ++i) {
      if (!std::isfinite(values[i])) {
        refuse(at, fmt::format("{}[{}]", field, i), values[i], "a finite number");
      }
    }
  }
  void finite(Spot at, std::string_view field, const fb::Matrix4& matrix) const {
    finite(at, std::string(field) + ".columns", *matrix.columns());
  }

  void between(Spot at, std::string_view field, std::int64_t value, std::int64_t low,
               std::int64_t high) const {
    if (value < low || value > high) refuse(at, field, value, fmt::format("{} to {}", low, high));
  }

  /// An index into something of `limit` elements.
  void below(Spot at, std::string_view field, std::uint32_t value, std::uint64_t limit,
             std::string_view limit_name) const {
    if (value >= limit) refuse(at, field, value, fmt::format("below {}, {}", limit, limit_name));
  }

  /// A closed interval of finite numbers.
  void interval(Spot at, double z_min, double z_max) const {
    finite(at, "z_min", z_min);
    finite(at, "z_max", z_max);
    if (z_min > z_max) refuse(at, "z_min", z_min, fmt::format("at most its z_max, {}", z_max));
  }

 private:
  std::string_view place_;
};

}  // namespace wedgesim::traces

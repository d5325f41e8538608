#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reports/json.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// "8", "0.25", "both"; empty for nothing. The shortest text that reads back as the same number.
std::string to_text(const Value& value);

/// The number, whole or not; nothing for words.
std::optional<double> number_of(const Value& value);

Json to_json(const Value& value);
Json to_json(const Values& values);
Value value_of(const Json& json);
Values values_of(const Json& json);

/// The value of a key; nothing if there is none.
const Value& find_value(const Values& values, std::string_view key);

/// A point as messages name it: by frame, measure, and what tells its configuration from others.
std::string point_name(const std::string& frame, const std::string& measure,
                       const Values& configuration, const std::vector<std::string>& axes);

/// XXH3 of 128 bits as 32 hexadecimal digits.
std::string hash_of(std::string_view bytes);

}  // namespace wedgesim::reports

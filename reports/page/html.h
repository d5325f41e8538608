#pragma once

#include <map>
#include <string>
#include <string_view>

#include "reports/json.h"

namespace wedgesim::reports::page {

/// Text as it is written between tags and in quoted attributes.
std::string escape(std::string_view text);

/// "<tag>escaped text</tag>"
std::string element(std::string_view tag, std::string_view text);

/// A number and what it counts, in a list of class "facts".
std::string fact(std::size_t number, std::string_view what);

/// A table's heading of a column of numbers.
std::string number_heading(std::string_view name);

/// JSON that a script element may hold: no "<" in it.
std::string script_json(const Json& json);

/// Bytes as a data URI holds them.
std::string base64(std::string_view bytes);

/// A template with each {{name}} replaced; values are put in as they are, and only once.
/// \throws CheckError for a name without a value
std::string fill(std::string_view text,
                 const std::map<std::string, std::string, std::less<>>& values);

}  // namespace wedgesim::reports::page

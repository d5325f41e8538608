#pragma once

#include <string>
#include <string_view>

#include "reports/page/columns.h"

namespace wedgesim::reports::page {

/// How a key is written for readers. Unknown keys are their last part, underscores as blanks.
struct Name {
  std::string label, unit;
  Better better = Better::neither;
};
Name name_of(std::string_view key);

/// Where a word stands among the words of its setting ("none" before "both"), a resolution by its
/// width; 0 if unknown.
std::size_t rank_of(std::string_view key, const std::string& word);

/// The value of a setting that charts hold it at if nothing else decides; nothing if unknown.
Value usual_value(std::string_view key);

/// "1,234,567", "12.3", "0.00123"; four digits at least where there are as many.
std::string number_text(double value);
/// A number as number_text, but whole ones without separators below 10,000; a word as it is.
std::string value_text(const Value& value);
/// "tile 8", "single-pass", "culling both".
std::string setting_text(const Column& column, const Value& value);
/// With a capital first letter.
std::string capital(std::string text);
/// "12.3 %"
std::string percent_text(double share);

}  // namespace wedgesim::reports::page

#include "cli/parse.h"

#include <charconv>
#include <limits>
#include <optional>

namespace wedgesim::cli {
namespace {

constexpr int kMaxPixels = 16384;  // each way

// The whole text as a number; nothing if it is none, or beyond the type's range.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<std::pair<int, int>> two_integers(std::string_view text, char separator) {
  const std::size_t middle = text.find(separator);
  if (middle == std::string_view::npos) return std::nullopt;
  const auto first = number_of<int>(text.substr(0, middle));
  const auto second = number_of<int>(text.substr(middle + 1));
  if (!first || !second) return std::nullopt;
  return std::pair(*first, *second);
}

}  // namespace

int parse_integer(std::string_view option, std::string_view text, int low, int high) {
  const auto value = number_of<int>(text);
  if (!value || *value < low || *value > high) {
    const std::string expected = high == std::numeric_limits<int>::max()
                                     ? fmt::format("a whole number from {}", low)
                                     : fmt::format("a whole number from {} to {}", low, high);
    throw InputError(option, fmt::format("'{}' is not allowed", text), expected);
  }
  return *value;
}

double parse_number(std::string_view option, std::string_view text, double low, double high) {
  const auto value = number_of<double>(text);
  if (!value || !(*value >= low && *value <= high)) {
    throw InputError(option, fmt::format("'{}' is not allowed", text),
                     fmt::format("a number from {:g} to {:g}", low, high));
  }
  return *value;
}

std::pair<int, int> parse_size(std::string_view option, std::string_view text) {
  const auto size = two_integers(text, 'x');
  const auto fits = [](int pixels) { return pixels >= 1 && pixels <= kMaxPixels; };
  if (!size || !fits(size->first) || !fits(size->second)) {
    throw InputError(option, fmt::format("'{}' is not a size", text),
                     fmt::format("WIDTHxHEIGHT, 1 to {} pixels each way", kMaxPixels));
  }
  return *size;
}

std::pair<int, int> parse_point(std::string_view option, std::string_view text) {
  const auto point = two_integers(text, ',');
  if (!point || point->first < 0 || point->second < 0) {
    throw InputError(option, fmt::format("'{}' is not a pixel", text), "X,Y from the top left");
  }
  return *point;
}

std::pair<std::uint64_t, std::uint64_t> parse_window(std::string_view option,
                                                     std::string_view text) {
  const std::size_t middle = std::min(text.find(','), text.size());
  const auto begin = number_of<std::uint64_t>(text.substr(0, middle));
  const auto end = number_of<std::uint64_t>(text.substr(std::min(middle + 1, text.size())));
  if (!begin || !end || *begin >= *end) {
    throw InputError(option, fmt::format("'{}' is not a window", text),
                     "BEGIN,END cycles, BEGIN below END");
  }
  return {*begin, *end};
}

std::vector<std::string> parse_list(std::string_view option, std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin) {
      throw InputError(option, fmt::format("'{}' has an empty part", text), "values and commas");
    }
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace wedgesim::cli

#include "reports/stress/case_name.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::reports::stress {
namespace {

// The whole text as a number; nothing if it is none.
template <typename Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t comma = text.find(','); comma != std::string_view::npos;
       comma = text.find(',')) {
    parts.push_back(text.substr(0, comma));
    text.remove_prefix(comma + 1);
  }
  parts.push_back(text);
  return parts;
}

}  // namespace

const Family& find_family(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Family& family : families()) {
    if (family.name == name) return family;
    names.push_back(family.name);
  }
  throw InputError(fmt::format("family '{}'", name), "there is none of this name",
                   fmt::format("one of {}", fmt::join(names, ", ")));
}

CaseName parse_case(std::string_view option, std::string_view text) {
  const std::vector<std::string_view> parts = parts_of(text);
  if (parts.size() != 3) {
    throw InputError(option, fmt::format("'{}' is not a case", text), "FAMILY,SEED,DIFFICULTY");
  }
  CaseName name;
  name.family = &find_family(parts[0]);
  const auto seed = number_of<std::uint64_t>(parts[1]);
  if (!seed) {
    throw InputError(option, fmt::format("'{}' is not a seed", parts[1]), "a whole number from 0");
  }
  name.seed = *seed;
  const auto difficulty = number_of<double>(parts[2]);
  const auto [least, greatest] = std::ranges::minmax(name.family->levels);
  if (!difficulty || !(*difficulty >= least && *difficulty <= greatest)) {
    throw InputError(
        option, fmt::format("'{}' is not a difficulty of {}", parts[2], name.family->name),
        fmt::format("a number from {} to {}", difficulty_text(least), difficulty_text(greatest)));
  }
  const double step = name.family->step;
  if (step > 0.0 && std::fmod(*difficulty, step) != 0.0) {
    throw InputError(
        option,
        fmt::format("'{}' is not a difficulty of {}, which counts", parts[2], name.family->name),
        fmt::format("a multiple of {} from {} to {}", step, difficulty_text(least),
                    difficulty_text(greatest)));
  }
  name.difficulty = *difficulty;
  return name;
}

std::string to_text(const CaseName& name) {
  return fmt::format("{},{},{}", name.family->name, name.seed, difficulty_text(name.difficulty));
}

std::string difficulty_text(double difficulty) {
  const double size = std::fabs(difficulty);
  if (size == 0.0 || (size >= 1e-3 && size < 1e4)) return fmt::format("{}", difficulty);
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), difficulty,
                                          std::chars_format::scientific);
  WEDGESIM_CHECK(error == std::errc{});
  std::string text(digits.data(), end);
  const std::size_t exponent = text.find('e') + 1;
  if (text[exponent] == '+') text.erase(exponent, 1);
  const std::size_t zero = text.find_first_not_of('-', exponent);
  if (text[zero] == '0') text.erase(zero, 1);
  return text;
}

}  // namespace wedgesim::reports::stress

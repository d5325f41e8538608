#include "reports/runner/value.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <cmath>

namespace wedgesim::reports {

std::string to_text(const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  return {};
}

std::optional<double> number_of(const Value& value) {
  if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

Json to_json(const Value& value) {
  return std::visit(
      [](const auto& held) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return nullptr;
        } else {
          return held;
        }
      },
      value);
}

Json to_json(const Values& values) {
  Json json = Json::object();
  for (const auto& [key, value] : values) json[key] = to_json(value);
  return json;
}

Value value_of(const Json& json) {
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_number_float()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return {};
}

Values values_of(const Json& json) {
  Values values;
  for (const auto& [key, value] : json.items()) values.emplace(key, value_of(value));
  return values;
}

const Value& find_value(const Values& values, std::string_view key) {
  static const Value nothing;
  const auto found = values.find(key);
  return found == values.end() ? nothing : found->second;
}

std::string point_name(const std::string& frame, const std::string& measure,
                       const Values& configuration, const std::vector<std::string>& axes) {
  std::string name = frame + ' ' + measure;
  for (const std::string& axis : axes) {
    const std::string value = to_text(find_value(configuration, axis));
    if (!value.empty()) name += fmt::format(" {}={}", axis, value);
  }
  return name;
}

std::string hash_of(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace wedgesim::reports

#include "reports/claims/claim_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/error.h"
#include "base/toml_table.h"
#include "reports/runner/axes.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

constexpr std::array<std::string_view, 6> kKinds{"saved", "more",  "ratio",
                                                 "share", "value", "best"};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

Sum read_sum(const TomlTable& table, std::string_view key) {
  const std::string text = table.text(key);
  Sum sum;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('+', begin), text.size());
    std::string_view term = trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    double factor = 1.0;
    const auto [rest, error] = std::from_chars(term.data(), term.data() + term.size(), factor);
    if (error == std::errc{}) {
      term = trimmed(term.substr(static_cast<std::size_t>(rest - term.data())));
    }
    if (term.empty()) table.fail(key, "lacks a metric", "metrics with + between them");
    sum.terms.push_back({error == std::errc{} ? factor : 1.0, std::string(term)});
  }
  return sum;
}

// The dotted keys of a table, each with one value or several.
std::map<std::string, std::vector<Value>> read_keys(const toml::table& parent, std::string_view key,
                                                    const std::string& file) {
  std::map<std::string, std::vector<Value>> keys;
  const toml::table* table = parent[key].as_table();
  if (table == nullptr) return keys;
  for (Axis& axis : read_axes(*table, file, {})) keys[axis.key] = std::move(axis.values);
  return keys;
}

Values single(const std::map<std::string, std::vector<Value>>& keys) {
  Values values;
  for (const auto& [key, all] : keys) values[key] = all.front();
  return values;
}

Measurement read_measurement(const toml::table& raw, bool of_methods, const std::string& file) {
  const TomlTable table(raw, file);
  Measurement measurement;
  measurement.definition = table.text("definition");
  const std::string kind = table.text("kind");
  const auto known = std::ranges::find(kKinds, kind);
  if (known == kKinds.end()) {
    table.fail("kind", fmt::format("is '{}'", kind), "saved, more, ratio, share, value or best");
  }
  measurement.kind = static_cast<ClaimKind>(known - kKinds.begin());
  measurement.measure = of_methods ? "accuracy" : table.text("measure", "count");
  measurement.metric = read_sum(table, "metric");
  measurement.of = table.has("of") ? read_sum(table, "of") : measurement.metric;
  if (measurement.kind == ClaimKind::best) measurement.over = table.text("over");
  measurement.where = read_keys(raw, "where", file);
  measurement.from = single(read_keys(raw, "from", file));
  measurement.to = single(read_keys(raw, "to", file));
  for (const char* key : {"where", "from", "to"}) table.has(key);
  table.reject_unknown();
  return measurement;
}

Claim read_claim(const toml::table& raw, const std::string& file) {
  const TomlTable table(raw, file);
  Claim claim;
  claim.id = table.text("id");
  claim.paper = table.text("paper");
  claim.section = table.text("section");
  claim.says = table.text("says");
  claim.unit = table.text("unit");
  const glm::dvec2 band = table.vec2("band");
  claim.low = band.x;
  claim.high = band.y;
  if (!(band.x <= band.y)) table.fail("band", "is upside down", "[low, high]");
  const std::string statistic = table.text("statistic", "median");
  if (statistic != "median" && statistic != "most") {
    table.fail("statistic", fmt::format("is '{}'", statistic), "median or most");
  }
  claim.most = statistic == "most";
  if (table.has("scenes")) {
    for (const Value& scene : read_axis("scenes", *raw.get("scenes"), file).values) {
      claim.scenes.push_back(to_text(scene));
    }
  }
  const std::string by = table.text("by", "study");
  if (by != "study" && by != "accuracy") {
    table.fail("by", fmt::format("is '{}'", by), "study or accuracy");
  }
  claim.of_methods = by == "accuracy";
  claim.wedges = claim.of_methods ? "" : table.text("wedges", "linear");
  claim.needs = table.text("needs", "");
  claim.likely = table.text("likely", "");
  table.has("measured");
  table.reject_unknown();
  if (const toml::array* measured = raw["measured"].as_array()) {
    for (const toml::node& one : *measured) {
      if (one.is_table())
        claim.measured.push_back(read_measurement(*one.as_table(), claim.of_methods, file));
    }
  }
  if (claim.measured.empty() == claim.needs.empty()) {
    table.fail("id", "has nothing measured and says nothing that it needs, or both",
               "[[claim.measured]] or needs");
  }
  return claim;
}

ClaimFile built_in_claims(bool of_methods) {
  ClaimFile file = parse_claims(built_in_claim_files().front().text, "reports/claims.toml");
  std::erase_if(file.claims, [=](const Claim& claim) { return claim.of_methods != of_methods; });
  if (of_methods) file.defaults.clear();
  return file;
}

}  // namespace

std::optional<double> Sum::of(const PointRow& point) const {
  double sum = 0.0;
  for (const Term& term : terms) {
    const std::optional<double> value = number_of(find_value(point.metrics, term.metric));
    if (!value) return std::nullopt;
    sum += term.factor * *value;
  }
  return sum;
}

ClaimFile parse_claims(std::string_view text, const std::string& file) {
  const toml::table root = parse_toml(text, file);
  ClaimFile claims;
  claims.defaults = single(read_keys(root, "defaults", file));
  const toml::array* all = root["claim"].as_array();
  if (all == nullptr) throw InputError(file, "holds no [[claim]]", "claims");
  for (const toml::node& one : *all) {
    if (one.is_table()) claims.claims.push_back(read_claim(*one.as_table(), file));
  }
  return claims;
}

const ClaimFile& study_claims() {
  static const ClaimFile claims = built_in_claims(false);
  return claims;
}

const ClaimFile& method_claims() {
  static const ClaimFile claims = built_in_claims(true);
  return claims;
}

}  // namespace wedgesim::reports

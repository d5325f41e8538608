#include <algorithm>
#include <functional>
#include <numeric>

#include "reports/page/columns.h"
#include "reports/page/names.h"

namespace wedgesim::reports::page {
namespace {

/// Adds a column from numbers of others, unless the study has it already.
class Deriver {
 public:
  Deriver(const Columns& columns, std::vector<Column>& derived)
      : columns_(columns), derived_(derived) {}

  void add(const std::string& key, const std::vector<std::string>& from,
           const std::function<Value(const std::vector<double>&)>& value) {
    if (columns_.find(key) != nullptr) return;
    std::vector<const Column*> sources;
    for (const std::string& source : from) {
      sources.push_back(find(source));
      if (sources.back() == nullptr) return;
    }
    const Name name = name_of(key);
    Column column{key,         name.label,
                  name.unit,   Column::Kind::metric,
                  name.better, std::vector<Value>(columns_.points()),
                  {}};
    for (std::size_t i = 0; i < columns_.points(); ++i) {
      std::vector<double> numbers;
      for (const Column* source : sources) {
        if (const auto number = source->number(i)) numbers.push_back(*number);
      }
      if (numbers.size() == sources.size()) column.values[i] = value(numbers);
    }
    derived_.push_back(std::move(column));
  }

 private:
  const Column* find(const std::string& key) const {
    const auto found = std::ranges::find(derived_, key, &Column::key);
    return found == derived_.end() ? columns_.find(key) : &*found;
  }

  const Columns& columns_;
  std::vector<Column>& derived_;
};

Value ratio(double part, double whole) { return whole > 0.0 ? Value(part / whole) : Value(); }

}  // namespace

void add_derived(const Columns& columns, std::vector<Column>& derived) {
  std::vector<std::string> formats;
  for (const Column& column : columns.all()) {
    if (column.key.starts_with("formats.") && column.varies()) formats.push_back(column.key);
  }
  derived.reserve(8);  // sources are pointed to
  Deriver deriver(columns, derived);
  deriver.add("accesses", {"z_reads", "li_writes"},
              [](const auto& n) { return static_cast<std::int64_t>(n[0] + n[1]); });
  deriver.add("over_floor", {"accesses", "z_reads_floor", "li_writes_floor"},
              [](const auto& n) { return ratio(n[0], n[1] + n[2]); });
  deriver.add(
      "cull_efficiency",
      {"needless_visits", "visits_culled_zmax", "visits_culled_zrange", "visits_culled_planes",
       "visits_culled_sat", "umbra_visits_culled"},
      [](const auto& n) { return ratio(100.0 * (n[1] + n[2] + n[3] + n[4] + n[5]), n[0]); });
  deriver.add("frames_per_second", {"cycles", "block.clock_mhz"},
              [](const auto& n) { return ratio(1e6 * n[1], n[0]); });
  if (formats.empty()) return;
  deriver.add("format_bits", formats, [](const auto& n) {
    return static_cast<std::int64_t>(std::accumulate(n.begin(), n.end(), 0.0));
  });
}

}  // namespace wedgesim::reports::page

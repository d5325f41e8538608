#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports::page {

/// Is more of it better, or less?
enum class Better { neither, less, more };

/// One value a point; nothing where it was not measured.
struct Column {
  enum class Kind { frame, setting, metric };

  std::string key;    // "width", "block.tile", "z_reads"
  std::string label;  // "tile", "z reads"
  std::string unit;   // "bytes"; may be empty
  Kind kind = Kind::metric;
  Better better = Better::neither;
  std::vector<Value> values;
  std::vector<Value> distinct;  // numbers first, rising, then words; words of known sets in order

  bool varies() const { return distinct.size() > 1; }
  /// All values are numbers, and there is one.
  bool is_number() const;
  std::optional<double> number(std::size_t point) const;
  /// The largest number over the smallest; 1 if that is not above 0.
  double range() const;
};

/// The points of a study, column by column: frame parameters, configuration, metrics, and metrics
/// that follow from them ("accesses", "over_floor", "cull_efficiency", ...).
class Columns {
 public:
  explicit Columns(const Results& results);

  const Results& results() const { return *results_; }
  std::size_t points() const { return results_->points.size(); }
  bool done(std::size_t point) const;
  const std::vector<Column>& all() const { return columns_; }
  /// Null if the study has no such column.
  const Column* find(std::string_view key) const;
  /// The same, only if its values are numbers.
  const Column* number(std::string_view key) const;
  /// What tells the points of one scene apart: varying settings, and the frame parameters that the
  /// study's tables tell apart. Over all other frames medians are taken.
  const std::vector<const Column*>& axes() const { return axes_; }
  bool is_axis(const Column* column) const;
  /// Null if the study has no such axis.
  const Column* axis(std::string_view key) const;

 private:
  Column& add(std::string key, Column::Kind kind);
  void add_frames();
  void add_measures();
  void add_values(Column::Kind kind);
  void add_run_seconds();
  void find_axes();

  const Results* results_;
  std::vector<Column> columns_;
  std::vector<const Column*> axes_;
};

/// Columns that follow from others, where all that they need was measured.
void add_derived(const Columns& columns, std::vector<Column>& derived);

}  // namespace wedgesim::reports::page

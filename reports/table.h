#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wedgesim::reports {

/// A text table: columns aligned, two spaces apart, a wider gap where a group of columns begins.
class Table {
 public:
  enum class Align { left, right };

  /// \param group  title over this column and those that follow, up to the next with a group
  void add_column(std::string title, Align align, std::string group = {});
  /// \param cells  at most as many as columns; missing ones are blank
  void add_row(std::vector<std::string> cells);
  void add_rule();

  /// The lines, each indented and ending in a line feed; no trailing blanks.
  std::string text(std::size_t indent = 0) const;
  /// The same as a Markdown table; a group's title stands before the titles of its columns.
  std::string markdown() const;

 private:
  struct Column {
    std::string title, group;
    Align align;
  };
  std::vector<std::size_t> widths() const;
  std::string group_line(const std::vector<std::size_t>& widths) const;
  std::string line(const std::vector<std::string>& cells,
                   const std::vector<std::size_t>& widths) const;
  std::size_t gap_before(std::size_t column) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;  // an empty one is a rule
};

/// "1,234,567"
std::string grouped(std::uint64_t number);

}  // namespace wedgesim::reports

#include "reports/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace wedgesim::reports {
namespace {

constexpr std::size_t kGap = 2;
constexpr std::size_t kGroupGap = 3;

}  // namespace

void Table::add_column(std::string title, Align align, std::string group) {
  CHECK_EQ(rows_.size(), std::size_t{0});
  columns_.push_back({std::move(title), std::move(group), align});
}

void Table::add_row(std::vector<std::string> cells) {
  CHECK_LE(cells.size(), columns_.size());
  cells.resize(columns_.size());
  rows_.push_back(std::move(cells));
}

void Table::add_rule() { rows_.emplace_back(); }

std::size_t Table::gap_before(std::size_t column) const {
  if (column == 0) return 0;
  return columns_[column].group.empty() ? kGap : kGroupGap;
}

std::vector<std::size_t> Table::widths() const {
  std::vector<std::size_t> widths;
  for (const Column& column : columns_) widths.push_back(column.title.size());
  for (const auto& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  // The first column of a group takes what its group's title lacks.
  std::size_t group_width = 0;
  for (std::size_t i = columns_.size(); i-- > 0;) {
    group_width += widths[i];
    const std::size_t title = columns_[i].group.size();
    if (title > group_width) widths[i] += title - group_width;
    group_width = title > 0 ? 0 : group_width + gap_before(i);
  }
  return widths;
}

std::string Table::group_line(const std::vector<std::size_t>& widths) const {
  std::string text;
  std::size_t at = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    at += gap_before(i);
    if (!columns_[i].group.empty()) {
      text.resize(at, ' ');
      text += columns_[i].group;
    }
    at += widths[i];
  }
  return text;
}

std::string Table::line(const std::vector<std::string>& cells,
                        const std::vector<std::size_t>& widths) const {
  std::string text;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    text.append(gap_before(i), ' ');
    text += columns_[i].align == Align::left ? fmt::format("{:<{}}", cells[i], widths[i])
                                             : fmt::format("{:>{}}", cells[i], widths[i]);
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string Table::text(std::size_t indent) const {
  const std::vector<std::size_t> widths = this->widths();
  std::size_t width = 0;
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    titles.push_back(columns_[i].title);
    width += gap_before(i) + widths[i];
  }
  const std::string rule(width, '-');
  std::vector<std::string> lines{line(titles, widths), rule};
  const std::string groups = group_line(widths);
  if (!groups.empty()) lines.insert(lines.begin(), groups);
  for (const auto& row : rows_) lines.push_back(row.empty() ? rule : line(row, widths));
  std::string text;
  for (const std::string& each : lines) text += std::string(indent, ' ') + each + '\n';
  return text;
}

std::string Table::markdown() const {
  std::string titles = "|";
  std::string alignment = "|";
  std::string group;
  for (const Column& column : columns_) {
    if (!column.group.empty()) group = column.group;
    titles +=
        fmt::format(" {} |", group.empty() || column.title.empty() ? group + column.title
                                                                   : group + ": " + column.title);
    alignment += column.align == Align::left ? "---|" : "---:|";
  }
  std::string text = titles + '\n' + alignment + '\n';
  for (const auto& row : rows_) {
    if (row.empty()) continue;
    text += '|';
    for (const std::string& cell : row) text += ' ' + cell + " |";
    text += '\n';
  }
  return text;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, 1, ',');
  }
  return digits;
}

}  // namespace wedgesim::reports

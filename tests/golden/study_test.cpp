// Are the counters of the default study still the same? A failure lists them key by key.
// docs/testing.md tells how to refresh them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/file.h"
#include "model/count/counters.h"
#include "reports/runner/runner.h"
#include "reports/runner/store.h"
#include "reports/runner/value.h"
#include "tests/base/temporary_folder.h"
#include "tests/golden/golden.h"

namespace wedgesim::tests {
namespace {

constexpr int kMostShown = 40;

// A table with a line of names; a row is known by the cells before the counters.
struct Table {
  std::vector<std::string> counters;
  std::map<std::string, std::vector<std::string>> rows;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

Table parse(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells_of(line);
  const auto keys = static_cast<std::ptrdiff_t>(std::stoul(names.at(0)));
  table.counters.assign(names.begin() + keys + 1, names.end());
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    std::string key;
    for (std::ptrdiff_t i = 0; i < keys; ++i) {
      key += fmt::format("{}{} {}", i == 0 ? "" : ", ", names[static_cast<std::size_t>(i + 1)],
                         cells[static_cast<std::size_t>(i)]);
    }
    table.rows[key].assign(cells.begin() + keys, cells.end());
  }
  return table;
}

// The study's counters: the number of keys and all names, then a row a point.
std::string table_of(const reports::Results& results) {
  const model::Counters registry;
  std::string text = fmt::format("{},frame", results.study.axes.size() + 1);
  for (const std::string& axis : results.study.axes) text += ',' + axis;
  for (const Counter* counter : registry.counters()) text += fmt::format(",{}", counter->name());
  for (const reports::PointRow& point : results.points) {
    text += '\n' + point.frame;
    for (const std::string& axis : results.study.axes) {
      text += ',' + reports::to_text(reports::find_value(point.configuration, axis));
    }
    for (const Counter* counter : registry.counters()) {
      text += ',' + reports::to_text(reports::find_value(point.metrics, counter->name()));
    }
  }
  return text + '\n';
}

std::vector<std::string> differences(const Table& golden, const Table& now) {
  std::vector<std::string> list;
  for (const auto& [key, row] : golden.rows) {
    const auto found = now.rows.find(key);
    if (found == now.rows.end()) {
      list.push_back(key + ": is there no more");
      continue;
    }
    for (std::size_t i = 0; i < golden.counters.size(); ++i) {
      const auto at = std::ranges::find(now.counters, golden.counters[i]);
      const std::string value =
          at == now.counters.end()
              ? "missing"
              : found->second[static_cast<std::size_t>(at - now.counters.begin())];
      if (value != row[i]) {
        list.push_back(fmt::format("{}: {} was {}, is {}", key, golden.counters[i], row[i], value));
      }
    }
  }
  for (const auto& [key, row] : now.rows) {
    if (!golden.rows.contains(key)) list.push_back(key + ": is new");
  }
  return list;
}

TEST(GoldenStudy, CountersOfTheDefaultStudyAreTheSame) {
  const TemporaryFolder folder;
  reports::Study study = reports::read_study("paper2");
  study.pictures = false;
  reports::RunOptions options;
  options.folder = folder / "paper2";
  reports::run_study(study, options);
  const std::string now = table_of(reports::read_results(options.folder));
  const std::filesystem::path file = golden_folder() / "paper2.csv";
  if (updates_golden()) write_file(file, now);
  const std::vector<std::string> list =
      differences(parse(std::string(MappedFile(file).text())), parse(now));
  std::string shown;
  for (std::size_t i = 0; i < list.size() && i < kMostShown; ++i) shown += list[i] + '\n';
  EXPECT_EQ(list.size(), 0U) << shown;
}

TEST(GoldenStudy, DifferencesAreToldKeyByKey) {
  const Table golden = parse("2,frame,tile,z_reads,li_writes\na,8,5,6\nb,8,7,8\n");
  const Table now = parse("2,frame,tile,li_writes,z_reads\na,8,6,4\nc,8,7,8\n");
  const std::vector<std::string> list = differences(golden, now);
  EXPECT_EQ(list, (std::vector<std::string>{"frame a, tile 8: z_reads was 5, is 4",
                                            "frame b, tile 8: is there no more",
                                            "frame c, tile 8: is new"}));
}

}  // namespace
}  // namespace wedgesim::tests

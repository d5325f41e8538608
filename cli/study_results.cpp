#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/print.h"
#include "cli/study_output.h"
#include "reports/page/study_page.h"
#include "reports/runner/merge.h"
#include "reports/runner/store.h"
#include "reports/runner/summary.h"
#include "reports/table.h"

namespace wedgesim::cli {
namespace {

int merge(const std::vector<std::string>& folders, const std::string& output) {
  const reports::Results results = reports::merge_results({folders.begin(), folders.end()}, output);
  const std::string tables = write_study(output, results);
  const std::size_t points = results.points.size();
  const auto planned = static_cast<std::size_t>(results.points_planned);
  print(fmt::format("{}{} of {} points from {} folders are in {}/\n", tables,
                    reports::grouped(points), reports::grouped(planned), folders.size(), output));
  return points == planned && reports::held(results) ? 0 : 1;
}

int report(const std::string& folder, const std::string& output) {
  const std::filesystem::path page =
      output.empty() ? reports::page::page_path(folder) : std::filesystem::path(output);
  reports::page::write_study_page(folder, reports::read_results(folder), page);
  print(fmt::format("The page: {}\n", page.string()));
  return 0;
}

int compare(const std::string& a, const std::string& b) {
  const std::vector<std::string> lines =
      reports::differences(reports::read_results(a), reports::read_results(b));
  for (const std::string& line : lines) print(line + '\n');
  print(lines.empty() ? "no difference, timing aside\n"
                      : fmt::format("{} differences\n", reports::grouped(lines.size())));
  return lines.empty() ? 0 : 1;
}

}  // namespace

Command add_merge(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("merge", "Put the results of a study's shards together");
  auto folders = std::make_shared<std::vector<std::string>>();
  auto output = std::make_shared<std::string>();
  app->add_option("DIR", *folders, "Folders of the shards")->required()->type_name("...");
  app->add_option("-o,--output", *output, "Folder to write")->required()->type_name("DIR");
  app->footer("Example:\n  wedgesim study merge out/paper2/shard-* -o out/paper2");
  return {app, [folders, output] { return merge(*folders, *output); }};
}

Command add_report(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand("report", "Write the page of a study's results again");
  auto folder = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  app->add_option("DIR", *folder, "Folder of the results")->required()->type_name("");
  app->add_option("-o,--output", *output, "The page; DIR/report.html without it")
      ->type_name("FILE");
  app->footer("Example:\n  wedgesim study report out/paper2");
  return {app, [folder, output] { return report(*folder, *output); }};
}

Command add_compare(CLI::App& parent) {
  CLI::App* app = parent.add_subcommand(
      "compare", "Say what differs between two results of a study, key by key, timing aside");
  auto a = std::make_shared<std::string>();
  auto b = std::make_shared<std::string>();
  app->add_option("A", *a, "Folder of the first results")->required()->type_name("");
  app->add_option("B", *b, "Folder of the second")->required()->type_name("");
  app->footer("Example:\n  wedgesim study compare out/before out/after");
  return {app, [a, b] { return compare(*a, *b); }};
}

}  // namespace wedgesim::cli

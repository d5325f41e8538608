#include "reports/runner/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>
#include <tuple>

#include "base/error.h"
#include "base/file.h"
#include "reports/runner/frames.h"
#include "reports/runner/store.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

/// A shard's folder with what it holds.
struct Part {
  std::filesystem::path folder;
  Stored stored;
};

bool are_of_one_study(const Stored& a, const Stored& b) {
  return a.study == b.study && a.points_planned == b.points_planned;
}

void require_one_study(const Part& first, const Part& other) {
  const auto refuse = [&](std::string_view what) {
    throw InputError(other.folder.string(), fmt::format("{} than {}", what, first.folder.string()),
                     "shards of one study, run by one build");
  };
  if (other.stored.sources != first.stored.sources) refuse("was made by other sources");
  if (!are_of_one_study(other.stored, first.stored)) refuse("holds another study");
}

void require_room_for(const Stored& study, const std::filesystem::path& folder) {
  std::error_code error;
  if (!std::filesystem::exists(results_path(folder), error)) return;
  if (are_of_one_study(read_stored(folder), study)) return;
  throw InputError(folder.string(), "holds another study",
                   "a folder without results, or with those of this study");
}

// A link costs nothing where both folders are on one disk.
void take_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  if (!std::filesystem::exists(from, error) || std::filesystem::exists(to, error)) return;
  std::filesystem::create_hard_link(from, to, error);
  if (error) write_file(to, MappedFile(from).bytes());
}

// Only a sound one: the study renders the frame again if there is none.
void take_trace(const FrameRow& frame, const std::filesystem::path& from,
                const std::filesystem::path& to) {
  if (!frame.failure.empty() || holds_trace(to, frame.checksum)) return;
  std::error_code error;
  std::filesystem::remove(to, error);
  if (holds_trace(from, frame.checksum)) take_file(from, to);
}

bool equal_but_timing(const FrameRow& a, const FrameRow& b) {
  return a.key == b.key && a.checksum == b.checksum && a.failure == b.failure;
}

bool equal_but_timing(const PointRow& a, const PointRow& b) {
  return a.key == b.key && a.state == b.state && a.metrics == b.metrics;
}

// The rows of all parts by their places; those that two of them have must be the same.
template <typename Row>
void collect(const std::filesystem::path& folder, const std::map<Position, Row>& rows,
             std::map<Position, Row>& all) {
  for (const auto& [position, row] : rows) {
    const auto [there, is_new] = all.try_emplace(position, row);
    if (is_new || equal_but_timing(row, there->second)) continue;
    throw InputError(folder.string(), fmt::format("differs from another shard in row {}", position),
                     "shards that agree; `wedgesim study compare` says in what they differ");
  }
}

void compare_values(const std::string& name, const Values& a, const Values& b,
                    std::vector<std::string>& lines) {
  Values all = a;
  all.insert(b.begin(), b.end());
  for (const auto& [key, value] : all) {
    const Value& first = find_value(a, key);
    const Value& second = find_value(b, key);
    if (first == second) continue;
    const auto shown = [](const Value& v) {
      return std::holds_alternative<std::monostate>(v) ? std::string("nothing") : to_text(v);
    };
    lines.push_back(fmt::format("{}: {}: {} against {}", name, key, shown(first), shown(second)));
  }
}

// Both maps' keys in order; `compare` gets what each holds, null where it holds nothing.
template <typename Row, typename Key, typename Compare>
void walk_both(const std::map<Key, const Row*>& a, const std::map<Key, const Row*>& b,
               const Compare& compare) {
  std::map<Key, std::pair<const Row*, const Row*>> both;
  for (const auto& [key, row] : a) both[key].first = row;
  for (const auto& [key, row] : b) both[key].second = row;
  for (const auto& [key, rows] : both) compare(rows.first, rows.second);
}

void compare_frames(const Results& a, const Results& b, std::vector<std::string>& lines) {
  const auto by_label = [](const Results& results) {
    std::map<std::string, const FrameRow*> frames;
    for (const FrameRow& frame : results.frames) frames.emplace(frame.label, &frame);
    return frames;
  };
  walk_both(by_label(a), by_label(b), [&lines](const FrameRow* first, const FrameRow* second) {
    if (first == nullptr || second == nullptr) {
      lines.push_back(fmt::format("{}: only in the {} results",
                                  (first == nullptr ? second : first)->label,
                                  first == nullptr ? "second" : "first"));
      return;
    }
    const auto values = [](const FrameRow& frame) {
      Values all = frame.parameters;
      all["trace"] = fmt::format("{:016x}", frame.checksum);
      all["wedges"] = frame.wedges;
      all["failure"] = frame.failure;
      return all;
    };
    compare_values(first->label, values(*first), values(*second), lines);
  });
}

void compare_points(const Results& a, const Results& b, std::vector<std::string>& lines) {
  using Key = std::tuple<std::string, std::string, Values>;
  const auto by_configuration = [](const Results& results) {
    std::map<Key, const PointRow*> points;
    for (const PointRow& point : results.points) {
      points.emplace(Key(point.frame, point.measure, point.configuration), &point);
    }
    return points;
  };
  std::vector<std::string> axes = a.study.axes;
  for (const std::string& axis : b.study.axes) {
    if (std::find(axes.begin(), axes.end(), axis) == axes.end()) axes.push_back(axis);
  }
  walk_both(by_configuration(a), by_configuration(b),
            [&](const PointRow* first, const PointRow* second) {
              const PointRow& either = first == nullptr ? *second : *first;
              const std::string name =
                  point_name(either.frame, either.measure, either.configuration, axes);
              if (first == nullptr || second == nullptr) {
                lines.push_back(fmt::format("{}: only in the {} results", name,
                                            first == nullptr ? "second" : "first"));
                return;
              }
              if (first->state != second->state) {
                lines.push_back(fmt::format("{}: {} against {}", name, spelling(first->state),
                                            spelling(second->state)));
              }
              compare_values(name, first->metrics, second->metrics, lines);
            });
}

}  // namespace

Results merge_results(const std::vector<std::filesystem::path>& from,
                      const std::filesystem::path& to) {
  std::vector<Part> parts;
  for (const std::filesystem::path& folder : from) parts.push_back({folder, read_stored(folder)});
  std::map<Position, FrameRow> frames;
  std::map<Position, PointRow> points;
  for (const Part& part : parts) {
    require_one_study(parts.front(), part);
    collect(part.folder, part.stored.frames, frames);
    collect(part.folder, part.stored.points, points);
  }
  require_room_for(parts.front().stored, to);
  {
    const Stored& first = parts.front().stored;
    Store store(to, first.sources);
    store.begin(first.study, first.points_planned);
    store.keep_all(frames, points);
  }
  for (const Part& part : parts) {
    for (const auto& [position, frame] : part.stored.frames) {
      take_trace(frame, trace_path(part.folder, frame.label), trace_path(to, frame.label));
      const auto pictures = picture_paths(part.folder, frame.label);
      for (const auto& picture : pictures) take_file(picture, to / picture.filename());
    }
  }
  return read_results(to);
}

std::vector<std::string> differences(const Results& a, const Results& b) {
  std::vector<std::string> lines;
  if (a.study.name != b.study.name) {
    lines.push_back(fmt::format("study: {} against {}", a.study.name, b.study.name));
  }
  compare_frames(a, b, lines);
  compare_points(a, b, lines);
  return lines;
}

}  // namespace wedgesim::reports

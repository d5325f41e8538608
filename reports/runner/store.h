#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "reports/runner/results.h"
#include "reports/runner/sqlite.h"

namespace wedgesim::reports {

/// The file of results in a study's folder.
std::filesystem::path results_path(const std::filesystem::path& folder);

/// A point's place in its study: frame times the number of configurations plus configuration.
using Position = std::int64_t;

/// The results of a study in SQLite, one transaction a point (docs/studies.md has the schema). Rows
/// that other sources made (sources.h) are there no more for it, nor rows of frames and points that
/// the study does not hold; the next run of a study that does hold them finds them again.
class Store {
 public:
  /// Opens or makes the file, alone.
  /// \param sources  the hash of what decides results
  /// \throws InputError if it cannot be written, or another run works on it
  Store(const std::filesystem::path& folder, std::string sources);
  /// Leaves one file, which can be read where nothing can be written.
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Says what the study is. Its frames and points have no place in it until they are kept.
  void begin(const StudyHead& study, std::int64_t points);

  /// Frames that were rendered, or failed, by key.
  std::map<std::string, FrameRow> known_frames();
  /// Puts a frame at its place.
  void keep(const FrameRow& frame, Position position);

  /// States of the points of a frame, by key.
  std::map<std::string, PointState> point_states(const std::string& frame);
  /// What a frame that could not be rendered made of its points.
  PointState failure_state(const FrameRow& frame);
  /// Puts points that are there at their places.
  void place(const std::string& frame, const std::map<std::string, Position>& positions);
  /// Adds a point, or replaces it.
  void keep(const PointRow& point, Position position);

  /// Adds all rows at their places, or replaces them.
  void keep_all(const std::map<Position, FrameRow>& frames,
                const std::map<Position, PointRow>& points);

 private:
  void write(const FrameRow& frame, Position position);
  void write(const PointRow& point, Position position);

  Database database_;
  std::string sources_;
};

/// What a folder holds of its study, rows by their places.
struct Stored {
  StudyHead study;
  std::string sources;  // the hash of those that made the rows
  std::int64_t points_planned = 0;
  std::map<Position, FrameRow> frames;
  std::map<Position, PointRow> points;
};

/// \throws InputError if there are no results
Stored read_stored(const std::filesystem::path& folder);

/// The same as lists in the study's order.
Results read_results(const std::filesystem::path& folder);

std::string_view spelling(PointState state);

}  // namespace wedgesim::reports

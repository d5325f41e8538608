#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runner/shard.h"
#include "reports/runner/sources.h"
#include "reports/runner/study_file.h"

namespace wedgesim::reports {

/// How many points there are, and how far a run has come.
struct RunCounts {
  std::size_t points = 0;    // of this shard
  std::size_t kept = 0;      // measured by an earlier run
  std::size_t measured = 0;  // by this one
  std::size_t rendered = 0;  // frames, by this one
  std::size_t frames = 0;    // to render in this one
};

struct RunOptions {
  std::filesystem::path folder;
  unsigned jobs = 0;  // worker processes; 0: one a core
  Shard shard;
  bool retry = false;  // also what an earlier run could not do
  std::string sources = std::string(sources_hash());
  /// Called with a line that says how far the run is, about twice a second.
  std::function<void(std::string_view)> progress = [](std::string_view) {};
  /// In a worker before it measures a point, or renders a frame; for tests of what happens when
  /// that goes wrong.
  std::function<void(const Configuration&)> before = [](const Configuration&) {};
  std::function<void(const FrameSpec&)> before_render = [](const FrameSpec&) {};
};

/// Runs what the folder does not hold yet of a study: renders frames into LABEL.wtrace (and their
/// pictures), measures points, each kept in results.sqlite as soon as it is there. A point that
/// fails, crashes or takes too long is kept with its message, and the rest goes on. After a kill
/// at any moment the next run goes on from there.
/// The process must not have threads.
/// \throws InputError before any work if the folder cannot be written, another run works in it, or
///         one of its files is what the study is read from
RunCounts run_study(const Study& study, const RunOptions& options);

/// The positions of a shard's points.
std::vector<std::pair<std::size_t, std::vector<std::size_t>>> points_by_frame(const Study& study,
                                                                              const Shard& shard);

}  // namespace wedgesim::reports

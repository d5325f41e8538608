#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "reports/runner/study_file.h"

namespace wedgesim::reports {

/// What a worker does next: render a frame, or measure points of one.
struct Job {
  std::size_t frame = 0;
  std::vector<std::size_t> configurations;  // none: render the frame
  bool renders() const { return configurations.empty(); }
};

/// The jobs of a study that wait for a worker. Points that have a walk or a block's values in
/// common are in one job, or follow each other.
class Schedule {
 public:
  /// The most points of a job: what a kill loses, and a worker has while others have none.
  static constexpr std::size_t kMostCounted = 32, kMostRun = 8;

  explicit Schedule(const Study& study) : study_(study), frames_(study.frames.size()) {}

  void add_render(std::size_t frame) { renders_.push_back(frame); }
  void add_points(std::size_t frame, std::vector<std::size_t> configurations);
  /// Points of a job that failed as a whole, one by one.
  void add_singly(const Job& job);
  void add_first(Job job) { frames_[job.frame].push_front(std::move(job)); }

  /// A job for a worker, best of the frame that it worked on last.
  /// \param at_work  frames that other workers work on
  std::optional<Job> next(std::optional<std::size_t> last, const std::vector<bool>& at_work);

 private:
  Job take(std::size_t frame);

  const Study& study_;
  std::deque<std::size_t> renders_;
  std::vector<std::deque<Job>> frames_;
};

}  // namespace wedgesim::reports

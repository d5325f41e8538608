#include "reports/runner/schedule.h"

#include <algorithm>
#include <map>

#include "reports/runner/measure.h"

namespace wedgesim::reports {

void Schedule::add_points(std::size_t frame, std::vector<std::size_t> configurations) {
  // Those that have most in common beside each other; within them the study's order.
  std::vector<std::size_t> first(study_.configurations.size());
  std::map<std::vector<int>, std::size_t> firsts;
  for (const std::size_t i : configurations) {
    first[i] = firsts.try_emplace(common_part(study_.configurations[i]), i).first->second;
  }
  std::ranges::stable_sort(configurations, {}, [&first](std::size_t i) { return first[i]; });
  std::deque<Job>& jobs = frames_[frame];
  for (const std::size_t i : configurations) {
    const bool counted = study_.configurations[i].measure == Measure::count;
    const bool joins = !jobs.empty() &&
                       jobs.back().configurations.size() < (counted ? kMostCounted : kMostRun) &&
                       first[jobs.back().configurations.front()] == first[i];
    if (!joins) jobs.push_back({frame, {}});
    jobs.back().configurations.push_back(i);
  }
}

void Schedule::add_singly(const Job& job) {
  for (auto i = job.configurations.rbegin(); i != job.configurations.rend(); ++i) {
    frames_[job.frame].push_front({job.frame, {*i}});
  }
}

Job Schedule::take(std::size_t frame) {
  Job job = std::move(frames_[frame].front());
  frames_[frame].pop_front();
  return job;
}

std::optional<Job> Schedule::next(std::optional<std::size_t> last,
                                  const std::vector<bool>& at_work) {
  if (last && !frames_[*last].empty()) return take(*last);
  for (std::size_t frame = 0; frame < frames_.size(); ++frame) {
    if (!frames_[frame].empty() && !at_work[frame]) return take(frame);
  }
  if (!renders_.empty()) {
    const Job job{renders_.front(), {}};
    renders_.pop_front();
    return job;
  }
  const auto most =
      std::ranges::max_element(frames_, {}, [](const auto& jobs) { return jobs.size(); });
  if (most == frames_.end() || most->empty()) return {};
  return take(static_cast<std::size_t>(most - frames_.begin()));
}

}  // namespace wedgesim::reports

#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Takes the run time of a method's stages, one after the other.
class Stopwatch {
 public:
  explicit Stopwatch(Visibility& visibility) : visibility_(visibility) {}
  /// Ends a stage that began with the last call, or with the stopwatch. What has the name of an
  /// earlier stage is added to it.
  void end(std::string_view stage) {
    const Clock::time_point now = Clock::now();
    auto& stages = visibility_.stages;
    auto same = std::ranges::find(stages, stage, &Stage::name);
    if (same == stages.end()) same = stages.insert(same, {std::string(stage), 0.0});
    same->seconds += std::chrono::duration<double>(now - begin_).count();
    begin_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Visibility& visibility_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace wedgesim::functional

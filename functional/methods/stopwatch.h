#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Takes the run time of a method's stages, one after the other.
class Stopwatch {
 public:
  explicit Stopwatch(Visibility& visibility) : visibility_(visibility) {}
  /// Ends a stage that began with the last call, or with the stopwatch.
  void end(std::string stage) {
    const Clock::time_point now = Clock::now();
    visibility_.stages.push_back(
        {std::move(stage), std::chrono::duration<double>(now - begin_).count()});
    begin_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Visibility& visibility_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace wedgesim::functional

#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "reports/json.h"

namespace wedgesim::reports {

/// A process of its own that does jobs one after another. It ends when its parent does, and takes
/// nobody along when it crashes.
class Worker {
 public:
  using Answer = std::function<void(const Json&)>;
  using Serve = std::function<void(const Json& job, const Answer& answer)>;

  /// Forks; in the child `serve` is called for every job. The parent must not have threads.
  /// \throws std::runtime_error if there can be no further process
  explicit Worker(const Serve& serve);
  /// Ends the process, whatever it does.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void send(const Json& job);
  /// To poll for answers.
  int file() const { return answers_; }
  /// The answers there are, without waiting for more than a part of one.
  std::vector<Json> answers();
  /// Its end of the pipe is closed: it is gone.
  bool ended() const { return ended_; }
  /// Ends it and says how it ended: "signal 11 (Segmentation fault)".
  std::string end();

 private:
  pid_t process_ = -1;
  int jobs_ = -1, answers_ = -1;
  bool ended_ = false;
  std::string text_;  // of an answer, so far
};

}  // namespace wedgesim::reports

#pragma once

#include <filesystem>

namespace wedgesim {

struct TemporarySlot;

/// From now on SIGHUP, SIGINT and SIGTERM, unless they are ignored, remove the files that are
/// RemovedOnSignal before they end the program.
void remove_temporaries_on_signal();

/// While it lives, a signal that ends the program removes this file first. With more than 64 at a
/// time, or a path longer than the system takes, it does nothing.
class RemovedOnSignal {
 public:
  explicit RemovedOnSignal(const std::filesystem::path& path);
  ~RemovedOnSignal();
  RemovedOnSignal(const RemovedOnSignal&) = delete;
  RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;

 private:
  TemporarySlot* slot_ = nullptr;
};

}  // namespace wedgesim

#include "base/temporaries.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

namespace wedgesim {

// What a signal handler may touch: fixed memory and lock-free atomics.
struct TemporarySlot {
  enum State : int { free, taken, filled };
  std::atomic<int> state{free};
  std::array<char, PATH_MAX> path;
};
static_assert(std::atomic<int>::is_always_lock_free);

namespace {

std::array<TemporarySlot, 64> slots;

void remove_and_end(int signal) {
  for (TemporarySlot& slot : slots) {
    if (slot.state == TemporarySlot::filled) unlink(slot.path.data());
  }
  raise(signal);  // its action is the default one again: it ends the program on return
}

}  // namespace

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& path) {
  if (path.native().size() >= PATH_MAX) return;
  for (TemporarySlot& slot : slots) {
    int expected = TemporarySlot::free;
    if (!slot.state.compare_exchange_strong(expected, TemporarySlot::taken)) continue;
    std::memcpy(slot.path.data(), path.c_str(), path.native().size() + 1);
    slot.state = TemporarySlot::filled;
    slot_ = &slot;
    return;
  }
}

RemovedOnSignal::~RemovedOnSignal() {
  if (slot_ != nullptr) slot_->state = TemporarySlot::free;
}

void remove_temporaries_on_signal() {
  struct sigaction action = {};
  action.sa_handler = remove_and_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
    struct sigaction old = {};
    sigaction(signal, nullptr, &old);
    if (old.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

}  // namespace wedgesim

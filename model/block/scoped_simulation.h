#pragma once

#include <systemc>

namespace wedgesim::model {

/// A SystemC simulation of its own: the kernel's globals are swapped for a new context and put
/// back. One at a time in a process; its modules must be gone before it. The globals are outside
/// IEEE 1666, but the library declares both.
class ScopedSimulation {
 public:
  ScopedSimulation()
      : before_(sc_core::sc_curr_simcontext),
        default_(sc_core::sc_default_global_context),
        own_(new sc_core::sc_simcontext) {
    sc_core::sc_curr_simcontext = own_;
    sc_core::sc_default_global_context = own_;
  }
  ~ScopedSimulation() {
    delete own_;
    sc_core::sc_curr_simcontext = before_;
    sc_core::sc_default_global_context = default_;
  }
  ScopedSimulation(const ScopedSimulation&) = delete;
  ScopedSimulation& operator=(const ScopedSimulation&) = delete;

 private:
  sc_core::sc_simcontext* before_;
  sc_core::sc_simcontext* default_;
  sc_core::sc_simcontext* own_;
};

}  // namespace wedgesim::model

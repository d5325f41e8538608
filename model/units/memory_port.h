#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <functional>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/memory/layout.h"
#include "model/memory/memory_record.h"
#include "model/units/unit_time.h"

namespace wedgesim::model::units {

/// What an access is for.
struct AccessTag {
  memory::Surface surface;
  memory::Cause cause;
  std::int64_t wedge = memory::MemoryRecord::kNone;
  std::int64_t tile = memory::MemoryRecord::kNone;
};

/// The block's one port to memory: a TLM-2.0 initiator. Requests of all units leave in the order of
/// their cycles, those of one cycle in the order in which the kernel runs the units. Whoever is
/// behind the socket gets, and answers with, a delay (loosely timed, b_transport).
class MemoryPort final : public sc_core::sc_module {
 public:
  explicit MemoryPort(sc_core::sc_module_name name) : sc_module(name), socket("socket") {}

  tlm_utils::simple_initiator_socket<MemoryPort> socket;

  /// \return  the cycle from which the bytes are there, or taken
  Cycle access(UnitTime& time, const AccessTag& tag, std::uint64_t address, unsigned bytes,
               bool write);

  /// Called for every access from now on.
  void listen(std::function<void(const memory::MemoryRecord&)> listener) {
    listener_ = std::move(listener);
  }

  struct Traffic {
    std::uint64_t reads = 0, writes = 0, read_bytes = 0, write_bytes = 0;
  };
  const Traffic& traffic(memory::Surface surface) const {
    return traffic_[static_cast<std::size_t>(surface)];
  }
  /// The last cycle in which an access was done.
  Cycle last_done() const { return last_done_; }

 private:
  std::array<Traffic, memory::kSurfaces> traffic_;
  std::vector<unsigned char> data_;  // no bytes are kept: the block's values are its own
  tlm::tlm_generic_payload payload_;
  std::function<void(const memory::MemoryRecord&)> listener_;
  Cycle last_done_ = 0;
};

}  // namespace wedgesim::model::units

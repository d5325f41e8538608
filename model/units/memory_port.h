#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <deque>
#include <functional>
#include <systemc>
#include <tlm>
#include <vector>

#include "model/memory/layout.h"
#include "model/memory/memory_model.h"
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
/// their cycles, those of one cycle in the order of the surfaces. Whoever is behind the socket
/// gets, and answers with, a delay (loosely timed, b_transport). A target that waits instead holds
/// the unit that asked: its requests do not overlap then.
class MemoryPort final : public sc_core::sc_module {
 public:
  explicit MemoryPort(sc_core::sc_module_name name) : sc_module(name), socket("socket") {}

  tlm_utils::simple_initiator_socket<MemoryPort> socket;

  /// \return  the cycle from which the bytes are there, or taken
  /// \throws SimulationError if the target answers with an error
  Cycle access(UnitTime& time, const AccessTag& tag, std::uint64_t address, unsigned bytes,
               bool write);

  /// From now on a model is asked directly, past the socket: as what answers its payloads would.
  void bypass(memory::MemoryModel& model) { model_ = &model; }

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
  /// Accesses that have left.
  std::uint64_t accesses() const;

  /// An access that the target has not answered yet.
  struct Waiting {
    memory::Surface surface;
    std::uint64_t address;
    Cycle since;
  };
  std::vector<Waiting> waiting() const;

 private:
  /// One for each unit that is inside the target at a time.
  struct Request {
    tlm::tlm_generic_payload payload;
    std::vector<unsigned char> data;  // no bytes are kept: the block's values are its own
    Waiting waiting{};
    bool under_way = false;
  };
  Request& idle_request();
  Cycle transport(UnitTime& time, const AccessTag& tag, std::uint64_t address, unsigned bytes,
                  bool write, std::uint64_t at);

  memory::MemoryModel* model_ = nullptr;
  std::array<Traffic, memory::kSurfaces> traffic_;
  std::deque<Request> requests_;
  std::function<void(const memory::MemoryRecord&)> listener_;
  Cycle last_done_ = 0;
};

}  // namespace wedgesim::model::units

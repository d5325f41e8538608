#include "model/units/memory_port.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::model::units {

namespace {

// A surface belongs to one unit (LI and stencil to the same), so it says whose turn it is.
unsigned turn_of(memory::Surface surface) { return static_cast<unsigned>(surface); }

}  // namespace

Cycle MemoryPort::access(UnitTime& time, const AccessTag& tag, std::uint64_t address,
                         unsigned bytes, bool write) {
  const std::uint64_t at = time.sync(turn_of(tag.surface));
  CHECK_EQ(at / kResolutionsPerCycle, time.now());
  Traffic& traffic = traffic_[static_cast<std::size_t>(tag.surface)];
  (write ? traffic.writes : traffic.reads) += 1;
  (write ? traffic.write_bytes : traffic.read_bytes) += bytes;
  if (listener_) {
    memory::MemoryRecord record;
    record.cycle = time.now();
    record.client = tag.surface;
    record.write = write;
    record.address = address;
    record.bytes = bytes;
    record.tile = tag.tile;
    record.wedge = tag.wedge;
    record.cause = tag.cause;
    listener_(record);
  }
  const Cycle done = model_ != nullptr ? model_->access(address, bytes, write, time.now())
                                       : transport(time, tag, address, bytes, write, at);
  last_done_ = std::max(last_done_, done);
  return done;
}

// \param at  the unit's time, in the kernel's resolution
Cycle MemoryPort::transport(UnitTime& time, const AccessTag& tag, std::uint64_t address,
                            unsigned bytes, bool write, std::uint64_t at) {
  Request& request = idle_request();
  request.waiting = {tag.surface, address, time.now()};
  if (request.data.size() < bytes) request.data.resize(bytes);
  tlm::tlm_generic_payload& payload = request.payload;
  payload.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
  payload.set_address(address);
  payload.set_data_ptr(request.data.data());
  payload.set_data_length(bytes);
  payload.set_streaming_width(bytes);
  payload.set_byte_enable_ptr(nullptr);
  payload.set_dmi_allowed(false);
  payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  // The kernel may be behind: the target hears by how much.
  sc_core::sc_time delay = sc_core::sc_time::from_value(at - sc_core::sc_time_stamp().value());
  request.under_way = true;
  socket->b_transport(payload, delay);
  request.under_way = false;
  if (!payload.is_response_ok()) {
    throw SimulationError("memory answers " + payload.get_response_string());
  }
  const std::uint64_t after = sc_core::sc_time_stamp().value();
  const Cycle done = time.now() + whole_cycles(after + delay.value() - at);
  if (after > at) time.was_held(whole_cycles(after - at));
  return done;
}

// More than one is needed only while a target waits.
MemoryPort::Request& MemoryPort::idle_request() {
  for (Request& request : requests_) {
    if (!request.under_way) return request;
  }
  return requests_.emplace_back();
}

std::uint64_t MemoryPort::accesses() const {
  std::uint64_t sum = 0;
  for (const Traffic& traffic : traffic_) sum += traffic.reads + traffic.writes;
  return sum;
}

std::vector<MemoryPort::Waiting> MemoryPort::waiting() const {
  std::vector<Waiting> waiting;
  for (const Request& request : requests_) {
    if (request.under_way) waiting.push_back(request.waiting);
  }
  return waiting;
}

}  // namespace wedgesim::model::units

#include "model/units/memory_port.h"

#include <algorithm>

#include "base/check.h"

namespace wedgesim::model::units {

Cycle MemoryPort::access(UnitTime& time, const AccessTag& tag, std::uint64_t address,
                         unsigned bytes, bool write) {
  time.sync();
  if (data_.size() < bytes) data_.resize(bytes);
  payload_.set_command(write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
  payload_.set_address(address);
  payload_.set_data_ptr(data_.data());
  payload_.set_data_length(bytes);
  payload_.set_streaming_width(bytes);
  payload_.set_byte_enable_ptr(nullptr);
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  // The kernel may be behind: the target hears by how much.
  const Cycle kernel = kernel_cycle();
  sc_core::sc_time delay = cycles_to_time(time.now() > kernel ? time.now() - kernel : 0);
  socket->b_transport(payload_, delay);
  CHECK_EQ(payload_.is_response_ok(), true);
  const Cycle done = kernel_cycle() + time_to_cycles(delay);
  last_done_ = std::max(last_done_, done);
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
  return done;
}

}  // namespace wedgesim::model::units

// Does every access reach the target with its command, address and length, and is it accounted for;
// and may a target wait, as TLM-2.0 allows?
#include "model/units/memory_port.h"

#include <string>

#include "tests/model/units/bench.h"

namespace wedgesim::model::units::test {
namespace {

constexpr AccessTag kZ{memory::Surface::z, memory::Cause::fill, 7, 3};
constexpr AccessTag kLi{memory::Surface::li, memory::Cause::flush};

/// Waits 20 cycles in every call, then looks whether the payload is still that of the call.
class WaitingTarget final : public sc_core::sc_module {
 public:
  explicit WaitingTarget(sc_core::sc_module_name name) : sc_module(name), socket("socket") {
    socket.register_b_transport(this, &WaitingTarget::transport);
  }
  tlm_utils::simple_target_socket<WaitingTarget> socket;
  tlm::tlm_response_status answer = tlm::TLM_OK_RESPONSE;
  unsigned mixed_up = 0;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const sc_dt::uint64 address = payload.get_address();
    sc_core::wait(delay + cycles_to_time(20));
    mixed_up += payload.get_address() == address ? 0 : 1;
    delay = sc_core::sc_time(4.5, sc_core::SC_NS);  // seen 5 cycles later
    payload.set_response_status(answer);
  }
};

struct MemoryPortTest : BothTimings {};

TEST_P(MemoryPortTest, AnAccessIsDoneAfterTheDelayAndIsRecorded) {
  Surroundings around;
  std::vector<memory::MemoryRecord> records;
  around.port.listen([&](const memory::MemoryRecord& record) { records.push_back(record); });
  Actor actor("actor", GetParam(), [&](UnitTime& time) {
    time.work(4);
    EXPECT_EQ(around.port.access(time, kZ, 4096, 64, false), 14U);
    time.work(1);
    EXPECT_EQ(around.port.access(time, kLi, 8192, 32, true), 15U);
    EXPECT_EQ(time.now(), 5U);  // the unit goes on
  });
  sc_core::sc_start();
  EXPECT_EQ(around.memory.accesses,
            (std::vector<FakeMemory::Access>{{4, 4096, false}, {5, 8192, true}}));
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].cycle, 4U);
  EXPECT_EQ(records[0].client, memory::Surface::z);
  EXPECT_EQ(records[0].address, 4096U);
  EXPECT_EQ(records[0].bytes, 64U);
  EXPECT_EQ(records[0].wedge, 7);
  EXPECT_EQ(records[0].tile, 3);
  EXPECT_EQ(records[0].cause, memory::Cause::fill);
  EXPECT_FALSE(records[0].write);
  EXPECT_TRUE(records[1].write);
  EXPECT_EQ(records[1].wedge, memory::MemoryRecord::kNone);
  EXPECT_EQ(around.port.traffic(memory::Surface::z).read_bytes, 64U);
  EXPECT_EQ(around.port.traffic(memory::Surface::li).writes, 1U);
  EXPECT_EQ(around.port.traffic(memory::Surface::li).write_bytes, 32U);
  EXPECT_EQ(around.port.accesses(), 2U);
  EXPECT_EQ(around.port.last_done(), 15U);
}

// Asked in cycles 2 and 3 for 20 + 5 cycles each; the unit is held for the 20.
TEST_P(MemoryPortTest, ATargetMayWaitAndHoldsOnlyTheUnitThatAsked) {
  const ScopedSimulation simulation;
  MemoryPort port("port");
  WaitingTarget target("target");
  port.socket.bind(target.socket);
  Actor first("first", GetParam(), [&](UnitTime& time) {
    time.work(2);
    EXPECT_EQ(port.access(time, kZ, 4096, 64, false), 27U);
    EXPECT_EQ(time.now(), 22U);
    EXPECT_EQ(time.memory(), 20U);
  });
  Actor second("second", GetParam(), [&](UnitTime& time) {
    time.work(3);
    EXPECT_EQ(port.access(time, kLi, 8192, 64, true), 28U);
    EXPECT_EQ(time.now(), 23U);
  });
  sc_core::sc_start(cycles_to_time(10));
  const auto waiting = port.waiting();
  ASSERT_EQ(waiting.size(), 2U);
  EXPECT_EQ(waiting[0].surface, memory::Surface::z);
  EXPECT_EQ(waiting[0].address, 4096U);
  EXPECT_EQ(waiting[0].since, 2U);
  EXPECT_EQ(waiting[1].since, 3U);
  sc_core::sc_start();
  EXPECT_TRUE(first.finished() && second.finished());
  EXPECT_EQ(target.mixed_up, 0U);
  EXPECT_TRUE(port.waiting().empty());
}

TEST_P(MemoryPortTest, AnErrorOfTheTargetIsNotSwallowed) {
  const ScopedSimulation simulation;
  MemoryPort port("port");
  WaitingTarget target("target");
  target.answer = tlm::TLM_ADDRESS_ERROR_RESPONSE;
  port.socket.bind(target.socket);
  const Actor actor("actor", GetParam(),
                    [&](UnitTime& time) { port.access(time, kZ, 4096, 64, false); });
  std::string message;
  try {
    sc_core::sc_start();
  } catch (const std::exception& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("TLM_ADDRESS_ERROR_RESPONSE"), std::string::npos) << message;
}

WEDGESIM_BOTH_TIMINGS(MemoryPortTest);

}  // namespace
}  // namespace wedgesim::model::units::test

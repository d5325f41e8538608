// Can a TLM-2.0 target of one's own stand behind the block, as docs/block.md shows, and is one that
// never answers found out?
#include <gtest/gtest.h>
#include <tlm_utils/simple_target_socket.h>

#include "base/error.h"
#include "tests/model/block/frames.h"
#include "tests/model/units/work.h"

namespace wedgesim::model {
namespace {

// The example of docs/block.md: memory with one open row of 2048 bytes.
class OneRow final : public sc_core::sc_module {
 public:
  explicit OneRow(sc_core::sc_module_name name) : sc_module(name), socket("socket") {
    socket.register_b_transport(this, &OneRow::transport);
  }

  tlm_utils::simple_target_socket<OneRow> socket;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const std::uint64_t row = payload.get_address() / 2048;
    delay += units::cycles_to_time(row == open_row_ ? 20 : 60);
    open_row_ = row;
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  std::uint64_t open_row_ = 0;
};

/// Takes 60 cycles of SystemC's time, row or not; never answers reads of z if asked not to.
class Waiting final : public sc_core::sc_module {
 public:
  Waiting(sc_core::sc_module_name name, bool answers)
      : sc_module(name), socket("socket"), answers_(answers) {
    socket.register_b_transport(this, &Waiting::transport);
  }

  tlm_utils::simple_target_socket<Waiting> socket;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const bool z = payload.get_address() >= 4096 && payload.get_address() < 8192;
    if (z && !answers_) sc_core::wait(never_);
    sc_core::wait(delay + units::cycles_to_time(60));
    delay = sc_core::SC_ZERO_TIME;
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  bool answers_;
  sc_core::sc_event never_;
};

/// Annotates that its first read of z takes 8 million cycles.
class Slow final : public sc_core::sc_module {
 public:
  explicit Slow(sc_core::sc_module_name name) : sc_module(name), socket("socket") {
    socket.register_b_transport(this, &Slow::transport);
  }

  tlm_utils::simple_target_socket<Slow> socket;
  static constexpr memory::Cycle kCycles = 8'000'000;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    if (payload.get_address() == 4096) delay += units::cycles_to_time(kCycles);
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

template <typename Target, typename... Arguments>
BlockOptions with_target(units::Timing timing, Arguments... arguments) {
  BlockOptions options;
  options.timing = timing;
  options.target = [=](units::MemoryPort& port) {
    auto target = std::make_unique<Target>("target", arguments...);
    port.socket.bind(target->socket);
    return target;
  };
  return options;
}

// Twenty wedges, each in every tile.
RecordedFrame frame() {
  using units::test::block_work;
  using units::test::walked_tile;
  std::vector<units::PrimitiveWork> works;
  for (std::uint32_t i = 0; i < 20; ++i) {
    works.push_back(*units::test::wedge_work(
        i, {walked_tile(0, {block_work(0, 0, 255)}), walked_tile(3, {block_work(1, 1, 255)})}));
  }
  return test::frame_of(works);
}

struct Target : testing::TestWithParam<units::Timing> {};

TEST_P(Target, OnesOwnStandsBehindTheBlock) {
  BlockConfig config;
  config.z_read.cache.size_bytes = 0;
  const BlockResult own = run_block(frame(), config, with_target<OneRow>(GetParam()));
  config.memory.ideal.latency_cycles = 60;
  const BlockResult ideal = run_block(frame(), config);
  EXPECT_EQ(own.port_bytes(), ideal.port_bytes());
  EXPECT_LT(own.cycles, ideal.cycles + 60);
  EXPECT_NE(own.cycles, ideal.cycles);
  EXPECT_TRUE(own.memory.empty());
}

// Each access holds its unit: the 2 lines of 20 records alone take 40 * 60 cycles.
TEST_P(Target, OneThatWaitsHoldsItsUnits) {
  const BlockResult result = run_block(frame(), {}, with_target<Waiting>(GetParam(), true));
  EXPECT_GT(result.cycles, 40U * 60);
  for (const UnitResult& unit : result.units) {
    EXPECT_EQ(unit.busy + unit.starved + unit.stalled, result.cycles) << unit.name;
  }
  EXPECT_EQ(result.units[0].memory, 40U * 60);
}

// z_read never gets its first line. Of the 40 tiles two queues of 8 and tile_cull's hands hold 17;
// behind them the setup of 12 cycles a wedge.
TEST_P(Target, OneThatNeverAnswersIsNamedWithTheQueuesThatWait) {
  BlockOptions options = with_target<Waiting>(GetParam(), false);
  options.watchdog_cycles = 5000;
  std::string message;
  testing::internal::CaptureStdout();
  try {
    run_block(frame(), {}, options);
  } catch (const SimulationError& error) {
    message = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  for (const char* part :
       {"the block is blocked at cycle ", "memory has not answered z at 0x1000 since cycle ",
        "queue tile_cull to z_read holds 8 of 8, held by z_read", "tile_cull waits",
        "li_update waits"}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }
  // And the next run is none the worse.
  EXPECT_EQ(run_block(frame(), {}).cycles, run_block(frame(), {}).cycles);
}

// Whoever waits for a cycle that is known is not blocked, and the kernel has nothing to say.
TEST_P(Target, OneThatTakesItsTimeIsWaitedFor) {
  testing::internal::CaptureStdout();
  BlockOptions options = with_target<Slow>(GetParam());
  options.watchdog_cycles = Slow::kCycles / 8;
  const BlockResult result = run_block(frame(), {}, options);
  EXPECT_GT(result.cycles, Slow::kCycles);
  EXPECT_LT(result.cycles, Slow::kCycles + 1000);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

INSTANTIATE_TEST_SUITE_P(, Target,
                         testing::Values(units::Timing::decoupled, units::Timing::clocked),
                         [](const auto& test) {
                           return test.param == units::Timing::clocked ? "clocked" : "decoupled";
                         });

}  // namespace
}  // namespace wedgesim::model

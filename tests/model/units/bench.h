#pragma once

#include <gtest/gtest.h>
#include <tlm_utils/simple_target_socket.h>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "model/block/scoped_simulation.h"
#include "model/units/block_unit.h"
#include "model/units/memory_port.h"

namespace wedgesim::model::units::test {

/// A memory whose every access takes what the test says.
class FakeMemory final : public sc_core::sc_module {
 public:
  struct Access {
    Cycle cycle;
    std::uint64_t address;
    bool write;
    bool operator==(const Access&) const = default;
  };

  explicit FakeMemory(sc_core::sc_module_name name) : sc_module(name), socket("socket") {
    socket.register_b_transport(this, &FakeMemory::transport);
  }

  tlm_utils::simple_target_socket<FakeMemory> socket;
  std::function<Cycle(std::uint64_t address)> latency = [](std::uint64_t) { return Cycle{10}; };
  std::vector<Access> accesses;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    accesses.push_back(
        {cycle_at(sc_core::sc_time_stamp() + delay), payload.get_address(), payload.is_write()});
    delay += cycles_to_time(latency(payload.get_address()));
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

/// Pushes items, each not before its cycle.
template <typename Item>
class Source final : public BlockUnit {
 public:
  Source(sc_core::sc_module_name name, Timing timing, Link<Item>& out,
         std::vector<std::pair<Cycle, Item>> items)
      : BlockUnit(name, timing), out_(out), items_(std::move(items)) {}

  std::vector<Cycle> pushed;  // cycles

 private:
  void process() override {
    for (auto& [cycle, item] : items_) {
      time_.starve_until(cycle);
      out_.push(time_, item);
      pushed.push_back(time_.now());
    }
  }

  Link<Item>& out_;
  std::vector<std::pair<Cycle, Item>> items_;
};

/// Pops some items and works on each for a while, from a cycle on.
template <typename Item>
class Sink final : public BlockUnit {
 public:
  Sink(sc_core::sc_module_name name, Timing timing, Link<Item>& in, std::size_t count,
       Cycle hold = 0, Cycle from = 0)
      : BlockUnit(name, timing), in_(in), left_(count), hold_(hold), from_(from) {}

  std::vector<Item> items;
  std::vector<Cycle> popped;  // cycles

 private:
  void process() override {
    time_.work(from_);
    for (; left_ > 0; --left_) {
      items.push_back(in_.pop(time_));
      popped.push_back(time_.now());
      time_.work(hold_);
    }
  }

  Link<Item>& in_;
  std::size_t left_;
  Cycle hold_, from_;
};

/// Runs what a test does with a unit's time, in a process.
class Actor final : public BlockUnit {
 public:
  Actor(sc_core::sc_module_name name, Timing timing, std::function<void(UnitTime&)> action)
      : BlockUnit(name, timing), action_(std::move(action)) {}

 private:
  void process() override { action_(time_); }
  std::function<void(UnitTime&)> action_;
};

/// What a unit with a memory needs around it: a frame of 16x16 pixels and records of 4096 bytes.
/// Surfaces begin at 0 (records), 4096 (z), 8192 (LI), 12288 (stencil), 16384 (tile depths).
struct Surroundings {
  explicit Surroundings(int tile = 8) : layout(config(tile)) { port.socket.bind(memory.socket); }

  static memory::LayoutConfig config(int tile) {
    memory::LayoutConfig layout;
    layout.width = 16;
    layout.height = 16;
    layout.tile = tile;
    layout.wedge_bytes = 4096;
    return layout;
  }

  ScopedSimulation simulation;
  FakeMemory memory{"memory"};
  MemoryPort port{"port"};
  memory::Layout layout;
};

/// The value of a unit's counter.
inline std::uint64_t statistic(const BlockUnit& unit, std::string_view name) {
  for (const Counter* counter : unit.statistics().counters()) {
    if (counter->name() == name) return counter->value();
  }
  ADD_FAILURE() << "no statistic " << name;
  return 0;
}

/// A test that is run with decoupled and with clocked units.
class BothTimings : public testing::TestWithParam<Timing> {};

inline std::string timing_name(const testing::TestParamInfo<Timing>& info) {
  return info.param == Timing::clocked ? "clocked" : "decoupled";
}

}  // namespace wedgesim::model::units::test

#define WEDGESIM_BOTH_TIMINGS(suite)                                                  \
  INSTANTIATE_TEST_SUITE_P(, suite,                                                   \
                           testing::Values(wedgesim::model::units::Timing::decoupled, \
                                           wedgesim::model::units::Timing::clocked),  \
                           wedgesim::model::units::test::timing_name)

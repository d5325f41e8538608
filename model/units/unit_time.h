#pragma once

#include <functional>
#include <systemc>

#include "base/counter.h"
#include "model/memory/cycle.h"
#include "model/units/critical_path.h"
#include "model/units/unit_state.h"

namespace wedgesim::model::units {

using memory::Cycle;

/// How the units keep time.
enum class Timing {
  /// Each unit runs ahead on a time of its own; links carry the times of their items, and a unit
  /// waits for the kernel only before it touches memory (temporal decoupling).
  decoupled,
  /// Every unit waits for every cycle: the witness.
  clocked,
};

/// Cycles in SystemC's time: one lasts a nanosecond, a thousand of the kernel's default resolution;
/// the clock's frequency matters outside the block alone.
inline constexpr Cycle kResolutionsPerCycle = 1000;
inline sc_core::sc_time cycles_to_time(Cycle cycles) {
  return sc_core::sc_time::from_value(kResolutionsPerCycle * cycles);
}
/// Whole cycles of a duration in the kernel's resolution, rounded up: what is done within a cycle
/// is there at its end.
inline Cycle whole_cycles(std::uint64_t duration) {
  return (duration + kResolutionsPerCycle - 1) / kResolutionsPerCycle;
}
/// The cycle that a point in time lies in.
inline Cycle cycle_at(const sc_core::sc_time& time) { return time.value() / kResolutionsPerCycle; }
inline Cycle kernel_cycle() { return cycle_at(sc_core::sc_time_stamp()); }

/// A unit's own time. Every cycle of it is exactly one of busy, starved and stalled.
class UnitTime {
 public:
  UnitTime(Timing timing, Group& statistics) : timing_(timing), statistics_(statistics) {}

  Timing timing() const { return timing_; }
  Cycle now() const { return now_; }
  /// Works for some cycles.
  void work(Cycle cycles) {
    account(CriticalPath::Part::work, cycles);
    advance(cycles, UnitState::busy, busy_);
  }
  /// Has nothing to work on until a cycle.
  void starve_until(Cycle cycle) {
    advance_to(cycle, UnitState::starved, starved_, CriticalPath::Part::queue);
  }
  /// Cannot hand on, or must wait for its own earlier work, until a cycle.
  void stall_until(Cycle cycle) {
    advance_to(cycle, UnitState::stalled, stalled_, CriticalPath::Part::work);
  }
  /// Waits, stalled, for bytes from memory.
  void wait_for_memory_until(Cycle cycle) {
    if (cycle > now_) memory_ += cycle - now_;
    advance_to(cycle, UnitState::stalled, stalled_, CriticalPath::Part::memory);
  }
  /// Memory has held the unit for some cycles, in which the kernel has gone on already.
  void was_held(Cycle cycles) {
    stalled_ += cycles;
    memory_ += cycles;
    account(CriticalPath::Part::memory, cycles);
    if (listener_) listener_(UnitState::stalled, now_, now_ + cycles);
    now_ += cycles;
  }
  /// Lets everything that happens before this unit's time happen first. The kernel may stay behind
  /// if nothing else is due until then.
  /// \param turn  the unit's place among those that sync in one cycle, less than
  ///              kResolutionsPerCycle
  /// \return      the time it then is for the unit, in the kernel's resolution: its cycle and its
  ///              turn, or later
  std::uint64_t sync(unsigned turn) const {
    const std::uint64_t own = kResolutionsPerCycle * now_ + turn;
    const std::uint64_t kernel = sc_core::sc_time_stamp().value();
    if (own <= kernel) return kernel;
    if (sc_core::sc_time_to_pending_activity().value() <= own - kernel) {
      sc_core::wait(sc_core::sc_time::from_value(own - kernel));
    }
    return own;
  }

  /// Calls `listener` for the cycles [begin, end) that the unit spends in a state, from now on.
  void listen(std::function<void(UnitState state, Cycle begin, Cycle end)> listener) {
    listener_ = std::move(listener);
    alone_ = false;
  }

  /// What the unit's cycles so far waited for; adds up to now().
  const CriticalPath& path() const { return path_; }
  /// It has waited for something whose account this is; `more` cycles of them in a queue.
  void follow(const CriticalPath& path, Cycle more = 0) {
    path_ = path;
    account(CriticalPath::Part::queue, more);
  }
  /// The unit's place in the pipeline, less than CriticalPath::kUnits.
  void place_at(std::size_t place) { place_ = place; }
  std::size_t place() const { return place_; }

  Cycle busy() const { return busy_.value(); }
  Cycle starved() const { return starved_.value(); }
  Cycle stalled() const { return stalled_.value(); }
  /// Of the stalled cycles, those that waited for memory.
  Cycle memory() const { return memory_.value(); }

 private:
  void account(CriticalPath::Part part, Cycle cycles) { path_.add(place_, part, cycles); }
  void advance_to(Cycle cycle, UnitState state, Counter& counter, CriticalPath::Part part) {
    if (cycle <= now_) return;
    account(part, cycle - now_);
    advance(cycle - now_, state, counter);
  }
  void advance(Cycle cycles, UnitState state, Counter& counter) {
    counter += cycles;
    if (alone_) {
      now_ += cycles;
    } else {
      advance_seen(cycles, state);
    }
  }
  // With someone who listens, or with the kernel.
  void advance_seen(Cycle cycles, UnitState state) {
    if (listener_) listener_(state, now_, now_ + cycles);
    if (timing_ == Timing::decoupled) {
      now_ += cycles;
      return;
    }
    for (; cycles > 0; --cycles) {
      ++now_;
      const sc_core::sc_time own = cycles_to_time(now_);
      if (own > sc_core::sc_time_stamp()) sc_core::wait(own - sc_core::sc_time_stamp());
    }
  }

  Timing timing_;
  bool alone_ = timing_ == Timing::decoupled;  // neither kernel nor listener follows each cycle
  Group& statistics_;
  std::function<void(UnitState, Cycle, Cycle)> listener_;
  Cycle now_ = 0;
  std::size_t place_ = 0;
  CriticalPath path_;
  Counter busy_{statistics_, "busy_cycles", Unit::cycles, "Cycles at work"};
  Counter starved_{statistics_, "starved_cycles", Unit::cycles, "Cycles without input"};
  Counter stalled_{statistics_, "stalled_cycles", Unit::cycles, "Cycles held up by what follows"};
  Counter memory_{statistics_, "memory_cycles", Unit::cycles, "Of them, cycles held up by memory"};
};

}  // namespace wedgesim::model::units

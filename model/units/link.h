#pragma once

#include <algorithm>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

#include "model/units/unit_time.h"

namespace wedgesim::model::units {

struct LinkConfig {
  int depth = 8;           // items, 1 to 1024
  int latency_cycles = 1;  // from one unit to the next, 1 to 1024
};

/// A queue from one unit to the next, with backpressure.
///
/// An item pushed in cycle t can be taken from t + latency on, or from when it is ready if that is
/// later; items keep their order. A slot that is freed in cycle t can be filled from t + 1 on. Both
/// rules look at earlier cycles alone, so the order of the units within a cycle does not matter,
/// and decoupled and clocked units see the same.
template <typename Item>
class Link {
 public:
  Link(std::string name, const LinkConfig& config)
      : name_(std::move(name)),
        depth_(static_cast<std::size_t>(config.depth)),
        latency_(static_cast<Cycle>(config.latency_cycles)),
        pop_times_(depth_),
        items_(depth_) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Called by the producer: waits for a slot, stalled.
  /// \param ready  the first cycle in which the item's data are there
  void push(UnitTime& time, Item item, Cycle ready = 0) {
    if (time.timing() == Timing::clocked) {
      while (full() || slot_free() > time.now()) time.stall_until(time.now() + 1);
    } else {
      while (full()) wait_for(popped_event_, producer_waits_);
      time.stall_until(slot_free());
    }
    last_visible_ = std::max({last_visible_, time.now() + latency_, ready});
    items_[pushed_ % depth_] = {last_visible_, std::move(item)};
    ++pushed_;
    if (consumer_waits_) pushed_event_.notify();
  }

  /// Called by the consumer: waits for an item, starved.
  Item pop(UnitTime& time) {
    const Entry& front = items_[popped_ % depth_];
    if (time.timing() == Timing::clocked) {
      while (empty() || front.visible > time.now()) time.starve_until(time.now() + 1);
    } else {
      while (empty()) wait_for(pushed_event_, consumer_waits_);
      time.starve_until(front.visible);
    }
    pop_times_[popped_ % depth_] = time.now();
    Item item = std::move(items_[popped_ % depth_].item);
    ++popped_;
    if (producer_waits_) popped_event_.notify();
    return item;
  }

  const std::string& name() const { return name_; }
  std::size_t depth() const { return depth_; }
  std::size_t size() const { return pushed_ - popped_; }
  std::size_t pushed() const { return pushed_; }

 private:
  struct Entry {
    Cycle visible;
    Item item;
  };
  bool full() const { return size() >= depth_; }
  bool empty() const { return size() == 0; }
  static void wait_for(const sc_core::sc_event& event, bool& waits) {
    waits = true;
    sc_core::wait(event);
    waits = false;
  }
  // The first cycle in which the next push finds its slot free.
  Cycle slot_free() const { return pushed_ < depth_ ? 0 : pop_times_[pushed_ % depth_] + 1; }

  std::string name_;
  std::size_t depth_;
  Cycle latency_;
  std::vector<Cycle> pop_times_;  // of the last `depth` items, by their number modulo depth
  std::vector<Entry> items_;      // number n at n modulo depth
  Cycle last_visible_ = 0;
  std::size_t pushed_ = 0, popped_ = 0;
  bool producer_waits_ = false, consumer_waits_ = false;
  sc_core::sc_event pushed_event_, popped_event_;
};

}  // namespace wedgesim::model::units

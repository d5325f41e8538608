#pragma once

#include <algorithm>
#include <bit>
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

/// A unit that works when the one before or behind it cannot go on without, on that one's thread.
class OnDemand {
 public:
  virtual ~OnDemand() = default;
  /// Works as far as its links allow. \return whether it did anything
  virtual bool work_ahead() = 0;
  /// Waits, in the kernel, until there may be something to work on.
  virtual void wait_for_input() = 0;
  /// Does a unit before this one wait for a slot?
  virtual bool is_awaited() const = 0;
};

/// A queue from one unit to the next, with backpressure.
///
/// An item pushed in cycle t can be taken from t + latency on, or from when it is ready if that is
/// later (its consumer then waits for memory); items keep their order. A slot that is freed in
/// cycle t can be filled from t + 1 on. Both rules look at earlier cycles alone, so the order of
/// the units within a cycle does not matter, and decoupled and clocked units see the same.
template <typename Item>
class Link {
 public:
  Link(std::string name, const LinkConfig& config)
      : name_(std::move(name)),
        depth_(static_cast<std::size_t>(config.depth)),
        latency_(static_cast<Cycle>(config.latency_cycles)),
        mask_(std::bit_ceil(depth_) - 1),
        pop_times_(mask_ + 1),
        pop_paths_(mask_ + 1),
        items_(mask_ + 1) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Decoupled: the producer, or the consumer, works on demand.
  void produced_by(OnDemand& unit) { producer_ = &unit; }
  void consumed_by(OnDemand& unit) { consumer_ = &unit; }

  /// Called by the producer: waits for a slot, stalled.
  /// \param ready  the first cycle in which the item's data are there
  void push(UnitTime& time, Item item, Cycle ready = 0) {
    const Cycle before = time.now();
    if (time.timing() == Timing::clocked) {
      while (full() || slot_free() > time.now()) time.stall_until(time.now() + 1);
    } else {
      while (!has_room()) wait_for(popped_event_, producer_waits_);
      time.stall_until(slot_free());
    }
    if (time.now() > before) time.follow(pop_paths_[(pushed_ - depth_) & mask_], 1);
    const Cycle arrives = time.now() + latency_;
    last_visible_ = std::max({last_visible_, arrives, ready});
    Entry& entry = items_[pushed_ & mask_];
    entry = {arrives, last_visible_, std::move(item), time.path()};
    entry.path.add(time.place(), CriticalPath::Part::queue, latency_);
    entry.path.add(time.place(), CriticalPath::Part::memory, last_visible_ - arrives);
    ++pushed_;
    if (consumer_waits_) pushed_event_.notify();
  }

  /// Called by the consumer: waits for an item, starved, then for its data, stalled.
  Item pop(UnitTime& time) {
    const Cycle before = time.now();
    const Entry& front = items_[popped_ & mask_];
    if (time.timing() == Timing::clocked) {
      while (empty() || front.arrives > time.now()) time.starve_until(time.now() + 1);
    } else {
      while (!has_item()) wait_for_item();
      time.starve_until(front.arrives);
    }
    time.wait_for_memory_until(front.visible);
    if (time.now() > before) time.follow(front.path);
    pop_times_[popped_ & mask_] = time.now();
    pop_paths_[popped_ & mask_] = time.path();
    Item item = std::move(items_[popped_ & mask_].item);
    ++popped_;
    if (producer_waits_) popped_event_.notify();
    // Else a slot before the producer would be free too late for who waits for it.
    if (producer_ != nullptr && producer_->is_awaited()) producer_->work_ahead();
    return item;
  }

  /// Decoupled: is there an item, or can one be made? It may be visible later only.
  bool has_item() {
    while (empty()) {
      if (producer_ == nullptr || !producer_->work_ahead()) return false;
    }
    return true;
  }
  /// Decoupled: waits, in the kernel, until there may be one.
  void wait_for_item() {
    if (producer_ != nullptr) {
      producer_->wait_for_input();
    } else {
      wait_for(pushed_event_, consumer_waits_);
    }
  }
  /// Decoupled: is a slot free, or can one be made?
  bool has_room() {
    while (full()) {
      if (consumer_ == nullptr || !consumer_->work_ahead()) return false;
    }
    return true;
  }
  /// Does the producer, or one before it, wait for a slot?
  bool is_awaited() const {
    return producer_waits_ || (producer_ != nullptr && producer_->is_awaited());
  }

  const std::string& name() const { return name_; }
  std::size_t depth() const { return depth_; }
  std::size_t size() const { return pushed_ - popped_; }
  std::size_t pushed() const { return pushed_; }

 private:
  struct Entry {
    Cycle arrives = 0, visible = 0;  // without its data, and with them
    Item item{};
    CriticalPath path;  // up to `visible`
  };
  bool full() const { return size() >= depth_; }
  bool empty() const { return size() == 0; }
  static void wait_for(const sc_core::sc_event& event, bool& waits) {
    waits = true;
    sc_core::wait(event);
    waits = false;
  }
  // The first cycle in which the next push finds its slot free.
  Cycle slot_free() const {
    return pushed_ < depth_ ? 0 : pop_times_[(pushed_ - depth_) & mask_] + 1;
  }

  std::string name_;
  std::size_t depth_;
  Cycle latency_;
  std::size_t mask_;                     // a power of two that holds `depth` items, less one
  std::vector<Cycle> pop_times_;         // of the last items, number n at n & mask
  std::vector<CriticalPath> pop_paths_;  // the same
  std::vector<Entry> items_;             // the same
  Cycle last_visible_ = 0;
  std::size_t pushed_ = 0, popped_ = 0;
  OnDemand* producer_ = nullptr;
  OnDemand* consumer_ = nullptr;
  bool producer_waits_ = false, consumer_waits_ = false;
  sc_core::sc_event pushed_event_, popped_event_;
};

}  // namespace wedgesim::model::units

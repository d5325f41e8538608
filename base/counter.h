#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace wedgesim {

/// What one count of a counter is.
enum class Unit { accesses, pixels, visits, words, bytes, tiles, wedges, cycles };
std::string_view name_of(Unit unit);

class Counter;

/// The counters of one unit or run, in the order of their declaration. Reset, text, JSON and
/// comparison walk this list, so a new counter appears everywhere with no further edit.
class Group {
 public:
  Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;

  const std::vector<Counter*>& counters() const { return counters_; }
  void reset();

 private:
  friend class Counter;
  std::vector<Counter*> counters_;
};

/// One number that grows; declares, registers, names its unit and documents itself in one line:
///   Counter z_reads{group, "z_reads", Unit::accesses, "Words read from the z-buffer"};
class Counter {
 public:
  Counter(Group& group, std::string_view name, Unit unit, std::string_view description)
      : name_(name), description_(description), unit_(unit) {
    group.counters_.push_back(this);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  Counter& operator+=(std::uint64_t n) {
    value_ += n;
    return *this;
  }
  Counter& operator=(std::uint64_t n) {
    value_ = n;
    return *this;
  }
  std::uint64_t value() const { return value_; }
  std::string_view name() const { return name_; }
  std::string_view description() const { return description_; }
  Unit unit() const { return unit_; }

 private:
  std::string_view name_;
  std::string_view description_;
  Unit unit_;
  std::uint64_t value_ = 0;
};

}  // namespace wedgesim

#pragma once

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/units/unit_state.h"

namespace wedgesim::reports {

/// What the units do over a window of cycles, for people to look at.
class Timeline {
 public:
  using State = model::units::UnitState;
  struct Span {
    State state;
    std::uint64_t begin, end;  // cycles, half open
  };

  /// \param from, to  the window in cycles, half open
  /// \param units     a track each, in this order
  Timeline(std::uint64_t from, std::uint64_t to, std::span<const std::string_view> units);

  /// One of the units is in a state for some cycles; in the order of its time.
  void add(std::string_view unit, State state, std::uint64_t begin, std::uint64_t end);

  /// Chrome's trace event format, which Perfetto reads: a track a unit, a microsecond a cycle;
  /// starved cycles are gaps.
  void write_chrome(std::ostream& out) const;
  /// A value change dump: a unit's state is two bits, 0 starved, 1 busy, 2 stalled; a nanosecond a
  /// cycle.
  void write_vcd(std::ostream& out) const;

  /// Neighbouring spans of one state are one.
  const std::vector<Span>& spans(std::string_view unit) const;

 private:
  struct Track {
    std::string unit;
    std::vector<Span> spans;
  };
  std::uint64_t from_, to_;
  std::vector<Track> tracks_;
};

}  // namespace wedgesim::reports

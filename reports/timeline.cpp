#include "reports/timeline.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <tuple>

#include "base/check.h"

namespace wedgesim::reports {
namespace {

constexpr std::array<std::string_view, 3> kNames{"busy", "starved", "stalled"};
constexpr std::array<std::string_view, 3> kVcdValues{"01", "00", "10"};

}  // namespace

Timeline::Timeline(std::uint64_t from, std::uint64_t to, std::span<const std::string_view> units)
    : from_(from), to_(to) {
  for (const std::string_view unit : units) tracks_.push_back({std::string(unit), {}});
}

void Timeline::add(std::string_view unit, State state, std::uint64_t begin, std::uint64_t end) {
  begin = std::max(begin, from_);
  end = std::min(end, to_);
  if (begin >= end) return;
  const auto track = std::find_if(tracks_.begin(), tracks_.end(),
                                  [&](const Track& each) { return each.unit == unit; });
  CHECK_EQ(track == tracks_.end(), false);
  std::vector<Span>& spans = track->spans;
  if (!spans.empty() && spans.back().state == state && spans.back().end == begin) {
    spans.back().end = end;
  } else {
    spans.push_back({state, begin, end});
  }
}

const std::vector<Timeline::Span>& Timeline::spans(std::string_view unit) const {
  static const std::vector<Span> none;
  for (const Track& track : tracks_) {
    if (track.unit == unit) return track.spans;
  }
  return none;
}

void Timeline::write_chrome(std::ostream& out) const {
  out << "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[";
  std::string_view separator = "\n";
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    fmt::print(
        out,
        "{0}{{\"ph\":\"M\",\"pid\":1,\"tid\":{1},\"name\":\"thread_name\",\"args\":{{\"name\":"
        "\"{2}\"}}}},\n"
        "{{\"ph\":\"M\",\"pid\":1,\"tid\":{1},\"name\":\"thread_sort_index\",\"args\":{{"
        "\"sort_index\":{1}}}}}",
        separator, i + 1, tracks_[i].unit);
    separator = ",\n";
    for (const Span& span : tracks_[i].spans) {
      if (span.state == State::starved) continue;
      fmt::print(out,
                 "{}{{\"ph\":\"X\",\"pid\":1,\"tid\":{},\"name\":\"{}\",\"ts\":{},\"dur\":{}}}",
                 separator, i + 1, kNames[static_cast<std::size_t>(span.state)], span.begin,
                 span.end - span.begin);
    }
  }
  out << "\n]}\n";
}

void Timeline::write_vcd(std::ostream& out) const {
  out << "$timescale 1 ns $end\n$scope module block $end\n";
  std::vector<std::tuple<std::uint64_t, std::size_t, State>> changes;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    fmt::print(out, "$var wire 2 {} {} $end\n", static_cast<char>('!' + i), tracks_[i].unit);
    const std::vector<Span>& spans = tracks_[i].spans;
    if (spans.empty() || spans.front().begin != from_) {
      changes.emplace_back(from_, i, State::starved);
    }
    for (std::size_t k = 0; k < spans.size(); ++k) {
      changes.emplace_back(spans[k].begin, i, spans[k].state);
      if (k + 1 == spans.size() || spans[k + 1].begin != spans[k].end) {
        changes.emplace_back(spans[k].end, i, State::starved);
      }
    }
  }
  out << "$upscope $end\n$enddefinitions $end\n";
  std::stable_sort(changes.begin(), changes.end(),
                   [](const auto& a, const auto& b) { return std::get<0>(a) < std::get<0>(b); });
  std::uint64_t now = to_;
  for (const auto& [cycle, track, state] : changes) {
    if (cycle != now) fmt::print(out, "#{}\n", cycle);
    now = cycle;
    fmt::print(out, "b{} {}\n", kVcdValues[static_cast<std::size_t>(state)],
               static_cast<char>('!' + track));
  }
}

}  // namespace wedgesim::reports

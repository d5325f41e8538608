#include "reports/timeline.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <tuple>

namespace wedgesim::reports {
namespace {

constexpr std::array<std::string_view, 3> kNames{"busy", "starved", "stalled"};
constexpr std::array<std::string_view, 3> kVcdValues{"01", "00", "10"};

}  // namespace

void Timeline::add(std::string_view unit, State state, std::uint64_t begin, std::uint64_t end) {
  begin = std::max(begin, from_);
  end = std::min(end, to_);
  if (begin >= end) return;
  auto track = std::find_if(tracks_.begin(), tracks_.end(),
                            [&](const Track& each) { return each.unit == unit; });
  if (track == tracks_.end()) track = tracks_.insert(track, {std::string(unit), {}});
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
    fmt::print(out,
               "{}{{\"ph\":\"M\",\"pid\":1,\"tid\":{},\"name\":\"thread_name\",\"args\":{{\"name\":"
               "\"{}\"}}}}",
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

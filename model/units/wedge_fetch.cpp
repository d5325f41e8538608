#include "model/units/wedge_fetch.h"

#include <algorithm>

namespace wedgesim::model::units {

WedgeFetch::WedgeFetch(sc_core::sc_module_name name, Timing timing, const WedgeFetchConfig& config,
                       Source source, MemoryPort& port, const memory::Layout& layout,
                       Link<Token>& out)
    : BlockUnit(name, timing),
      source_(std::move(source)),
      port_(port),
      layout_(layout),
      out_(out),
      outstanding_(config.outstanding) {}

void WedgeFetch::drained(Cycle cycle, const CriticalPath& path) {
  is_drained_ = true;
  drained_at_ = cycle;
  drained_path_ = path;
  drained_event_.notify();
}

void WedgeFetch::process() {
  while (const PrimitiveWork* primitive = source_()) {
    if (primitive->barrier) {
      out_.push(time_, {Token::Kind::barrier, 0, nullptr});
      wait_until_drained();
    }
    const Cycle ready = fetch(*primitive);
    const auto kind = primitive->merged.empty() ? Token::Kind::work : Token::Kind::merge;
    out_.push(time_, {kind, 0, primitive}, ready);
  }
  out_.push(time_, {Token::Kind::end, 0, nullptr});
}

Cycle WedgeFetch::fetch(const PrimitiveWork& primitive) {
  if (primitive.record_bytes == 0) {
    time_.work(1);
    return 0;
  }
  Cycle ready = 0;
  bool fetched = false;
  const std::uint64_t begin = layout_.wedge_address(primitive.record_offset);
  const std::uint64_t end = begin + primitive.record_bytes;
  const AccessTag tag{memory::Surface::wedges, memory::Cause::fetch,
                      primitive.wedge ? static_cast<std::int64_t>(*primitive.wedge) : -1, -1};
  for (std::uint64_t line = begin & ~std::uint64_t{memory::kLineBytes - 1}; line < end;
       line += memory::kLineBytes) {
    if (line != last_line_) {  // else it came with the record before
      last_line_ = line;
      time_.work(1);
      outstanding_.wait_for_one(time_);
      last_ready_ = port_.access(time_, tag, line, memory::kLineBytes, false);
      outstanding_.add(last_ready_);
      lines_ += 1;
      fetched = true;
    }
    ready = std::max(ready, last_ready_);  // a memory may answer out of order
  }
  if (!fetched) time_.work(1);
  return ready;
}

void WedgeFetch::wait_until_drained() {
  const Cycle before = time_.now();
  if (time_.timing() == Timing::clocked) {
    while (!is_drained_ || drained_at_ >= time_.now()) time_.starve_until(time_.now() + 1);
  } else {
    while (!is_drained_) sc_core::wait(drained_event_);
    time_.starve_until(drained_at_ + 1);
  }
  if (time_.now() > before) time_.follow(drained_path_, 1);
  is_drained_ = false;
}

}  // namespace wedgesim::model::units

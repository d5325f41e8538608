#include "model/units/li_update.h"

#include <algorithm>

namespace wedgesim::model::units {

using memory::Cause;
using memory::Surface;

LiUpdate::WriteBackCache::WriteBackCache(const memory::CacheConfig& config, std::string_view place)
    : cache(config, place),
      writers(cache.size_bytes() / memory::kLineBytes, {Surface::li, Cause::fill}) {}

LiUpdate::LiUpdate(sc_core::sc_module_name name, Timing timing, const LiUpdateConfig& config,
                   bool three_pass, MemoryPort& port, const memory::Layout& layout, Link<Token>& in)
    : BlockUnit(name, timing),
      config_(config),
      three_pass_(three_pass),
      port_(port),
      layout_(layout),
      in_(in),
      li_(config.cache, "li_update"),
      stencil_(config.stencil_cache, "li_update.stencil"),
      outstanding_(config.outstanding),
      outstanding_writes_(config.outstanding_writes),
      update_cycles_(static_cast<Cycle>(config.update_cycles)) {}

void LiUpdate::process() {
  if (config_.clear == Clear::write) {
    clear(Surface::li);
    if (three_pass_) clear(Surface::stencil);
  }
  for (;;) {
    const Token token = in_.pop(time_);
    switch (token.kind) {
      case Token::Kind::work:
        work(token);
        break;
      case Token::Kind::merge:
        merge(*token.primitive);
        break;
      case Token::Kind::barrier:
        drain();
        drained_(time_.now(), time_.path());
        break;
      case Token::Kind::end:
        flush();
        return;
    }
  }
}

void LiUpdate::clear(Surface surface) {
  const std::uint64_t end = layout_.base(surface) + layout_.bytes(surface);
  for (std::uint64_t line = layout_.base(surface); line < end; line += memory::kLineBytes) {
    time_.work(1);
    send({surface, Cause::clear}, Cause::clear, line);
  }
}

void LiUpdate::work(const Token& token) {
  const TileWork& tile = token.work();
  bool writes = false;
  for (const BlockWork& block : token.blocks()) {
    const std::uint64_t umbra = three_pass_ ? block.umbra_writes : 0;
    const std::uint64_t li = block.writes | (block.umbra_writes & ~umbra);
    if (umbra != 0) update(Surface::stencil, block, umbra, token, tile.tile);
    if (li != 0) update(Surface::li, block, li, token, tile.tile);
    // Unshared, a pixel of both polygons is updated twice.
    const std::uint64_t twice = tile.shared || three_pass_ ? 0 : block.writes & block.umbra_writes;
    if (twice != 0) update(Surface::li, block, twice, token, tile.tile);
    writes = writes || (umbra | li) != 0;
  }
  if (!writes) time_.work(1);
}

void LiUpdate::update(Surface surface, const BlockWork& block, std::uint64_t pixels,
                      const Token& token, std::uint32_t tile) {
  const auto key = static_cast<std::uint32_t>(block.by) << 16 | block.bx;
  wait_for_hazard(surface, key, pixels);
  const AccessTag tag{surface, Cause::fill, token.wedge(), static_cast<std::int64_t>(tile)};
  Cycle done = 0;
  for (const std::uint64_t line : layout_.lines(surface, block.bx, block.by, pixels)) {
    time_.work(1);
    done = std::max(done, access(tag, line, true));
    lines_ += 1;
  }
  updates_.push_back({surface, key, pixels, done});
}

void LiUpdate::wait_for_hazard(Surface surface, std::uint32_t block, std::uint64_t pixels) {
  const Cycle before = time_.now();
  std::erase_if(updates_, [before](const Update& update) { return update.done <= before; });
  for (const Update& update : updates_) {
    if (update.surface == surface && update.block == block && (update.pixels & pixels) != 0) {
      time_.wait_for_memory_until(update.done - update_cycles_);
      time_.stall_until(update.done);
    }
  }
  hazards_ += time_.now() - before;
}

void LiUpdate::drain() {
  outstanding_.wait_for_all(time_);
  time_.work(update_cycles_);
}

Cycle LiUpdate::access(const AccessTag& tag, std::uint64_t line, bool write) {
  WriteBackCache& cached = tag.surface == Surface::li ? li_ : stencil_;
  const memory::Cache::Access access = cached.cache.access(line, write);
  if (access.slot == memory::Cache::kNoSlot) return access_uncached(tag, line, write);
  Cycle ready = 0;
  if (access.hit) {
    time_.wait_for_memory_until(cached.cache.ready(access.slot));
    ready = time_.now();
  } else {
    if (access.write_back) {
      time_.wait_for_memory_until(access.write_back_ready);
      time_.stall_until(access.write_back_settled);
      send(cached.writers[access.slot], Cause::write_back, *access.write_back);
    }
    ready = fill(tag, line);
    cached.cache.set_ready(access.slot, ready);
  }
  if (!write) return ready;
  cached.cache.set_settled(access.slot, ready + update_cycles_);
  cached.writers[access.slot] = tag;
  return ready + update_cycles_;
}

// Nothing else would know that the line is on its way: it is waited for.
Cycle LiUpdate::access_uncached(const AccessTag& tag, std::uint64_t line, bool write) {
  time_.wait_for_memory_until(fill(tag, line));
  if (!write) return time_.now();
  time_.stall_until(time_.now() + update_cycles_);
  send(tag, Cause::write_through, line);
  return time_.now();
}

Cycle LiUpdate::fill(const AccessTag& tag, std::uint64_t line) {
  outstanding_.wait_for_one(time_);
  const Cycle done = port_.access(time_, tag, line, memory::kLineBytes, false);
  outstanding_.add(done);
  return done;
}

void LiUpdate::send(AccessTag tag, Cause cause, std::uint64_t line) {
  tag.cause = cause;
  outstanding_writes_.wait_for_one(time_);
  outstanding_writes_.add(port_.access(time_, tag, line, memory::kLineBytes, true));
}

void LiUpdate::merge(const PrimitiveWork& primitive) {
  for (const MergedBlock& block : primitive.merged) {
    for (const std::uint64_t line :
         layout_.lines(Surface::stencil, block.bx, block.by, ~std::uint64_t{0})) {
      time_.work(1);
      access({Surface::stencil, Cause::merge}, line, false);
    }
    if (!block.any) continue;
    for (const std::uint64_t line :
         layout_.lines(Surface::li, block.bx, block.by, ~std::uint64_t{0})) {
      time_.work(1);
      access({Surface::li, Cause::merge}, line, true);
    }
  }
}

void LiUpdate::flush() {
  drain();
  for (WriteBackCache* const cached : {&li_, &stencil_}) {
    cached->cache.flush([&](std::uint64_t line, std::size_t slot) {
      time_.work(1);
      send(cached->writers[slot], Cause::flush, line);
    });
  }
}

}  // namespace wedgesim::model::units

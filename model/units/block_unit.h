#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <systemc>

#include "model/units/frame_walk.h"
#include "model/units/link.h"
#include "model/units/unit_time.h"

namespace wedgesim::model::units {

/// What goes from unit to unit: a primitive, one of its tiles, or a mark that all before it is
/// done.
struct Token {
  enum class Kind : std::uint8_t { work, merge, barrier, end };

  Kind kind = Kind::work;
  std::uint32_t tile = 0;                    // of the primitive's tiles
  const PrimitiveWork* primitive = nullptr;  // of the recorded frame, which outlives the block

  const TileWork& work() const { return primitive->tiles[tile]; }
  std::span<const BlockWork> blocks() const { return primitive->blocks_of(work()); }
  std::int64_t wedge() const {
    return primitive->wedge ? static_cast<std::int64_t>(*primitive->wedge) : -1;
  }
};

/// A unit of the block: a process, a time of its own, and statistics.
class BlockUnit : public sc_core::sc_module {
 public:
  /// \param has_process  else another unit's process runs it
  BlockUnit(sc_core::sc_module_name name, Timing timing, bool has_process = true)
      : sc_module(name), time_(timing, statistics_) {
    SC_HAS_PROCESS(BlockUnit);
    if (has_process) SC_THREAD(run);
  }

  const UnitTime& time() const { return time_; }
  UnitTime& time() { return time_; }
  const Group& statistics() const { return statistics_; }
  bool finished() const { return finished_; }

 protected:
  /// Until the frame is done.
  virtual void process() = 0;
  void finish() { finished_ = true; }

  Group statistics_;
  UnitTime time_;

 private:
  void run() {
    process();
    finish();
  }

  bool finished_ = false;
};

/// A unit that takes tokens, works on those of kind work, and hands all on.
class PipelineUnit : public BlockUnit {
 public:
  PipelineUnit(sc_core::sc_module_name name, Timing timing, Link<Token>& in, Link<Token>& out)
      : BlockUnit(name, timing), in_(in), out_(out) {}

 protected:
  virtual void work(const Token& token) = 0;

  void process() override {
    for (;;) {
      const Token token = in_.pop(time_);
      if (token.kind == Token::Kind::work) {
        work(token);
        continue;
      }
      time_.work(1);
      out_.push(time_, token);
      if (token.kind == Token::Kind::end) return;
    }
  }

  Link<Token>& in_;
  Link<Token>& out_;
};

/// The same for a unit without memory. What it does depends on its two links alone, so decoupled it
/// needs no process: it works when the units beside it ask.
class OnDemandUnit : public BlockUnit, public OnDemand {
 public:
  OnDemandUnit(sc_core::sc_module_name name, Timing timing, Link<Token>& in, Link<Token>& out)
      : BlockUnit(name, timing, timing == Timing::clocked), in_(in), out_(out) {
    if (timing == Timing::clocked) return;
    in.consumed_by(*this);
    out.produced_by(*this);
  }

  bool work_ahead() final {
    if (at_work_) return false;  // a link asks for what is being done
    at_work_ = true;
    bool any = false;
    while (has_token_ ? out_.has_room() : !finished() && in_.has_item()) {
      step();
      any = true;
    }
    at_work_ = false;
    return any;
  }
  void wait_for_input() final { in_.wait_for_item(); }
  bool is_awaited() const final { return in_.is_awaited(); }

 protected:
  /// Works on a token of kind work that was taken, and on one that was handed on. \return whether
  /// there is something to hand on: the token as it is then
  virtual bool begin(Token& token) = 0;
  virtual bool proceed(Token& /*token*/) { return false; }

 private:
  void process() final {
    while (!finished()) step();
  }
  /// Takes a token, or hands on the one there is.
  void step() {
    if (!has_token_) {
      token_ = in_.pop(time_);
      if (token_.kind != Token::Kind::work) time_.work(1);
      has_token_ = token_.kind != Token::Kind::work || begin(token_);
      return;
    }
    out_.push(time_, token_);
    if (token_.kind == Token::Kind::end) finish();
    has_token_ = token_.kind == Token::Kind::work && proceed(token_);
  }

  Link<Token>& in_;
  Link<Token>& out_;
  Token token_;
  bool has_token_ = false;
  bool at_work_ = false;
};

}  // namespace wedgesim::model::units

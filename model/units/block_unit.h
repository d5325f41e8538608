#pragma once

#include <cstdint>
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

  const WalkedTile& walked() const { return primitive->tiles[tile]; }
  std::int64_t wedge() const {
    return primitive->wedge ? static_cast<std::int64_t>(*primitive->wedge) : -1;
  }
};

/// A unit of the block: one process, a time of its own, and statistics.
class BlockUnit : public sc_core::sc_module {
 public:
  BlockUnit(sc_core::sc_module_name name, Timing timing)
      : sc_module(name), time_(timing, statistics_) {
    SC_HAS_PROCESS(BlockUnit);
    SC_THREAD(run);
  }

  const UnitTime& time() const { return time_; }
  UnitTime& time() { return time_; }
  const Group& statistics() const { return statistics_; }
  bool finished() const { return finished_; }

 protected:
  /// Until the frame is done.
  virtual void process() = 0;

  Group statistics_;
  UnitTime time_;

 private:
  void run() {
    process();
    finished_ = true;
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
      Token token = in_.pop(time_);
      const Token::Kind kind = token.kind;
      if (kind == Token::Kind::work) {
        work(token);
        continue;
      }
      time_.work(1);
      out_.push(time_, std::move(token));
      if (kind == Token::Kind::end) return;
    }
  }

  Link<Token>& in_;
  Link<Token>& out_;
};

}  // namespace wedgesim::model::units

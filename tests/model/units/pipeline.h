#pragma once

#include <memory>

#include "tests/model/units/bench.h"
#include "tests/model/units/work.h"

namespace wedgesim::model::units::test {

/// One unit between a source that offers all its tokens in cycle 0, then the end, and a sink that
/// takes what comes. Links have a latency of 1: the first token is there in cycle 1.
struct Pipeline {
  Link<Token> in{"source to unit", {64, 1}}, out{"unit to sink", {64, 1}};
  std::vector<Cycle> popped;  // by the sink, the end left out
  std::vector<Token> items;

  /// \param unit      made with these links
  /// \param expected  how many tokens come out before the end
  void run(const BlockUnit& unit, std::vector<Token> tokens, std::size_t expected) {
    std::vector<std::pair<Cycle, Token>> offered;
    for (Token& token : tokens) offered.emplace_back(0, std::move(token));
    offered.emplace_back(0, mark(Token::Kind::end));
    Source<Token> source("source", unit.time().timing(), in, std::move(offered));
    Sink<Token> sink("sink", unit.time().timing(), out, expected + 1);
    sc_core::sc_start();
    ASSERT_TRUE(unit.finished());
    ASSERT_EQ(sink.items.size(), expected + 1);
    EXPECT_EQ(sink.items.back().kind, Token::Kind::end);
    const UnitTime& time = unit.time();
    EXPECT_EQ(time.busy() + time.starved() + time.stalled(), time.now());
    popped = sink.popped;
    items = sink.items;
    popped.pop_back();
    items.pop_back();
  }
};

}  // namespace wedgesim::model::units::test

#include "reports/timeline.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace wedgesim::reports {
namespace {

using State = Timeline::State;

Timeline example() {
  Timeline timeline(10, 100);
  timeline.add("walk", State::starved, 0, 12);
  timeline.add("walk", State::busy, 12, 14);
  timeline.add("walk", State::busy, 14, 20);
  timeline.add("cull", State::starved, 0, 15);
  timeline.add("walk", State::stalled, 20, 120);
  timeline.add("cull", State::busy, 15, 16);
  timeline.add("cull", State::busy, 200, 300);
  return timeline;
}

TEST(Timeline, JoinsNeighboursAndKeepsToItsWindow) {
  const Timeline timeline = example();
  const auto& walk = timeline.spans("walk");
  ASSERT_EQ(walk.size(), 3U);
  EXPECT_EQ(walk[0].begin, 10U);
  EXPECT_EQ(walk[1].state, State::busy);
  EXPECT_EQ(walk[1].begin, 12U);
  EXPECT_EQ(walk[1].end, 20U);
  EXPECT_EQ(walk[2].end, 100U);
  EXPECT_EQ(timeline.spans("cull").size(), 2U);
  EXPECT_TRUE(timeline.spans("none").empty());
}

TEST(Timeline, GivesPerfettoATrackAUnit) {
  std::ostringstream out;
  example().write_chrome(out);
  const auto json = nlohmann::json::parse(out.str());
  const auto& events = json["traceEvents"];
  ASSERT_EQ(events.size(), 5U);
  EXPECT_EQ(events[0]["args"]["name"], "walk");
  EXPECT_EQ(events[1]["name"], "busy");
  EXPECT_EQ(events[1]["ts"], 12);
  EXPECT_EQ(events[1]["dur"], 8);
  EXPECT_EQ(events[2]["name"], "stalled");
  EXPECT_EQ(events[3]["args"]["name"], "cull");
  EXPECT_EQ(events[4]["tid"], 2);
}

TEST(Timeline, WritesChangesInTheOrderOfTime) {
  std::ostringstream out;
  example().write_vcd(out);
  EXPECT_EQ(out.str(),
            "$timescale 1 ns $end\n$scope module block $end\n$var wire 2 ! walk $end\n"
            "$var wire 2 \" cull $end\n$upscope $end\n$enddefinitions $end\n"
            "#10\nb00 !\nb00 \"\n#12\nb01 !\n#15\nb01 \"\n#16\nb00 \"\n#20\nb10 !\n"
            "#100\nb00 !\n");
}

}  // namespace
}  // namespace wedgesim::reports

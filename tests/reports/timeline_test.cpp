#include "reports/timeline.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>

namespace wedgesim::reports {
namespace {

using State = Timeline::State;

Timeline example() {
  constexpr std::array<std::string_view, 3> kUnits{"fetch", "walk", "cull"};
  Timeline timeline(10, 100, kUnits);
  timeline.add("cull", State::starved, 0, 15);
  timeline.add("walk", State::starved, 0, 12);
  timeline.add("walk", State::busy, 12, 14);
  timeline.add("walk", State::busy, 14, 20);
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

// Tracks in the order of the units, one without a span among them.
TEST(Timeline, GivesPerfettoATrackAUnit) {
  std::ostringstream out;
  example().write_chrome(out);
  const auto json = nlohmann::json::parse(out.str());
  std::vector<std::string> tracks;
  std::vector<std::string> spans;
  for (const auto& event : json["traceEvents"]) {
    if (event["name"] == "thread_name") tracks.push_back(event["args"]["name"]);
    if (event["name"] == "thread_sort_index") {
      EXPECT_EQ(event["args"]["sort_index"], event["tid"]);
      EXPECT_EQ(event["tid"], tracks.size());
    }
    if (event["ph"] != "X") continue;
    const std::size_t track = event["tid"].get<std::size_t>() - 1;
    spans.push_back(fmt::format("{} {} {}+{}", tracks.at(track), event["name"].get<std::string>(),
                                event["ts"].get<int>(), event["dur"].get<int>()));
  }
  EXPECT_EQ(tracks, (std::vector<std::string>{"fetch", "walk", "cull"}));
  EXPECT_EQ(spans,
            (std::vector<std::string>{"walk busy 12+8", "walk stalled 20+80", "cull busy 15+1"}));
}

TEST(Timeline, WritesChangesInTheOrderOfTime) {
  std::ostringstream out;
  example().write_vcd(out);
  EXPECT_EQ(out.str(),
            "$timescale 1 ns $end\n$scope module block $end\n$var wire 2 ! fetch $end\n"
            "$var wire 2 \" walk $end\n$var wire 2 # cull $end\n$upscope $end\n"
            "$enddefinitions $end\n"
            "#10\nb00 !\nb00 \"\nb00 #\n#12\nb01 \"\n#15\nb01 #\n#16\nb00 #\n#20\nb10 \"\n"
            "#100\nb00 \"\n");
}

}  // namespace
}  // namespace wedgesim::reports

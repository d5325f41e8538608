// Whether the cases of every family are what the family says: closed meshes, sound traces, the
// parameter that it claims. What the renderer makes of hard ones is not judged here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "base/error.h"
#include "functional/methods/frame.h"
#include "functional/scene/manifold.h"
#include "reports/stress/family.h"
#include "reports/stress/measure.h"
#include "tests/base/temporary_folder.h"
#include "tests/reports/stress/measured.h"
#include "traces/writer.h"

namespace wedgesim::reports::stress {
namespace {

/// The trace of a case, or nothing if it is refused.
std::optional<functional::Frame> frame_of(const Case& made) {
  functional::FrameOptions options = made.options;
  options.depth = made.depth.get();
  try {
    return functional::make_frame(made.scene, options);
  } catch (const InputError&) {
    return {};
  }
}

std::set<double> levels_to_try(const Family& family) {
  std::set<double> levels{family.levels.front(), family.levels.back()};
  for (const auto& level : {family.required.fixed, family.required.double_precision}) {
    if (level) levels.insert(*level);
  }
  return levels;
}

/// The share of the pixels that are neither lit nor dark.
double penumbra_share(const traces::Trace& trace) {
  const auto count = std::ranges::count_if(trace.expected_li,
                                           [](double li) { return li > 1e-6 && li < 1.0 - 1e-6; });
  return static_cast<double>(count) / static_cast<double>(trace.expected_li.size());
}

bool may_refuse(const Family& family, double level) {
  return (family.name == "touching-light" || family.name == "enclosing-light") &&
         level < family.levels.front();
}

// A level is excused from having penumbrae only if it has none.
TEST(Families, ExcusedLevelsHaveNoPenumbra) {
  for (const Family& family : families()) {
    for (const double level : family.empty_levels) {
      EXPECT_EQ(measure(family.make(0, level)).in_penumbra, 0U) << family.name << " " << level;
    }
  }
}

TEST(Families, HaveLevelsFromHarmlessToHardAndRequireSomeOfThem) {
  std::set<std::string_view> names;
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    EXPECT_TRUE(names.insert(family.name).second);
    ASSERT_GE(family.levels.size(), 3U);
    const bool rise = family.levels.front() < family.levels.back();
    for (std::size_t i = 1; i < family.levels.size(); ++i) {
      EXPECT_EQ(family.levels[i - 1] < family.levels[i], rise);
      EXPECT_NE(family.levels[i - 1], family.levels[i]);
    }
    for (const auto& level : {family.required.fixed, family.required.double_precision}) {
      if (level) {
        EXPECT_EQ(std::ranges::count(family.levels, *level), 1) << *level;
      }
    }
  }
}

TEST(Families, MakeClosedCastersAndSoundTracesTheSameEachTime) {
  const TemporaryFolder folder;
  for (const Family& family : families()) {
    for (const double level : levels_to_try(family)) {
      for (std::uint64_t seed = 0; seed < kVariants; ++seed) {
        SCOPED_TRACE(std::string(family.name) + " " + std::to_string(seed) + " " +
                     std::to_string(level));
        const Case made = family.make(seed, level);
        for (const functional::Object& object : made.scene.objects) {
          if (object.casts) {
            EXPECT_NO_THROW(functional::require_closed(object.mesh, "caster"));
          }
        }
        // A hundred thousand wedges take seconds; `wedgesim stress` renders them.
        if (made.scene.objects.back().mesh.triangles.size() > 30000) continue;
        const auto frame = frame_of(made);
        ASSERT_TRUE(frame || may_refuse(family, level));
        const auto again = frame_of(family.make(seed, level));
        ASSERT_EQ(frame.has_value(), again.has_value());
        if (!frame) continue;
        EXPECT_EQ(traces::write_trace(folder / "a.wtrace", frame->trace),
                  traces::write_trace(folder / "b.wtrace", again->trace));
      }
    }
  }
}

TEST(Families, BeginWithPenumbraeInAGoodPartOfTheFrame) {
  for (const Family& family : families()) {
    for (std::uint64_t seed = 0; seed < 5 * kVariants; ++seed) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(seed));
      const auto frame = frame_of(family.make(seed, family.levels.front()));
      ASSERT_TRUE(frame);
      EXPECT_GE(penumbra_share(frame->trace), 0.15);
      for (const double li : frame->trace.expected_li) ASSERT_TRUE(std::isfinite(li));
    }
  }
}

TEST(Families, HaveTheParameterThatTheyClaim) {
  std::map<std::string_view, Measure> measures = caster_measures();
  measures.merge(view_measures());
  for (const Family& family : families()) {
    const auto found = measures.find(family.name);
    if (found == measures.end()) continue;
    const Measure measure = found->second;
    measures.erase(found);
    for (const double level : family.levels) {
      for (std::uint64_t seed = 0; seed < 3 * kVariants; ++seed) {
        SCOPED_TRACE(std::string(family.name) + " " + std::to_string(seed));
        const Case made = family.make(seed, level);
        const double measured = measure(made);
        if (level == 0.0) {
          EXPECT_LE(std::abs(measured), 1e-12);
        } else {
          EXPECT_GE(measured / level, 0.5) << level;
          EXPECT_LE(measured / level, 2.0) << level;
        }
      }
    }
  }
  EXPECT_TRUE(measures.empty()) << "no family is called " << measures.begin()->first;
}

}  // namespace
}  // namespace wedgesim::reports::stress

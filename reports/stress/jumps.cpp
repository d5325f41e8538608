#include "reports/stress/jumps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "functional/reference/judge.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/frame.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Frame;

constexpr std::size_t kPixels = 24;        // that are looked at
constexpr std::size_t kMostWedges = 5000;  // with more it would cost more than all else

/// Stored depths before a plane and behind it.
struct Sides {
  std::uint32_t before = 0, behind = 0;
};

std::optional<Sides> sides_of_plane(const Frame& frame, std::size_t pixel, std::uint32_t number) {
  const traces::fb::Wedge& wedge = frame.trace.wedges[number];
  // Not the planes that LI jumps across: the front of a `linear` wedge, whose back is beside it.
  const unsigned first = wedge.kind() == traces::fb::WedgeKind_linear ? 2 : 0;
  const auto chosen = static_cast<std::uint16_t>(first + pixel % (wedge.plane_count() - first));
  const std::uint32_t reference = (*wedge.planes())[chosen];
  const traces::fb::Plane& plane = frame.trace.planes[traces::plane_index(reference)];
  const auto width = static_cast<std::size_t>(frame.window.width);
  const double x = static_cast<double>(pixel % width) + 0.5;
  const double y = static_cast<double>(pixel / width) + 0.5;
  const double z = -((plane.a() * x + plane.b() * y) + plane.d()) / plane.c();
  if (!(z > 0.0 && z < 1.0)) return std::nullopt;
  const traces::fb::DepthFormat format = frame.depth.format;
  Sides sides;
  sides.before = traces::encode_depth(format, z);
  if (traces::decode_depth(format, sides.before) > z) {
    sides.before = traces::step_depth(format, sides.before, -1);
  }
  sides.behind = traces::step_depth(format, sides.before, 1);
  if (sides.behind == traces::sky_word(format)) return std::nullopt;
  return sides;
}

/// A frame twice, with some of its pixels moved to either side of a plane there.
struct Moved {
  std::array<Frame, 2> frames;
  std::vector<std::size_t> pixels;
  std::vector<std::uint32_t> wedges;  // whose planes, of each of pixels
};

Moved move_onto_planes(const Frame& frame, std::span<const std::size_t> pixels) {
  std::vector<std::size_t> looked_at;
  for (std::size_t k = 0; k < pixels.size(); k += 1 + pixels.size() / kPixels) {
    looked_at.push_back(pixels[k]);
  }
  const auto primitives = wedges_at(frame.trace.view(), looked_at);
  Moved moved{{frame, frame}, {}, {}};
  for (std::size_t i = 0; i < looked_at.size(); ++i) {
    const std::size_t pixel = looked_at[i];
    std::vector<std::uint32_t> wedges = primitives[i];
    std::erase_if(wedges,
                  [&](std::uint32_t number) { return number >= frame.trace.wedges.size(); });
    if (wedges.empty()) continue;
    const std::uint32_t wedge = wedges[pixel % wedges.size()];
    const auto sides = sides_of_plane(frame, pixel, wedge);
    if (!sides) continue;
    const std::array words{sides->before, sides->behind};
    for (std::size_t s = 0; s < 2; ++s) {
      moved.frames[s].trace.depth[pixel] = moved.frames[s].depth.words[pixel] = words[s];
    }
    moved.pixels.push_back(pixel);
    moved.wedges.push_back(wedge);
  }
  return moved;
}

}  // namespace

std::array<Jumps, kArithmetics.size()> largest_jumps(const Case& stress_case, const Frame& frame,
                                                     std::span<const std::size_t> pixels) {
  std::array<Jumps, kArithmetics.size()> jumps{};
  if (frame.trace.wedges.size() > kMostWedges) return jumps;
  const Moved moved = move_onto_planes(frame, pixels);
  if (moved.pixels.empty()) return jumps;
  // What the judge says of each moved pixel: one step nearer, both sides, one step farther.
  std::array<std::vector<double>, 4> exact;
  for (std::size_t s = 0; s < 4; ++s) {
    const int step = s == 0 ? -1 : (s == 3 ? 1 : 0);
    exact[s] = functional::judge_light_intensity(stress_case.scene, moved.frames[s / 2],
                                                 moved.pixels, step);
  }
  for (const Arithmetic arithmetic :
       {Arithmetic::fixed, Arithmetic::float32, Arithmetic::double_precision}) {
    const model::Datapath datapath = datapath_of(arithmetic, stress_case);
    Jumps& of = jumps[static_cast<std::size_t>(arithmetic)];
    std::array<std::vector<double>, 2> li;
    for (std::size_t s = 0; s < 2; ++s) {
      const traces::TraceView view = moved.frames[s].trace.view();
      const Evaluation evaluation = evaluate(view, method_of(frame), datapath);
      of.not_finite += evaluation.not_finite;
      li[s] = li_of(evaluation.sums, datapath);
    }
    of.largest.emplace();
    for (std::size_t i = 0; i < moved.pixels.size(); ++i) {
      const auto change = [&](std::size_t s) { return std::fabs(exact[s + 1][i] - exact[s][i]); };
      const double allowed = std::max(change(0), change(1)) + std::max(change(1), change(2));
      const double step = li[1][moved.pixels[i]] - li[0][moved.pixels[i]];
      const double error = std::fabs(step - (exact[2][i] - exact[1][i]));
      if (error - allowed > of.largest->excess) {
        of.largest = Jump{error - allowed, moved.pixels[i], moved.wedges[i]};
      }
    }
  }
  return jumps;
}

}  // namespace wedgesim::reports::stress

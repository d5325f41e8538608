#include "functional/methods/strip_splats.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr float kWidest = 8192.0F;       // texels: keeps snapped corners far from overflow
constexpr float kFanStep = 0.7854F;      // radians, of one triangle of a fan
constexpr float kSameDirection = 1e-4F;  // sine: no fan between strips that go on straight

SnappedPoint snapped(const glm::vec2& p) { return snap(WindowPoint(p.x, p.y, 0.0)); }

glm::vec2 turned(const glm::vec2& v, float angle) {
  const float c = std::cos(angle);
  const float s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

void add_side(const PenumbraStrip& strip, StripName name, bool inside,
              std::vector<StripSplat>& splats) {
  const float sign = inside ? -1.0F : 1.0F;
  const glm::vec2 end = strip.begin + strip.length * strip.along;
  const glm::vec2 away = sign * strip.outward();
  const float at_begin = std::min(kWidest, strip.half_width(strip.near_begin));
  const float at_end = std::min(kWidest, strip.half_width(strip.near_end));
  if (!(at_begin > 0.0F) && !(at_end > 0.0F)) return;
  splats.push_back(
      {{snapped(strip.begin), snapped(end), snapped(end + std::max(0.0F, at_end) * away),
        snapped(strip.begin + std::max(0.0F, at_begin) * away)},
       4,
       name,
       inside});
}

// The gap between two strips on the outer side of the turn between them.
void add_fan(const PenumbraStrip& before, const PenumbraStrip& strip, StripName name, bool inside,
             std::vector<StripSplat>& splats) {
  const float sign = inside ? -1.0F : 1.0F;
  const float width = std::min(
      kWidest, std::max(strip.half_width(strip.near_begin), before.half_width(before.near_end)));
  if (!(width > 0.0F)) return;
  const glm::vec2 from = sign * before.outward();
  const glm::vec2 to = sign * strip.outward();
  const float angle = std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
  const int steps = static_cast<int>(std::ceil(std::abs(angle) / kFanStep));
  const float reach = width / std::cos(0.5F * angle / static_cast<float>(steps));
  for (int i = 0; i < steps; ++i) {
    const float a0 = angle * static_cast<float>(i) / static_cast<float>(steps);
    const float a1 = angle * static_cast<float>(i + 1) / static_cast<float>(steps);
    const glm::vec2 p = i == 0 ? from : turned(from, a0);
    const glm::vec2 q = i + 1 == steps ? to : turned(from, a1);
    splats.push_back({{snapped(strip.begin),
                       snapped(strip.begin + reach * p),
                       snapped(strip.begin + reach * q),
                       {}},
                      3,
                      name,
                      inside});
  }
}

}  // namespace

std::vector<StripSplat> strip_splats(std::span<const PenumbraStrip> strips) {
  using Part = StripName::Part;
  std::vector<StripSplat> splats;
  splats.reserve(3 * strips.size());
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const PenumbraStrip& strip = strips[i];
    add_side(strip, StripName::of(i, Part::edge), false, splats);
    add_side(strip, StripName::of(i, Part::edge), true, splats);
    if (strip.previous == PenumbraStrip::kNone) continue;
    const PenumbraStrip& before = strips[strip.previous];
    const float turn = glm::dot(strip.along, before.outward());
    if (turn < -kSameDirection) {
      add_fan(before, strip, StripName::of(i, Part::outer_corner), false, splats);
    } else if (turn > kSameDirection) {
      add_fan(before, strip, StripName::of(i, Part::inner_corner), true, splats);
    }
  }
  return splats;
}

}  // namespace wedgesim::functional

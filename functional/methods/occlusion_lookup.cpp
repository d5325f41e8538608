#include "functional/methods/occlusion_lookup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr float kSameWay = 0.9F;      // cosine between normals of one penumbra
constexpr float kSameHeight = 0.25F;  // of a penumbra's width: how much those of one differ
constexpr float kBeyond = 0.02F;      // of its depth range: how far a penumbra goes on
constexpr float kClear = 1.0F;        // texels outside a silhouette where it hides nothing
constexpr float kLeastWidth = 0.05F;  // texels: less is the edge's own surface, rounded
constexpr std::size_t kMostLookups = 4;

float smooth(float t) { return t * t * (3.0F - 2.0F * t); }

}  // namespace

// How one silhouette bends the light's ray to a fragment.
struct OcclusionLookup::Bend {
  glm::vec2 outward{0.0F};  // unit
  float distance = 0.0F;    // texels from the silhouette to the fragment, outward
  float half_width =
      0.0F;  // texels of the penumbra at the fragment's depth; ≤ kLeastWidth before the edge
  float inverse_near = 0.0F;
  bool in_range = false;  // the fragment lies between z_near and z_far
  float moved = 0.0F;     // texels outward
  float visible = 1.0F;   // of the light, were there this silhouette alone

  /// Whether another silhouette is a part of the same penumbra, as its normal, its depth and the
  /// fragment's place to it tell: another piece of the edge, or another side of the caster.
  bool same_penumbra(const Bend& other) const {
    const bool as_high = std::abs(half_width - other.half_width) <=
                         kSameHeight * std::max(half_width, other.half_width);
    return as_high && (glm::dot(outward, other.outward) > kSameWay || other.distance < 0.0F);
  }
};

OcclusionLookup::OcclusionLookup(const ShadowMaps& shadows, std::span<const PenumbraStrip> strips,
                                 const DistortionMap& map, double focal, const Options& options)
    : casters_(shadows.casters),
      tiles_(shadows.caster_tiles),
      strips_(strips),
      map_(map),
      inverse_focal_(static_cast<float>(1.0 / focal)),
      options_(options) {
  const int tiles = light_tiles(casters_.size());
  for (int y = 0; y < tiles; ++y) {
    for (int x = 0; x < tiles; ++x) {
      if (!map.holds(x * kLightTile, y * kLightTile)) continue;
      tiles_[static_cast<std::size_t>(y * tiles + x)] = {0.0F, HUGE_VALF};
    }
  }
}

float OcclusionLookup::visible(const Fragment& fragment, Count& count) const {
  const glm::vec2& p = fragment.place;
  if (!options_.interpolate) {
    const Texel texel = texel_at(fragment, static_cast<int>(p.x), static_cast<int>(p.y), count);
    return visible_by_texel(fragment, texel, count);
  }
  const int x = static_cast<int>(p.x - 0.5F);
  const int y = static_cast<int>(p.y - 0.5F);
  const float u = p.x - 0.5F - static_cast<float>(x);
  const float v = p.y - 0.5F - static_cast<float>(y);
  const std::array<float, 4> weight{(1.0F - u) * (1.0F - v), u * (1.0F - v), (1.0F - u) * v, u * v};
  std::array<Texel, 4> texels;
  std::array<float, 4> visible{};
  float sum = 0.0F;
  for (std::size_t i = 0; i < 4; ++i) {
    const int right = static_cast<int>(i) % 2;
    const int below = static_cast<int>(i) / 2;
    texels[i] = texel_at(fragment, std::min(x + right, casters_.size() - 1),
                         std::min(y + below, casters_.size() - 1), count);
    // Most neighbours say the same.
    const auto same = static_cast<std::size_t>(
        std::find(texels.begin(), texels.begin() + i, texels[i]) - texels.begin());
    visible[i] = same < i ? visible[same] : visible_by_texel(fragment, texels[i], count);
    sum += weight[i] * visible[i];
  }
  return sum;
}

OcclusionLookup::Texel OcclusionLookup::texel_at(const Fragment& fragment, int x, int y,
                                                 Count& count) const {
  Texel texel;
  texel.covered =
      fragment.facing != Facing::light || hidden(x, y, fragment.inverse_depth / kOwnDepth, count);
  if (!map_.holds(x, y)) return texel;
  ++count.map_reads;
  texel.name = map_.at(texel.covered, x, y);
  return texel;
}

bool OcclusionLookup::hidden(int x, int y, float inverse_depth, Count& count) const {
  ++count.depth_reads;
  return casters_.at(x, y) > inverse_depth;
}

// Whether a fragment is hidden from the place that its ray was bent to. A receiver's own surface
// may be nearer there: the bias lets it be, as far as a slope of `bias` explains.
bool OcclusionLookup::hidden_after(const glm::vec2& place, const Fragment& fragment,
                                   Count& count) const {
  const int x = static_cast<int>(std::floor(place.x));
  const int y = static_cast<int>(std::floor(place.y));
  if (x < 0 || y < 0 || x >= casters_.size() || y >= casters_.size()) return false;
  const float moved = glm::distance(place, fragment.place) * inverse_focal_;  // of its depth
  const float share = kOwnDepth - static_cast<float>(options_.bias) * moved;
  return share > 0.0F && hidden(x, y, fragment.inverse_depth / share, count);
}

StripName OcclusionLookup::name_at(const glm::vec2& place, bool inside, Count& count) const {
  const int x = static_cast<int>(std::floor(place.x));
  const int y = static_cast<int>(std::floor(place.y));
  if (x < 0 || y < 0 || x >= casters_.size() || y >= casters_.size()) return {};
  ++count.map_reads;
  return map_.at(inside, x, y);
}

OcclusionLookup::Bend OcclusionLookup::bend(StripName name, const Fragment& fragment) const {
  const PenumbraStrip& strip = strips_[name.strip()];
  const glm::vec2 way = fragment.place - strip.begin;
  Bend bend;
  bend.outward = strip.outward();
  bend.distance = glm::dot(way, bend.outward);
  float along = std::clamp(glm::dot(way, strip.along) / strip.length, 0.0F, 1.0F);
  if (name.part() != StripName::Part::edge) {
    along = 0.0F;
    const float sign = name.part() == StripName::Part::outer_corner ? 1.0F : -1.0F;
    const float length = glm::length(way);
    bend.distance = sign * length;
    if (length > 0.0F) bend.outward = sign / length * way;
  }
  bend.inverse_near = strip.near_begin + along * (strip.near_end - strip.near_begin);
  bend.half_width = strip.scale * (bend.inverse_near - fragment.inverse_depth);
  if (bend.half_width <= kLeastWidth) {
    // The silhouette is behind the fragment: look beyond its penumbra for another.
    bend.moved = std::max(0.0F, strip.half_width(bend.inverse_near) - bend.distance);
    return bend;
  }
  const float beyond = strip.far + kBeyond * (strip.far - 1.0F / bend.inverse_near);
  bend.in_range = fragment.inverse_depth * beyond >= 1.0F;
  bend.moved = std::clamp(0.5F * (bend.half_width - bend.distance), 0.0F, bend.half_width);
  bend.visible =
      smooth(std::clamp(0.5F * (bend.half_width + bend.distance) / bend.half_width, 0.0F, 1.0F));
  return bend;
}

float OcclusionLookup::visible_by_texel(const Fragment& fragment, const Texel& texel,
                                        Count& count) const {
  bool covered = texel.covered;
  StripName name = texel.name;
  std::array<Bend, kMostLookups> bends;
  std::size_t found = 0;
  for (int i = 0; i < options_.lookups && name.exists(); ++i) {
    const Bend next = bend(name, fragment);
    bool again = false;
    for (std::size_t j = 0; j < found; ++j) again = again || bends[j].same_penumbra(next);
    if (again) break;
    const glm::vec2 place =
        fragment.place + std::max(next.moved, kClear - next.distance) * next.outward;
    const bool still_hidden = hidden_after(place, fragment, count);
    if (next.half_width > kLeastWidth) {
      bends[found++] = next;
      if (!still_hidden) covered = false;
    }
    if (i + 1 < options_.lookups) name = name_at(place, still_hidden, count);
  }
  if (covered) return 0.0F;
  // Penumbrae whose depth range holds the fragment count; where there is none, the first.
  float product = 1.0F;
  bool any = false;
  for (std::size_t j = 0; j < found; ++j) {
    if (!bends[j].in_range) continue;
    product *= bends[j].visible;
    any = true;
  }
  return any || found == 0 ? product : bends[0].visible;
}

}  // namespace wedgesim::functional

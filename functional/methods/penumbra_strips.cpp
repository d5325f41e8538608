#include "functional/methods/penumbra_strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "functional/raster/light_map.h"
#include "functional/raster/light_window.h"

namespace wedgesim::functional {
namespace {

constexpr double kPiece = 16.0;         // texels, of an edge; z_far is found once a piece
constexpr double kShortest = 1e-6;      // texels: an edge that points at the light has no direction
constexpr double kBeside = 1.5;         // texels from an edge to the surface behind it
constexpr double kHidden = 1.0 - 1e-3;  // of an edge's depth: a nearer surface hides it

class StripBuilder {
 public:
  StripBuilder(const Window& view, const LightDepths& surfaces, double radius, double far)
      : view_(view), surfaces_(surfaces), radius_(radius), far_(far), focal_(focal_length(view)) {}

  void add_loop(const Mesh& mesh, const std::vector<SilhouetteEdge>& loop) {
    begin_of_loop_ = strips_.size();
    last_ = PenumbraStrip::kNone;
    first_is_seen_ = true;
    for (const SilhouetteEdge& edge : loop) {
      add_edge(mesh.positions[edge.begin], mesh.positions[edge.end]);
    }
    if (first_is_seen_ && begin_of_loop_ < strips_.size()) {
      strips_[begin_of_loop_].previous = last_;
    }
  }

  std::vector<PenumbraStrip> take() { return std::move(strips_); }

 private:
  void add_edge(const glm::dvec3& from, const glm::dvec3& to) {
    const MapPlace a = place_in(view_, from);
    const MapPlace b = place_in(view_, to);
    const glm::dvec2 begin(a.x, a.y);
    const glm::dvec2 way(b.x - a.x, b.y - a.y);
    const double length = glm::length(way);
    if (length < kShortest) return;
    const glm::dvec2 along = way / length;
    const int pieces = static_cast<int>(std::ceil(length / kPiece));
    for (int i = 0; i < pieces; ++i) {
      const double t0 = static_cast<double>(i) / pieces;
      const double t1 = static_cast<double>(i + 1) / pieces;
      add_piece(begin + t0 * way, along, length / pieces, std::lerp(1.0 / a.w, 1.0 / b.w, t0),
                std::lerp(1.0 / a.w, 1.0 / b.w, t1));
    }
  }

  void add_piece(const glm::dvec2& begin, const glm::dvec2& along, double length,
                 double inverse_begin, double inverse_end) {
    const glm::dvec2 outward(-along.y, along.x);
    const glm::dvec2 middle = begin + 0.5 * length * along;
    // A sphere's penumbra on a plane across the axis is longer away from it.
    const double slant = glm::dot(middle - 0.5 * view_.width, outward) / focal_;
    const double scale = focal_ * radius_ * std::sqrt(1.0 + slant * slant);
    const double inverse = 0.5 * (inverse_begin + inverse_end);
    const double far = far_beside(middle, outward, 1.0 / inverse, scale);
    if (far == 0.0) {
      first_is_seen_ = first_is_seen_ && strips_.size() > begin_of_loop_;
      last_ = PenumbraStrip::kNone;
      return;
    }
    PenumbraStrip strip;
    strip.begin = begin;
    strip.along = along;
    strip.length = static_cast<float>(length);
    strip.near_begin = static_cast<float>(inverse_begin);
    strip.near_end = static_cast<float>(inverse_end);
    strip.far = static_cast<float>(far);
    strip.scale = static_cast<float>(scale);
    strip.previous = last_;
    last_ = static_cast<std::uint32_t>(strips_.size());
    strips_.push_back(strip);
  }

  // The depth of the surface behind an edge, within the penumbra that it casts there; 0 if a
  // surface in front hides the edge.
  double far_beside(const glm::dvec2& middle, const glm::dvec2& outward, double near,
                    double scale) const {
    const double widest = scale * (1.0 / near - 1.0 / far_);
    std::array<double, 3> depths{};
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const double away = kBeside + widest * static_cast<double>(i) / 2.0;
      depths[i] = surface_at(middle + away * outward);
    }
    if (depths[0] < kHidden * near) return 0.0;
    double far = depths[0];
    for (std::size_t i = 1; i < depths.size(); ++i) {
      if (depths[i] < near) continue;
      // On the other side of the edge a slanted surface is as much farther as it is nearer here.
      far = std::max({far, depths[i], 2.0 * depths[0] - depths[i]});
    }
    return std::clamp(far, near, far_);
  }

  double surface_at(const glm::dvec2& p) const {
    const int x = static_cast<int>(std::floor(p.x));
    const int y = static_cast<int>(std::floor(p.y));
    if (x < 0 || y < 0 || x >= surfaces_.size() || y >= surfaces_.size()) return far_;
    return std::min(far_, 1.0 / static_cast<double>(surfaces_.at(x, y)));
  }

  const Window& view_;
  const LightDepths& surfaces_;
  double radius_;
  double far_;  // of the scene
  double focal_;
  std::size_t begin_of_loop_ = 0;
  bool first_is_seen_ = true;                  // the first piece of the loop has a strip
  std::uint32_t last_ = PenumbraStrip::kNone;  // the strip that ends where the next piece begins
  std::vector<PenumbraStrip> strips_;
};

double farthest(const Scene& scene, const Window& view) {
  double far = 0.0;
  for (const Object& object : scene.objects) {
    for (const glm::dvec3& p : object.mesh.positions) far = std::max(far, place_in(view, p).w);
  }
  return far;
}

}  // namespace

std::vector<PenumbraStrip> penumbra_strips(const Scene& scene, const Window& light_window,
                                           std::span<const Silhouette> silhouettes,
                                           const LightDepths& surfaces, double radius) {
  CHECK_EQ(silhouettes.size(), scene.objects.size());
  StripBuilder builder(light_window, surfaces, radius, farthest(scene, light_window));
  for (std::size_t i = 0; i < silhouettes.size(); ++i) {
    for (const auto& loop : silhouettes[i].loops) builder.add_loop(scene.objects[i].mesh, loop);
  }
  return builder.take();
}

}  // namespace wedgesim::functional

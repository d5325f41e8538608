#include "functional/light/shader_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "functional/light/coverage.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kTableSide = SectorTable::kSide;
constexpr float kAngleStep = static_cast<float>(2.0 * kPi / 65535.0);

float cross_2d(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

// From one angle to another, the short way, [0, π].
double minor_arc(double p, double q) {
  const double way = std::abs(p - q);
  return std::min(way, 2.0 * kPi - way);
}

double disc_sector(double p, double q) { return 0.5 * minor_arc(p, q); }

// The perimeter of the square [−1, 1]² from angle 0 on, counter-clockwise: the area of a sector of
// the square is half its perimeter.
double perimeter_at(double angle) {
  const double quarter = std::round(angle / (0.5 * kPi));
  return 2.0 * quarter + std::tan(angle - 0.5 * kPi * quarter);
}

double square_sector(double p, double q) {
  const double way = std::abs(perimeter_at(p) - perimeter_at(q));
  return 0.5 * std::min(way, 8.0 - way);
}

}  // namespace

AngleMap::AngleMap() {
  for (std::size_t i = 0; i < kSide; ++i) {
    const double along = (2.0 * static_cast<double>(i) + 1.0) / kSide - 1.0;
    const auto word = [](double y, double x) {
      const double step = static_cast<double>(kAngleStep);
      const auto rounded = static_cast<float>(std::lround((std::atan2(y, x) + kPi) / step));
      return rounded * kAngleStep - static_cast<float>(kPi);
    };
    texels_[i] = word(along, 1.0);
    texels_[kSide + i] = word(along, -1.0);
    texels_[2 * kSide + i] = word(1.0, along);
    texels_[3 * kSide + i] = word(-1.0, along);
  }
}

float AngleMap::angle(const glm::vec2& direction) const {
  const bool in_x = std::abs(direction.x) >= std::abs(direction.y);
  const float major = in_x ? direction.x : direction.y;
  const float minor = in_x ? direction.y : direction.x;
  const std::size_t face = (in_x ? 0U : 2U) + (major < 0.0F ? 1U : 0U);
  const auto texel = static_cast<int>((minor / std::abs(major) + 1.0F) * (0.5F * kSide));
  const auto i = static_cast<std::size_t>(std::clamp(texel, 0, kSide - 1));
  return texels_[face * kSide + i];
}

SectorTable::SectorTable(double area, std::uint32_t largest_word, double (*sector)(double, double))
    : table_(static_cast<std::size_t>(kTableSide * kTableSide)),
      area_(static_cast<float>(area)),
      word_bytes_(largest_word > 255 ? 2 : 1) {
  const double word = 0.5 * area / largest_word;
  const auto angle = [](std::size_t i) {
    return 2.0 * kPi * (static_cast<double>(i) + 0.5) / kTableSide - kPi;
  };
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const double exact = sector(angle(i % kTableSide), angle(i / kTableSide));
    table_[i] = static_cast<float>(word * std::round(exact / word));
  }
}

SectorTable SectorTable::disc() { return {kPi, 65535, disc_sector}; }
SectorTable SectorTable::square() { return {4.0, 255, square_sector}; }

// Bilinear, and the texture repeats: all the way round.
float SectorTable::area_between(float angle_p, float angle_q) const {
  struct Between {
    explicit Between(float angle) {
      const float at = (angle / static_cast<float>(2.0 * kPi) + 0.5F) * kTableSide - 0.5F;
      const float low = std::floor(at);
      first = static_cast<std::size_t>(static_cast<int>(low) + kTableSide) % kTableSide;
      second = (first + 1) % kTableSide;
      weight = at - low;
    }
    std::size_t first, second;
    float weight;
  };
  const Between p(angle_p);
  const Between q(angle_q);
  const auto row = [&](std::size_t j) {
    return std::lerp(table_[j * kTableSide + p.first], table_[j * kTableSide + p.second], p.weight);
  };
  return std::lerp(row(q.first), row(q.second), q.weight);
}

float SectorTable::coverage(const glm::vec2& p, const glm::vec2& q) const {
  const float sector = area_between(angles_.angle(p), angles_.angle(q));
  const float triangle = 0.5F * std::abs(cross_2d(p, q));
  return std::clamp((sector - triangle) / area_, 0.0F, 0.5F);
}

float shader_sphere_coverage(const SectorTable& disc, const glm::dvec3& point,
                             const glm::dvec3& begin, const glm::dvec3& end) {
  const double distance = glm::length(point);
  if (!(distance > 1.0)) return 0.0F;
  const glm::dvec3 axis = -point / distance;
  const Across across(axis);
  // The point at the origin, the light's centre at z = 1, its radius 1: the cone is x² + y² = z².
  const auto in_cone = [&](const glm::dvec3& e) {
    return glm::vec3(glm::dvec3(glm::dot(e, across.u), glm::dot(e, across.v),
                                glm::dot(e - point, axis) / distance));
  };
  const glm::vec3 a = in_cone(begin);
  const glm::vec3 way = in_cone(end) - a;
  const auto form = [](const glm::vec3& v, const glm::vec3& w) {
    return v.x * w.x + v.y * w.y - v.z * w.z;
  };
  // form(a + s·way) ≤ 0 with z > 0; a cone's inside is convex, so this is one part of the line.
  const float aa = form(way, way);
  const float ab = form(a, way);
  const float bb = form(a, a);
  const float root = ab * ab - aa * bb;
  if (!(root > 0.0F)) return 0.0F;
  // The roots of aa·s² + 2·ab·s + bb without the difference that cancels if aa is small.
  const float sum = -(ab + std::copysign(std::sqrt(root), ab));
  const auto [s0, s1] = std::minmax({sum / aa, bb / sum});
  float low = 0.0F;
  float high = 1.0F;
  if (aa > 0.0F) {
    low = std::max(low, s0);
    high = std::min(high, s1);
  } else if (way.z > 0.0F) {  // steeper than the cone: in from one crossing on
    low = std::max(low, s1);
  } else {
    high = std::min(high, s0);
  }
  const glm::vec3 c0 = a + low * way;
  const glm::vec3 c1 = a + high * way;
  if (!(low < high) || !(c0.z > 0.0F) || !(c1.z > 0.0F)) return 0.0F;
  return disc.coverage(glm::vec2(c0) / c0.z, glm::vec2(c1) / c1.z);
}

float shader_rectangle_coverage(const SectorTable& square, const glm::dvec3& point,
                                const glm::dvec3& begin, const glm::dvec3& end) {
  const std::optional<Chord> chord = project_edge(point, begin, end);
  return chord ? square.coverage(glm::vec2(chord->p), glm::vec2(chord->q)) : 0.0F;
}

std::span<const std::int32_t> split_words() {
  static const std::array<std::int32_t, 1024> entries = [] {
    std::array<std::int32_t, 1024> made{};
    for (int i = 0; i < 1024; ++i) {
      made[static_cast<std::size_t>(i)] =
          std::bit_cast<std::int32_t>(SplitWord::pack((i * SplitWord::kWhole + 1023) / (2 * 1023)));
    }
    return made;
  }();
  return entries;
}

SplitWord split_coverage(float coverage) {
  const float at = std::clamp(2.0F * coverage, 0.0F, 1.0F) * 1023.0F + 0.5F;
  return std::bit_cast<SplitWord>(split_words()[static_cast<std::size_t>(at)]);
}

}  // namespace wedgesim::functional

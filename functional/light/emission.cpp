#include "functional/light/emission.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace wedgesim::functional {
namespace {

double cross_2d(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// The same side or both ways of one line, as far as rounding lets one see.
bool same_direction(const glm::dvec2& p, const glm::dvec2& q) {
  const double size = std::abs(p.x * q.y) + std::abs(p.y * q.x);
  return p.x * q.x + p.y * q.y >= 0.0 && std::abs(cross_2d(p, q)) <= 4e-16 * size;
}

// From a coordinate along a segment to the next line between texels.
struct Crossings {
  Crossings(double from, double way)
      : next(way > 0.0 ? std::floor(from) + 1.0 : std::ceil(from) - 1.0),
        step(way > 0.0 ? 1.0 : -1.0),
        from_(from),
        inverse_(1.0 / way) {}
  double next, step;
  // The share of the segment before the next line.
  double at() const {
    return std::isinf(inverse_) ? std::numeric_limits<double>::infinity()
                                : (next - from_) * inverse_;
  }

 private:
  double from_, inverse_;
};

}  // namespace

Emission::Emission() : share_{1.0}, before_{0.0} { sum_rows(); }

Emission::Emission(const Image& shares)
    : width_(shares.width),
      height_(shares.height),
      channels_(3),
      share_(shares.values.begin(), shares.values.end()),
      before_(share_.size()) {
  CHECK_EQ(shares.channels, 3);
  CHECK_GE(std::min(width_, height_), 1);
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  for (std::size_t i = 0; i < share_.size(); ++i) {
    before_[i] = i % row < 3 ? 0.0 : before_[i - 3] + share_[i - 3];
  }
  sum_rows();
  round_to_float();
}

void Emission::round_to_float() {
  for (std::size_t i = 0; i < share_.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) texels_.push_back(static_cast<float>(before_[i + c]));
    for (std::size_t c = 0; c < 3; ++c) texels_.push_back(static_cast<float>(share_[i + c]));
  }
  for (const Colour& sum : below_) {
    for (const double value : sum) below_in_float_.push_back(static_cast<float>(value));
  }
}

void Emission::sum_rows() {
  const auto channels = static_cast<std::size_t>(channels_);
  below_.resize(static_cast<std::size_t>(height_) + 1);
  for (std::size_t i = 0; i < share_.size(); ++i) {
    const std::size_t row = i / channels / static_cast<std::size_t>(width_);
    if (i % (channels * static_cast<std::size_t>(width_)) == 0) below_[row + 1] = below_[row];
    below_[row + 1][i % channels] += share_[i];
  }
}

glm::dvec2 Emission::texels(const glm::dvec2& p) const {
  return {0.5 * (p.x + 1.0) * width_, 0.5 * (p.y + 1.0) * height_};
}

// Adds ∫ F dy, F the power of its row left of a point. Between lines of texels F is linear.
void Emission::add_along(const glm::dvec2& from, const glm::dvec2& to, double sign,
                         Colour& sum) const {
  const glm::dvec2 begin = texels(from);
  const glm::dvec2 way = texels(to) - begin;
  if (way.y == 0.0) return;
  Crossings in_x(begin.x, way.x);
  Crossings in_y(begin.y, way.y);
  for (double t = 0.0; t < 1.0;) {
    const double at_x = in_x.at();
    const double at_y = in_y.at();
    const double next = std::min({1.0, at_x, at_y});
    if (at_x <= next) in_x.next += in_x.step;
    if (at_y <= next) in_y.next += in_y.step;
    const glm::dvec2 middle = begin + 0.5 * (t + next) * way;
    const int column = std::clamp(static_cast<int>(middle.x), 0, width_ - 1);
    const int row = std::clamp(static_cast<int>(middle.y), 0, height_ - 1);
    const auto texel = static_cast<std::size_t>((row * width_ + column) * channels_);
    const double height = sign * (next - t) * way.y;
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
      sum[c] += height * (before_[texel + c] + (middle.x - column) * share_[texel + c]);
    }
    t = next;
  }
}

Emission::Colour Emission::along(const glm::dvec2& from, const glm::dvec2& to) const {
  Colour sum{};
  add_along(from, to, 1.0, sum);
  return sum;
}

// Along the outline ∫ F dy grows on the right side alone: F is 0 on the left one.
Emission::Colour Emission::round(const glm::dvec2& p) const {
  const double reach = std::max(std::abs(p.x), std::abs(p.y));
  const glm::dvec2 exit = reach > 0.0 ? p / reach : glm::dvec2(1.0, 0.0);
  Colour sum = below_.back();
  if (exit.x > 0.0 && exit.x >= std::abs(exit.y)) {
    const double y = texels(exit).y;
    const auto row = std::min(static_cast<std::size_t>(y), below_.size() - 2);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
      sum[c] = std::lerp(below_[row][c], below_[row + 1][c], y - static_cast<double>(row));
    }
  }
  add_along(exit, p, 1.0, sum);
  return sum;
}

bool Emission::passes_start(const glm::dvec2& p, const glm::dvec2& q) {
  // x + y changes its sign there, from below zero on; its sign is exact.
  const double at_p = p.x + p.y;
  const double at_q = q.x + q.y;
  return (at_p < 0.0 || (at_p == 0.0 && p.x < 0.0)) && (at_q > 0.0 || (at_q == 0.0 && q.x > 0.0));
}

Emission::Colour Emission::beyond(const glm::dvec2& p, const glm::dvec2& q) const {
  if (same_direction(p, q)) return {};
  if (cross_2d(p, q) < 0.0) return beyond(q, p);
  const double whole = passes_start(p, q) ? 1.0 : 0.0;
  const Colour round_p = round(p);
  Colour part = round(q);
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    part[c] += whole - round_p[c];
  }
  add_along(p, q, -1.0, part);
  for (double& value : part) value = std::clamp(value, 0.0, 1.0);
  return part;
}

}  // namespace wedgesim::functional

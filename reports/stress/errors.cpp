#include "reports/stress/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wedgesim::reports::stress {
namespace {

constexpr double kQuiet = 1.0 / 255.0;
// The judge's sums of whole shares.
constexpr double kWhole = 1e-12;

struct Root {
  double sum = 0.0;
  std::uint64_t count = 0;
  void add(double x) {
    sum += x * x;
    ++count;
  }
  double value() const { return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)); }
};

// Pixels off by more than half beyond their sensitivity without such a pixel beside them.
std::uint64_t count_specks(const std::vector<bool>& off, int width, int height) {
  std::uint64_t specks = 0;
  const auto is_off = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height &&
           off[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!is_off(x, y)) continue;
      int beside = -1;  // itself
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) beside += is_off(x + dx, y + dy) ? 1 : 0;
      }
      specks += beside == 0 ? 1 : 0;
    }
  }
  return specks;
}

double error_at(double li, double judge) {
  const double error = std::fabs(li - judge);
  return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

// Away from penumbrae all shares are whole, and so is their sum in any arithmetic.
bool leaks(double li, const JudgedPixel& p) {
  const double whole = std::nearbyint(p.li);
  return !p.in_wedge && p.sensitivity == 0.0 && std::fabs(p.li - whole) < kWhole && li != whole;
}

}  // namespace

bool is_quiet(const JudgedPixel& pixel) { return pixel.sensitivity <= kQuiet; }

std::vector<std::size_t> compare(const std::vector<double>& li, std::span<const JudgedPixel> judged,
                                 int width, Arithmetic arithmetic, Errors& errors) {
  Root all;
  Root penumbra;
  std::vector<bool> half_off(li.size(), false);
  std::vector<std::size_t> beyond;
  for (const JudgedPixel& p : judged) {
    const double error = error_at(li[p.pixel], p.li);
    errors.max_error = std::max(errors.max_error, error);
    errors.max_excess = std::max(errors.max_excess, error - p.sensitivity);
    errors.off += error > 1.0 / 255.0 ? 1 : 0;
    if (error > tolerance_of(arithmetic) + p.sensitivity) beyond.push_back(p.pixel);
    half_off[p.pixel] = error > 0.5 + p.sensitivity;
    if (leaks(li[p.pixel], p)) {
      errors.leaks += 1;
      if (!errors.first_leak) errors.first_leak = p.pixel;
    }
    if (!is_quiet(p)) continue;
    all.add(error);
    if (p.in_wedge) penumbra.add(error);
  }
  errors.beyond = beyond.size();
  errors.rms = all.value();
  errors.rms_penumbra = penumbra.value();
  errors.specks = count_specks(half_off, width, static_cast<int>(li.size()) / width);
  return beyond;
}

bool holds(const Errors& errors, Arithmetic arithmetic) {
  const bool wide = tolerance_of(arithmetic) > 1e-6;
  return errors.beyond == 0 && errors.specks == 0 && errors.not_finite == 0 && errors.leaks == 0 &&
         (!errors.jump || errors.jump->excess <= largest_jump_of(arithmetic)) &&
         (!wide || (errors.rms <= kLargestRms && errors.rms_penumbra <= kLargestRms));
}

}  // namespace wedgesim::reports::stress

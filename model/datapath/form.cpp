#include "model/datapath/form.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "base/limits.h"
#include "traces/depth.h"

namespace wedgesim::model::datapath {
namespace {

constexpr double kFrame = kMaxFrameEdge;
constexpr double kFloatSteps = 67108864.0;  // 2^26
constexpr int kMostMagnified = 60;          // of reversed depths, powers of two
constexpr int kNoExponent = -1022;          // of forms that are 0

bool is_unorm(traces::fb::DepthFormat format) {
  return format == traces::fb::DepthFormat_unorm24 || format == traces::fb::DepthFormat_unorm16;
}

// a0 b0 + a1 b1 + a2 b2. Source: Ogita, Rump and Oishi, "Accurate sum and dot product", Dot2; a
// fused multiply-add gives the rounding of a product.
double sum_of_products(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  double sum = 0.0;
  double lost = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double product = a[i] * b[i];
    const double before = sum;
    sum += product;
    const double added = sum - before;
    lost += std::fma(a[i], b[i], -product) + ((before - (sum - added)) + (product - added));
  }
  return sum + lost;
}

}  // namespace

LinearForm combine(const LinearForm& p, double f, const LinearForm& q, double g,
                   const LinearForm& r, double h) {
  const auto coefficient = [&](double LinearForm::*of) {
    return sum_of_products({p.*of, q.*of, r.*of}, {f, g, h});
  };
  return {coefficient(&LinearForm::a), coefficient(&LinearForm::b), coefficient(&LinearForm::c),
          coefficient(&LinearForm::d)};
}

ZSteps::ZSteps(traces::fb::DepthFormat format, std::span<const std::uint32_t> words)
    : format_(format), one_(is_unorm(format) ? traces::sky_word(format) : kFloatSteps) {
  high_ = static_cast<std::int64_t>(one_);
  if (format != traces::fb::DepthFormat_float32_reversed) return;
  origin_ = 1.0;
  low_ = -high_;
  high_ = 0;
  // Words of floats that are not negative are in the order of the floats.
  const auto greatest = std::max_element(words.begin(), words.end());
  if (greatest == words.end()) return;
  int exponent = 0;
  const double share = std::frexp(static_cast<double>(std::bit_cast<float>(*greatest)), &exponent);
  if (share == 0.5) --exponent;  // a power of two itself
  one_ = std::ldexp(kFloatSteps, std::min(-exponent, kMostMagnified));
}

std::int64_t ZSteps::of_word(std::uint32_t word) const {
  return is_unorm(format_) ? word : std::llrint(unrounded(word));
}

double ZSteps::unrounded(std::uint32_t word) const {
  if (is_unorm(format_)) return word;
  if (format_ == traces::fb::DepthFormat_float32_reversed) {
    return -static_cast<double>(std::bit_cast<float>(word)) * one_;
  }
  return traces::decode_depth(format_, word) * one_;
}

std::int64_t ZSteps::first(double z) const {
  const double step = std::ceil((z - origin_) * one_);
  return static_cast<std::int64_t>(
      std::clamp(step, static_cast<double>(low_ - 1), static_cast<double>(high_ + 1)));
}

std::int64_t ZSteps::last(double z) const {
  const double step = std::floor((z - origin_) * one_);
  return static_cast<std::int64_t>(
      std::clamp(step, static_cast<double>(low_ - 1), static_cast<double>(high_ + 1)));
}

int least_form_bits(traces::fb::DepthFormat depth, unsigned width, unsigned height) {
  const ZSteps z(depth);
  const auto steps = static_cast<std::uint64_t>(z.high() - z.low());
  return static_cast<int>(1 + std::bit_width(steps) + std::bit_width(std::max(width, height)));
}

void require_form_bits(int form_bits, traces::fb::DepthFormat depth, unsigned width,
                       unsigned height, std::string_view place) {
  const int least = least_form_bits(depth, width, height);
  if (form_bits >= least) return;
  throw InputError(place,
                   fmt::format("'form_bits' is {}, too narrow for a frame of {}x{} with {} depth",
                               form_bits, width, height, traces::fb::EnumNameDepthFormat(depth)),
                   fmt::format("{} or more", least));
}

int common_exponent(std::span<const LinearForm> forms, const ZSteps& steps, int form_bits) {
  const double span = static_cast<double>(steps.high() - steps.low()) / steps.one();
  double bound = 0.0;
  for (const LinearForm& form : forms) {
    bound =
        std::max(bound, kFrame * (std::fabs(form.a) + std::fabs(form.b)) +
                            std::fabs(form.c) * span + std::fabs(form.d + form.c * steps.origin()));
  }
  if (bound == 0.0) return kNoExponent;
  int exponent = 0;
  std::frexp(bound, &exponent);  // bound < 2^exponent
  return exponent - (form_bits - 1);
}

FixedForm quantize(const LinearForm& form, const ZSteps& steps, int exponent) {
  const auto rounded = [exponent](double x) { return std::llrint(std::ldexp(x, -exponent)); };
  return {rounded(form.a / 2.0), rounded(form.b / 2.0), rounded(form.c / steps.one()),
          rounded(form.d + form.c * steps.origin()), exponent};
}

FixedForm quantize_alone(const LinearForm& form, const ZSteps& steps, int form_bits) {
  return quantize(form, steps, common_exponent({&form, 1}, steps, form_bits));
}

}  // namespace wedgesim::model::datapath

#include "model/datapath/form.h"

#include <algorithm>
#include <cmath>

#include "base/limits.h"
#include "traces/depth.h"

namespace wedgesim::model::datapath {
namespace {

constexpr double kFrame = kMaxFrameEdge;
constexpr double kFloatSteps = 67108864.0;  // 2^26
constexpr int kNoExponent = -1022;          // of forms that are 0

bool is_unorm(traces::fb::DepthFormat format) {
  return format == traces::fb::DepthFormat_unorm24 || format == traces::fb::DepthFormat_unorm16;
}

}  // namespace

ZSteps::ZSteps(traces::fb::DepthFormat format)
    : format_(format), one_(is_unorm(format) ? traces::sky_word(format) : kFloatSteps) {}

std::int64_t ZSteps::of_word(std::uint32_t word) const {
  if (is_unorm(format_)) return word;
  return std::llrint(traces::decode_depth(format_, word) * one_);
}

std::int64_t ZSteps::first(double z) const {
  return static_cast<std::int64_t>(std::ceil(z * one_));
}

std::int64_t ZSteps::last(double z) const {
  return static_cast<std::int64_t>(std::floor(z * one_));
}

int common_exponent(std::span<const LinearForm> forms, int form_bits) {
  double bound = 0.0;
  for (const LinearForm& form : forms) {
    bound = std::max(bound, kFrame * (std::fabs(form.a) + std::fabs(form.b)) + std::fabs(form.c) +
                                std::fabs(form.d));
  }
  if (bound == 0.0) return kNoExponent;
  int exponent = 0;
  std::frexp(bound, &exponent);  // bound < 2^exponent
  return exponent - (form_bits - 1);
}

FixedForm quantize(const LinearForm& form, const ZSteps& steps, int exponent) {
  const auto rounded = [exponent](double x) { return std::llrint(std::ldexp(x, -exponent)); };
  return {rounded(form.a / 2.0), rounded(form.b / 2.0), rounded(form.c / steps.one()),
          rounded(form.d), exponent};
}

FixedForm quantize_alone(const LinearForm& form, const ZSteps& steps, int form_bits) {
  return quantize(form, steps, common_exponent({&form, 1}, form_bits));
}

}  // namespace wedgesim::model::datapath

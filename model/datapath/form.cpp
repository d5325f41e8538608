#include "model/datapath/form.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
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

int least_form_bits(traces::fb::DepthFormat depth, unsigned width, unsigned height) {
  const auto steps = static_cast<std::uint64_t>(ZSteps(depth).one());
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

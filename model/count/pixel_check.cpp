#include "model/count/pixel_check.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "traces/depth.h"

namespace wedgesim::model {
namespace {

constexpr std::size_t kWorst = 10;
constexpr double kQuiet = 1.0 / 255.0;  // largest sensitivity that the RMS takes in

double tolerance_of(LiFormat format) { return format == LiFormat::exact ? 1e-6 : 2.0 / 255.0; }

// A 16-bit word: S5_11 for the default format, integers for paper255.
bool li_in_range(std::int64_t word, LiFormat format, std::int64_t one) {
  if (format == LiFormat::paper255) return word >= -32768 && word < 32768;
  return word >= -16 * one && word < 16 * one;
}

bool stencil_in_range(std::int64_t stencil) { return stencil >= -128 && stencil < 128; }

bool worse(const PixelError& a, const PixelError& b) {
  return std::tuple(-std::fabs(a.error), a.y, a.x) < std::tuple(-std::fabs(b.error), b.y, b.x);
}

class Comparison {
 public:
  explicit Comparison(LiFormat format) { check_.tolerance = tolerance_of(format); }

  void add(const PixelError& pixel) {
    const double size = std::fabs(pixel.error);
    check_.compared += 1;
    check_.max_error = std::max(check_.max_error, size);
    if (size > check_.tolerance + pixel.sensitivity) check_.mismatched += 1;
    if (pixel.sensitivity <= kQuiet) {
      quiet_ += 1;
      sum_of_squares_ += size * size;
    }
    if (size == 0.0 || (check_.worst.size() == kWorst && !worse(pixel, check_.worst.back()))) {
      return;
    }
    check_.worst.insert(std::upper_bound(check_.worst.begin(), check_.worst.end(), pixel, worse),
                        pixel);
    if (check_.worst.size() > kWorst) check_.worst.pop_back();
  }

  PixelCheck finish() {
    if (quiet_ > 0) check_.rms_error = std::sqrt(sum_of_squares_ / static_cast<double>(quiet_));
    return std::move(check_);
  }

 private:
  PixelCheck check_;
  std::uint64_t quiet_ = 0;
  double sum_of_squares_ = 0.0;
};

// One entry a position, in order, and none that adds nothing.
std::vector<Correction> gather(std::vector<Correction> corrections) {
  std::sort(corrections.begin(), corrections.end(),
            [](const Correction& a, const Correction& b) { return a.position < b.position; });
  std::vector<Correction> gathered;
  for (const Correction& correction : corrections) {
    if (gathered.empty() || gathered.back().position != correction.position) {
      gathered.push_back(correction);
      continue;
    }
    gathered.back().penumbra += correction.penumbra;
    gathered.back().umbra += correction.umbra;
  }
  return gathered;
}

}  // namespace

FinishedFrame::FinishedFrame(const ZFrame& frame, const LightImage& image, LiFormat format,
                             std::vector<Correction> corrections)
    : frame_(frame),
      image_(image),
      format_(format),
      one_(static_cast<std::int64_t>(word_one(format))),
      corrections_(gather(std::move(corrections))) {}

FinishedFrame::Sums FinishedFrame::sums(std::size_t position) const {
  std::int64_t penumbra = image_.penumbra(position);
  std::int64_t stencil = image_.umbra(position);
  if (!corrections_.empty()) {
    const auto found = std::lower_bound(
        corrections_.begin(), corrections_.end(), position,
        [](const Correction& correction, std::size_t at) { return correction.position < at; });
    if (found != corrections_.end() && found->position == position) {
      penumbra += found->penumbra;
      stencil += found->umbra;
    }
  }
  return {one_ + penumbra + stencil * one_, stencil};
}

FrameSummary FinishedFrame::summarize(const traces::TraceView& trace, bool compare_sky) const {
  FrameSummary summary;
  Comparison comparison(format_);
  const std::uint32_t sky = traces::sky_word(trace.header.depth_format);
  std::size_t pixel = 0;
  for (int y = 0; y < frame_.height(); ++y) {
    for (int x = 0; x < frame_.width(); ++x, ++pixel) {
      const std::size_t position = frame_.position(x, y);
      const auto [word, stencil] = sums(position);
      summary.li_writes_floor += word != one_ ? 1 : 0;
      summary.stencil_not_zero += stencil != 0 ? 1 : 0;
      const bool li_bad = !li_in_range(word, format_, one_);
      summary.li_out_of_range += li_bad ? 1 : 0;
      summary.any_out_of_range += li_bad || !stencil_in_range(stencil) ? 1 : 0;
      summary.contributions_max =
          std::max<std::uint64_t>(summary.contributions_max, image_.contributions(position));
      if (trace.expected_li.empty() || (!compare_sky && trace.depth[pixel] == sky)) continue;
      const double li = static_cast<double>(word) / word_one(format_);
      const double expected = trace.expected_li[pixel];
      const double sensitivity =
          trace.li_sensitivity.empty() ? 0.0 : static_cast<double>(trace.li_sensitivity[pixel]);
      comparison.add({x, y, expected, li, li - expected, sensitivity});
    }
  }
  summary.pixels = comparison.finish();
  return summary;
}

std::vector<std::int64_t> FinishedFrame::words() const {
  std::vector<std::int64_t> words;
  words.reserve(static_cast<std::size_t>(frame_.width()) *
                static_cast<std::size_t>(frame_.height()));
  for (int y = 0; y < frame_.height(); ++y) {
    for (int x = 0; x < frame_.width(); ++x) words.push_back(sums(frame_.position(x, y)).word);
  }
  return words;
}

}  // namespace wedgesim::model

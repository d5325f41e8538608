#include "model/count/pixel_check.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "traces/depth.h"

namespace wedgesim::model {
namespace {

constexpr std::size_t kWorst = 10;
constexpr double kQuiet = 1.0 / 255.0;  // largest sensitivity that the RMS takes in

bool worse(const PixelError& a, const PixelError& b) {
  return std::tuple(-std::fabs(a.error), a.y, a.x) < std::tuple(-std::fabs(b.error), b.y, b.x);
}

class Comparison {
 public:
  explicit Comparison(const Datapath& datapath) : datapath_(datapath) {
    check_.tolerance = datapath.tolerance();
  }

  void add(const PixelError& pixel, bool penumbra) {
    const double size = std::fabs(pixel.error);
    check_.compared += 1;
    check_.max_error = std::max(check_.max_error, size);
    if (!matches(pixel, datapath_)) check_.mismatched += 1;
    if (pixel.sensitivity <= kQuiet) {
      all_.add(size);
      if (penumbra) penumbra_.add(size);
    }
    if (size == 0.0 || (check_.worst.size() == kWorst && !worse(pixel, check_.worst.back()))) {
      return;
    }
    check_.worst.insert(std::upper_bound(check_.worst.begin(), check_.worst.end(), pixel, worse),
                        pixel);
    if (check_.worst.size() > kWorst) check_.worst.pop_back();
  }

  PixelCheck finish() {
    check_.rms_error = all_.root();
    check_.rms_penumbra = penumbra_.root();
    return std::move(check_);
  }

 private:
  struct MeanSquare {
    std::uint64_t count = 0;
    double sum = 0.0;

    void add(double error) {
      count += 1;
      sum += error * error;
    }
    double root() const { return count == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(count)); }
  };

  Datapath datapath_;
  PixelCheck check_;
  MeanSquare all_, penumbra_;
};

// The first pixel that is bad, by rows, whatever order they come in.
void note_first(std::optional<std::array<int, 2>>& first, bool bad, int x, int y) {
  if (!bad) return;
  if (!first || std::pair(y, x) < std::pair((*first)[1], (*first)[0])) first = {x, y};
}

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

std::optional<PixelError> compare_pixel(const traces::TraceView& trace, ZMethod method, int x,
                                        int y, std::int64_t word, const Datapath& datapath) {
  const std::size_t pixel =
      static_cast<std::size_t>(y) * trace.header.width + static_cast<std::size_t>(x);
  if (trace.expected_li.empty()) return {};
  const bool trace_fails = trace.header.expected_z_method == traces::fb::ZMethod_fail;
  const bool sky = trace.depth[pixel] == traces::sky_word(trace.header.depth_format);
  if (sky && trace_fails != (method == ZMethod::fail)) return {};
  const double li = static_cast<double>(word) / datapath.one();
  const double expected = trace.expected_li[pixel];
  const double sensitivity =
      trace.li_sensitivity.empty() ? 0.0 : static_cast<double>(trace.li_sensitivity[pixel]);
  return PixelError{x, y, expected, li, li - expected, sensitivity};
}

bool matches(const PixelError& pixel, const Datapath& datapath) {
  return std::fabs(pixel.error) <= datapath.tolerance() + pixel.sensitivity;
}

FinishedFrame::FinishedFrame(const ZFrame& frame, const LightImage& image, const Datapath& datapath,
                             std::vector<Correction> corrections)
    : frame_(frame),
      image_(image),
      datapath_(datapath),
      one_(static_cast<std::int64_t>(datapath.one())),
      corrections_(gather(std::move(corrections))) {}

FinishedFrame::BlockSums FinishedFrame::sums(std::size_t block) const {
  BlockSums sums;
  const std::size_t first = block * kBlockPixels;
  image_.sums(block, sums.words.data(), sums.stencil.data(), sums.contributions.data());
  auto wrong = std::lower_bound(
      corrections_.begin(), corrections_.end(), first,
      [](const Correction& correction, std::size_t at) { return correction.position < at; });
  for (; wrong != corrections_.end() && wrong->position < first + kBlockPixels; ++wrong) {
    sums.words[wrong->position - first] += wrong->penumbra;
    sums.stencil[wrong->position - first] += wrong->umbra;
  }
  for (std::size_t i = 0; i < kBlockPixels; ++i) {
    sums.words[i] += one_ + sums.stencil[i] * one_;
  }
  return sums;
}

template <typename F>
void FinishedFrame::for_each_pixel(std::uint32_t bx, std::uint32_t by, F&& f) const {
  const int x0 = static_cast<int>(bx) * kBlock;
  const int y0 = static_cast<int>(by) * kBlock;
  for (int y = y0; y < std::min(y0 + kBlock, frame_.height()); ++y) {
    for (int x = x0; x < std::min(x0 + kBlock, frame_.width()); ++x) {
      f(x, y, static_cast<std::size_t>(kBlock * (y - y0) + x - x0));
    }
  }
}

FrameSummary FinishedFrame::summarize(const traces::TraceView& trace, ZMethod method) const {
  FrameSummary summary;
  Comparison comparison(datapath_);
  frame_.for_each_block([&](std::uint32_t bx, std::uint32_t by) {
    const BlockSums block = sums(frame_.block(bx, by));
    const std::uint64_t inside = image_.inside_any(frame_.block(bx, by));
    for_each_pixel(bx, by, [&](int x, int y, std::size_t bit) {
      const std::int64_t word = block.words[bit];
      const std::int32_t stencil = block.stencil[bit];
      summary.li_writes_floor += word != one_ ? 1 : 0;
      summary.stencil_not_zero += stencil != 0 ? 1 : 0;
      const bool li_bad = !datapath_.li_holds(word);
      const bool any_bad = li_bad || !datapath_.stencil_holds(stencil);
      summary.li_out_of_range += li_bad ? 1 : 0;
      note_first(summary.li_overflow, li_bad, x, y);
      note_first(summary.any_overflow, any_bad, x, y);
      summary.any_out_of_range += any_bad ? 1 : 0;
      summary.contributions_max =
          std::max<std::uint64_t>(summary.contributions_max, block.contributions[bit]);
      const auto pixel = compare_pixel(trace, method, x, y, word, datapath_);
      if (pixel) comparison.add(*pixel, (inside >> bit & 1) != 0);
    });
  });
  summary.pixels = comparison.finish();
  return summary;
}

std::vector<std::int64_t> FinishedFrame::words() const {
  const auto width = static_cast<std::size_t>(frame_.width());
  std::vector<std::int64_t> words(width * static_cast<std::size_t>(frame_.height()));
  frame_.for_each_block([&](std::uint32_t bx, std::uint32_t by) {
    const BlockSums block = sums(frame_.block(bx, by));
    for_each_pixel(bx, by, [&](int x, int y, std::size_t bit) {
      words[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] = block.words[bit];
    });
  });
  return words;
}

}  // namespace wedgesim::model

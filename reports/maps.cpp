#include "reports/maps.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "base/check.h"
#include "reports/picture.h"

namespace wedgesim::reports {
namespace {

// Below one step of an 8-bit picture a difference is black.
constexpr float kSmallestDifferenceScale = 1.0F / 255.0F;

std::vector<float> floats_of(std::span<const std::uint32_t> counts) {
  std::vector<float> values(counts.size());
  std::ranges::transform(counts, values.begin(),
                         [](std::uint32_t count) { return static_cast<float>(count); });
  return values;
}

float maximum_of(std::span<const float> values, float at_least) {
  float maximum = at_least;
  for (const float value : values) maximum = std::max(maximum, value);
  return maximum;
}

// In double: far finer than the single precision of the maps.
std::vector<float> differences(std::span<const double> expected, std::span<const std::int64_t> li,
                               const model::Datapath& datapath) {
  std::vector<float> values(li.size());
  for (std::size_t i = 0; i < li.size(); ++i) {
    const double value = static_cast<double>(li[i]) / datapath.one();
    values[i] = static_cast<float>(std::abs(value - expected[i]));
  }
  return values;
}

}  // namespace

std::string to_text(const MapScales& scales) {
  return fmt::format("scales from 0 to {} z reads, {} LI writes, difference {:.2g}", scales.z_reads,
                     scales.li_writes, scales.difference);
}

std::vector<float> light_of(const model::CountResult& result, const model::Datapath& datapath) {
  std::vector<float> values(result.li.size());
  std::ranges::transform(result.li, values.begin(), [&datapath](std::int64_t word) {
    return static_cast<float>(static_cast<double>(word) / datapath.one());
  });
  return values;
}

MapScales write_maps(const std::string& prefix, const traces::TraceView& trace,
                     const model::CountResult& result, const model::Datapath& datapath) {
  const auto width = static_cast<int>(trace.header.width);
  const auto height = static_cast<int>(trace.header.height);
  const std::vector<float> li = light_of(result, datapath);
  const std::vector<float> reads = floats_of(result.z_reads);
  const std::vector<float> writes = floats_of(result.li_writes);
  CHECK_EQ(li.size(), trace.depth.size());
  MapScales scales;
  scales.z_reads = maximum_of(reads, 1.0F);
  scales.li_writes = maximum_of(writes, 1.0F);
  std::vector<std::function<void(const char*)>> files{
      [&](const char* kind) {
        write_heat(prefix + "_z_reads" + kind, reads, width, height, scales.z_reads);
      },
      [&](const char* kind) {
        write_heat(prefix + "_li_writes" + kind, writes, width, height, scales.li_writes);
      },
      [&](const char* kind) { write_values(prefix + "_li" + kind, li, width, height); }};
  std::vector<float> difference;
  if (!trace.expected_li.empty()) {
    difference = differences(trace.expected_li, result.li, datapath);
    scales.difference = maximum_of(difference, kSmallestDifferenceScale);
    files.emplace_back([&](const char* kind) {
      write_heat(prefix + "_difference" + kind, difference, width, height, scales.difference);
    });
  }
  tbb::parallel_for(std::size_t{0}, 2 * files.size(),
                    [&](std::size_t i) { files[i / 2](i % 2 == 0 ? ".png" : ".exr"); });
  return scales;
}

}  // namespace wedgesim::reports

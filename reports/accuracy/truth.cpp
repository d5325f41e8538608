#include "reports/accuracy/truth.h"

#include <algorithm>

#include "functional/reference/reference.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr int kFirstRays = 64;

// Whether a pixel and its neighbours, those of the sky apart, all have the same value, 0 or 1.
std::vector<std::uint8_t> in_doubt(const functional::DepthBuffer& depth,
                                   const std::vector<float>& first) {
  const std::size_t channels = first.size() / depth.words.size();
  std::vector<std::uint8_t> doubt(depth.words.size());
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(depth.width) +
           static_cast<std::size_t>(x);
  };
  for (int y = 0; y < depth.height; ++y) {
    for (int x = 0; x < depth.width; ++x) {
      const std::size_t pixel = index(x, y);
      if (depth.triangle[pixel] == functional::DepthBuffer::kSky) continue;
      const float own = first[pixel * channels];
      bool settled = own == 0.0F || own == 1.0F;
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, depth.height - 1); ++j) {
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, depth.width - 1); ++i) {
          const std::size_t other = index(i, j);
          if (depth.triangle[other] == functional::DepthBuffer::kSky) continue;
          for (std::size_t c = 0; c < channels; ++c) {
            settled = settled && first[other * channels + c] == own;
          }
        }
      }
      doubt[pixel] = settled ? 0 : 1;
    }
  }
  return doubt;
}

}  // namespace

std::vector<float> reference_where_it_matters(const functional::Scene& scene,
                                              const functional::Window& window,
                                              const functional::DepthBuffer& depth, int rays) {
  std::vector<float> truth = functional::reference_visibility(
      scene, window, depth, std::min(rays, kFirstRays), kTruthSeed);
  if (rays <= kFirstRays) return truth;
  const std::vector<std::uint8_t> doubt = in_doubt(depth, truth);
  const std::vector<float> many =
      functional::reference_visibility(scene, window, depth, rays, kTruthSeed, doubt);
  const std::size_t channels = truth.size() / doubt.size();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (doubt[i / channels] != 0) truth[i] = many[i];
  }
  return truth;
}

}  // namespace wedgesim::reports::accuracy

#include "functional/raster/depth_fit.h"

#include <algorithm>
#include <vector>

namespace wedgesim::functional {
namespace {

// (height, width)
std::vector<double> view_distances(const Window& window, const DepthBuffer& depth) {
  std::vector<double> distances;
  distances.reserve(depth.words.size());
  for (const std::uint32_t word : depth.words) {
    distances.push_back(view_distance(window, traces::decode_depth(depth.format, word)));
  }
  return distances;
}

}  // namespace

DepthFit fit_depth(const Window& window, const DepthBuffer& depth, const DepthBuffer& meshes,
                   double tolerance) {
  const std::vector<double> seen = view_distances(window, depth);
  const std::vector<double> mesh = view_distances(window, meshes);
  const auto at = [&window](int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
           static_cast<std::size_t>(x);
  };
  DepthFit fit;
  for (int y = 0; y < window.height; ++y) {
    for (int x = 0; x < window.width; ++x) {
      bool covered = true;
      double low = mesh[at(x, y)];
      double high = low;
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, window.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, window.width - 1); ++u) {
          covered = covered && meshes.triangle[at(u, v)] != DepthBuffer::kSky;
          low = std::min(low, mesh[at(u, v)]);
          high = std::max(high, mesh[at(u, v)]);
        }
      }
      const double here = seen[at(x, y)];
      if (!covered) {
        if (meshes.triangle[at(x, y)] == DepthBuffer::kSky) continue;
        fit.outline += 1;
        fit.outline_behind += here > mesh[at(x, y)] * (1.0 + tolerance) ? 1 : 0;
        continue;
      }
      fit.meshes += 1;
      if (here < low * (1.0 - tolerance)) {
        fit.hidden += 1;
      } else if (here <= high * (1.0 + tolerance)) {
        fit.agree += 1;
      } else {
        fit.behind += 1;
        if (!fit.first_behind) fit.first_behind = {x, y};
      }
    }
  }
  return fit;
}

}  // namespace wedgesim::functional

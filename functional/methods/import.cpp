#include "functional/methods/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

/// What an image must agree with.
struct Meshes {
  DepthBuffer casters;  // alone: what shadows come from
  DepthBuffer all;      // of the scene; an image may show more
};

Meshes render_meshes(const Scene& scene, const Window& window, traces::fb::DepthFormat format) {
  std::vector<Object> casters;
  std::ranges::copy_if(scene.objects, std::back_inserter(casters), &Object::casts);
  return {render_depth(window, casters, format), render_depth(window, scene.objects, format)};
}

/// The fit to the casters, or that to everything where only this one is bad.
DepthFit worse_fit(const Window& window, const DepthBuffer& depth, const Meshes& meshes,
                   double tolerance) {
  const DepthFit casters = fit_depth(window, depth, meshes.casters, tolerance);
  if (!casters.fits()) return casters;
  const DepthFit all = fit_depth(window, depth, meshes.all, tolerance);
  return all.fits() ? casters : all;
}

// Which options would make the image fit, and in more pixels than `agree`; empty if none would.
std::string what_would_fit(const Window& window, const Image& image, const Meshes& meshes,
                           const ImportOptions& options, std::size_t agree) {
  std::string best;
  const std::size_t channel = depth_channel(image, options.channel, "");
  const Image turned = flipped(image);
  for (const bool flip : {options.flip, !options.flip}) {
    for (const auto& [name, meaning] : kDepthMeanings) {
      try {
        const DepthBuffer depth =
            depth_of_image(flip ? turned : image, channel, meaning, window, meshes.all.format, "");
        const DepthFit fit = worse_fit(window, depth, meshes, options.tolerance);
        if (!fit.fits() || 2 * fit.agree < fit.meshes || fit.agree <= agree) continue;
        agree = fit.agree;
        best = fmt::format("--meaning {}{}", name, flip ? " --flip" : "");
      } catch (const InputError&) {  // not this one
      }
    }
  }
  return best;
}

}  // namespace

Import import_frame(const Scene& scene, const Image& image, const ImportOptions& options,
                    const std::string& place) {
  const Window window = make_window(scene.camera, scene.width, scene.height);
  const traces::fb::DepthFormat format = options.frame.depth_format;
  const DepthBuffer depth = depth_of_image(options.flip ? flipped(image) : image,
                                           depth_channel(image, options.channel, place),
                                           options.meaning, window, format, place);
  const Meshes meshes = render_meshes(scene, window, format);
  Import import;
  import.fit = worse_fit(window, depth, meshes, options.tolerance);
  if (!import.fit.fits()) {
    const auto [x, y] = *import.fit.first_behind;
    const std::string fits = what_would_fit(window, image, meshes, options, 0);
    throw InputError(place,
                     fmt::format("shows what lies behind the meshes at {} of their {} pixels, "
                                 "first at {},{}",
                                 import.fit.behind, import.fit.meshes, x, y),
                     fits.empty() ? "the same camera, near and far planes and meshes as the image's"
                                  : "options that fit: " + fits);
  }
  // Casters may be hidden, but hardly by what another reading of the image takes away.
  if (100 * import.fit.hidden > import.fit.meshes) {
    const std::string better =
        what_would_fit(window, image, meshes, options, import.fit.agree + import.fit.hidden / 2);
    if (!better.empty()) {
      throw InputError(place,
                       fmt::format("hides the casters at {} of their {} pixels", import.fit.hidden,
                                   import.fit.meshes),
                       "options that fit better: " + better);
    }
  }
  import.sky = static_cast<std::size_t>(std::ranges::count(depth.words, traces::sky_word(format)));
  FrameOptions frame_options = options.frame;
  frame_options.depth = &depth;
  import.frame = make_frame(scene, frame_options);
  return import;
}

}  // namespace wedgesim::functional

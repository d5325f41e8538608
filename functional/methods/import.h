#pragma once

#include <string>

#include "base/image.h"
#include "functional/methods/frame.h"
#include "functional/raster/depth_fit.h"
#include "functional/raster/depth_image.h"

namespace wedgesim::functional {

struct ImportOptions {
  DepthMeaning meaning = DepthMeaning::window;
  std::string channel;       // of the image; empty: the only one, or Z
  bool flip = false;         // rows come from below
  double tolerance = 0.005;  // of DepthFit
  FrameOptions frame;
};

struct Import {
  Frame frame;
  DepthFit fit;         // to the casters
  std::size_t sky = 0;  // pixels
};

/// A frame of another renderer as a trace: its depth, and the shadow volumes of the scene's casters
/// for its camera and light. Objects that cast nothing help to check the fit.
/// \param place  the image's file, as errors name it
/// \throws InputError if image, camera and meshes do not fit together; says what would
Import import_frame(const Scene& scene, const Image& image, const ImportOptions& options,
                    const std::string& place);

}  // namespace wedgesim::functional

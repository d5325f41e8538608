#pragma once

#include <optional>

#include "functional/methods/shadow_geometry.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"
#include "traces/trace.h"

namespace wedgesim::functional {

struct FrameOptions {
  traces::fb::WedgeKind kind = traces::fb::WedgeKind_coverage;
  traces::fb::DepthFormat depth_format = traces::fb::DepthFormat_unorm24;
  std::optional<double> length;  // of the volumes, world units; none: just beyond the receivers
  std::optional<traces::fb::ZMethod> z_method;  // none: z-pass unless the eye needs z-fail
  bool expected_li = true;                      // without: depth and geometry only
  /// Of another renderer, in the place of the scene's own; it may show more than the scene holds.
  const DepthBuffer* depth = nullptr;
};

/// A rendered frame: the trace the block reads and what the renderer knows besides.
struct Frame {
  Window window;
  DepthBuffer depth;
  glm::dvec3 origin{0.0};        // world position that geometry is taken from (origin.h)
  Bounds receivers;              // of all that receives, about `origin`
  bool depth_given = false;      // by another renderer
  std::optional<double> length;  // FrameOptions::length
  ShadowGeometry geometry;       // world axes, about `origin`
  traces::Trace trace;
};

/// Renders a scene into a trace with expected light intensity.
/// \throws InputError if the scene cannot be shadowed (light touching a caster, z-pass impossible)
Frame make_frame(const Scene& scene, const FrameOptions& options = {});

}  // namespace wedgesim::functional

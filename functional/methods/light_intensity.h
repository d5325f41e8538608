#pragma once

#include <vector>

#include "functional/methods/shadow_geometry.h"
#include "functional/raster/clip.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "traces/trace.h"

namespace wedgesim::functional {

/// Light intensity of every pixel, not clamped: 1 = fully lit, minus what the shadow volumes take.
struct LightIntensity {
  std::vector<double> li;          // (height, width)
  std::vector<float> sensitivity;  // larger change of li when the stored z moves one step
};

/// Evaluates the light intensity as the papers define it (Paper II, 3; Paper III, 3.2), in world
/// space and double precision: umbra polygons by their snapped outlines, penumbrae by the wedges'
/// world planes alone, without their polygons.
/// \param trace  the sections that build_shadow_geometry filled
LightIntensity evaluate_light_intensity(const Scene& scene, const Window& window,
                                        const DepthBuffer& depth, const ShadowGeometry& geometry,
                                        const traces::Trace& trace, traces::fb::ZMethod method);

/// The snapped outline of a polygon of a trace, by its indices.
std::vector<SnappedPoint> outline_of(const traces::Trace& trace, std::uint32_t first,
                                     std::uint32_t count);

/// The share of a wedge in the light intensity of a point inside it: linear, the intensity of
/// Paper I, Eqs. 2 and 3; coverage, plus or minus the covered fraction.
/// \param inner  the point is on the shadow's side of the umbra polygon
double penumbra_share(const Light& light, traces::fb::WedgeKind kind, const ShadowWedge& wedge,
                      const glm::dvec3& world, const glm::dvec3& in_light, bool inner);

}  // namespace wedgesim::functional

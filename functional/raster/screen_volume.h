#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "functional/raster/clip.h"
#include "traces/trace_generated.h"

namespace wedgesim::functional {

/// A value linear in window space: ((x·X + y·Y) + z·Z) + w, X and Y in pixels.
using WindowForm = glm::dvec4;

/// A convex polygon of a shadow volume on the screen.
struct ScreenUmbra {
  std::vector<SnappedPoint> outline;  // empty: none
  traces::fb::UmbraRole role = traces::fb::UmbraRole_side;
  bool eye_facing = false;
  bool z_fail = false;  // how its volume counts
  double z_min = 0.0;   // of the unsnapped polygon
  double z_max = 0.0;
};

/// A penumbra wedge on the screen.
struct ScreenWedge {
  std::vector<WindowForm> planes;  // a point inside has none below 0; more points may
  std::vector<glm::dvec2> hull;    // convex outline on the screen, pixels; empty: no wedge
  /// Its parts outside and inside of the shadow are drawn one after the other (Paper IV, 4.4), each
  /// in its own outline; empty: nothing of it is in view.
  bool in_halves = false;
  std::array<std::vector<glm::dvec2>, 2> half_hulls;
  /// What a share of light is computed from at a point: window forms and constants.
  std::array<WindowForm, 8> forms{};
  std::array<float, 8> constants{};
};

/// A silhouette edge's umbra polygon and wedge, or a polygon alone, and the plane that decides for
/// both on which side of the shadow a point is.
struct ScreenSide {
  WindowForm plane{0.0};  // `inner` iff (value ≥ 0) differs from `minus`
  bool minus = false;
  ScreenUmbra umbra;
  ScreenWedge wedge;
  int y_begin = 0;  // rows that either may touch
  int y_end = 0;
  std::uint32_t group = 0;  // of silhouette loops that shadow together
};

}  // namespace wedgesim::functional

#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "reports/stress/measure.h"

namespace wedgesim::reports::stress {

/// A silhouette edge or a polygon without one, and what it does wrong at one pixel.
struct Culprit {
  std::optional<std::uint32_t> wedge;    // index in the trace
  std::optional<std::uint32_t> polygon;  // its umbra polygon in the trace
  double li = 0.0, judge = 0.0;          // its share in the pixel's LI
  bool has_edge = false;                 // bottoms, caps and linear wedges may have none
  glm::dvec3 begin{0.0}, end{0.0};       // world space
  double error() const { return li - judge; }
};

/// A failure in as few edges as show it.
struct Shrunk {
  Arithmetic arithmetic = Arithmetic::fixed;
  int x = 0, y = 0;  // the pixel that is farthest off, beyond its sensitivity
  double li = 0.0, judge = 0.0, sensitivity = 0.0;
  double sum = 0.0;               // LI that all parts add up to, however wide
  std::size_t parts = 0;          // edges and lone polygons of the frame
  std::vector<Culprit> culprits;  // the largest error first; none if they do not pass the bar
};

/// Contributions add up, so the fewest edges whose errors alone pass the bar at the worst pixel are
/// those with the largest errors of the sum's sign. Where the sum leaves LI's word none is to
/// blame. \param measurement  of the case, with its pictures \return             none if no pixel
/// is beyond the bar
std::optional<Shrunk> shrink(const Case& stress_case, const Measurement& measurement,
                             Arithmetic arithmetic);

std::string shrunk_text(const Shrunk& shrunk);

}  // namespace wedgesim::reports::stress

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "functional/methods/frame.h"

namespace wedgesim::reports::stress {

/// What adds to light intensity by itself: a wedge with its umbra polygon, an edge without a wedge
/// with its, or a lone polygon. Indices: of the trace, `bare` of ShadowGeometry::bare_edges.
struct Part {
  std::optional<std::uint32_t> wedge, bare, polygon;
};

std::vector<Part> parts_of(const functional::Frame& frame);

/// Frames that hold a single part of a frame each. The tables of vertices and planes are kept.
class PartFrame {
 public:
  explicit PartFrame(const functional::Frame& whole);
  /// \return valid until the next call
  const functional::Frame& only(const Part& part);

 private:
  void add_polygon(std::uint32_t polygon, std::uint32_t wedge);
  const functional::Frame& whole_;
  functional::Frame frame_;
};

}  // namespace wedgesim::reports::stress

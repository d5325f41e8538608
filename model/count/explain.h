#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/count/config.h"
#include "model/count/plane.h"
#include "model/count/primitive.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// A face that covers the pixel.
struct FaceExplanation {
  std::uint32_t face = 0;       // index in the trace
  Cull culled_by = Cull::none;  // the test that culls it in the pixel's tile; none: it survives
};

/// One plane of a wedge at the pixel.
struct PlaneExplanation {
  std::uint32_t reference = 0;  // 2 * index + sign, as in the trace
  double value = 0.0;           // v, before the sign of the reference
  bool inside = false;
};

/// An umbra polygon that covers the pixel.
struct UmbraExplanation {
  enum class Outcome { read, culled, accepted, cap };

  std::uint32_t polygon = 0;  // index in the trace
  traces::fb::UmbraRole role = traces::fb::UmbraRole_side;
  bool eye_facing = false;
  double value = 0.0;             // its plane's v; 0 for a cap
  bool interval_decides = false;  // z is outside the polygon's own interval
  bool inner = false;
  bool hit = false;  // passed in z-pass, failed in z-fail
  bool shared = false;
  Outcome outcome = Outcome::read;
  bool written = false;
  int step = 0;  // what is written, in full lights; 0 if nothing
};

/// A wedge, or an umbra polygon without one, that covers the pixel.
struct WedgeExplanation {
  std::optional<std::uint32_t> wedge;  // index in the trace
  traces::fb::WedgeKind kind = traces::fb::WedgeKind_coverage;
  std::vector<FaceExplanation> faces;
  std::vector<PlaneExplanation> planes;  // if a face covers the pixel
  ZInterval z;                           // a point inside has its depth in here
  bool inside = false;
  bool inner = false;      // coverage: added, not subtracted
  std::int64_t words = 0;  // penumbra written, words of 2^-40
  std::optional<UmbraExplanation> umbra;
  unsigned z_reads = 0;
  unsigned li_writes = 0;  // stencil writes included
};

/// Everything that happens to one pixel.
struct Explanation {
  int x = 0, y = 0;
  CountConfig config;
  ZMethod method = ZMethod::pass;
  std::uint32_t depth_word = 0;
  double z = 0.0;
  bool sky = false;
  Box tile;
  std::vector<WedgeExplanation> wedges;  // in trace order
  unsigned z_reads = 0;
  unsigned li_writes = 0;
  std::int64_t word = 0;  // final LI in words of 2^-40: fully lit and all contributions
  std::optional<double> expected;
};

/// Explains a pixel wedge by wedge: facing, planes, tests of its tile, accesses, contributions.
/// \param trace  sound: traces::verify passes
/// \param x, y   pixel
/// \throws       InputError if the pixel is outside the frame, and as count() does
Explanation explain(const traces::TraceView& trace, int x, int y, const CountConfig& config);

/// The same as lines of text.
std::string to_text(const Explanation& explanation);

}  // namespace wedgesim::model

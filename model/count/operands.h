#pragma once

#include <cstdint>

#include "model/count/config.h"
#include "model/count/contribution.h"
#include "model/count/plane.h"
#include "model/count/traffic.h"
#include "model/datapath/form.h"
#include "model/datapath/formats.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// What the arithmetic of a count is, and the words it writes.
struct Datapath {
  DatapathKind kind = DatapathKind::exact;
  datapath::Formats formats;  // of `fixed`

  Datapath() = default;
  Datapath(DatapathKind chosen) : kind(chosen) {}  // implicit: mostly the formats are the default's

  /// What 1.0 is, in words.
  double one() const;
  /// Is the true sum of a pixel in the range of its word?
  bool li_holds(std::int64_t word) const;
  bool stencil_holds(std::int64_t stencil) const;
  /// Of a word in memory.
  WordBytes word_bytes() const {
    if (kind != DatapathKind::fixed) return {};
    return {bytes_of_bits(formats.li.bits()), bytes_of_bits(formats.stencil_bits)};
  }
  /// How far a pixel may be off, in units of full light, besides its own sensitivity.
  double tolerance() const { return kind == DatapathKind::exact ? 1e-6 : 2.0 / 255.0; }
};

/// A trace's numbers as a datapath takes them. The exact one takes window depths and the trace's
/// planes, float32 rounds each to single precision; the fixed one takes depths in steps and planes
/// in integers.
class Operands {
 public:
  /// Implicit: mostly the datapath is the exact one.
  Operands(const traces::TraceView& trace, const Datapath& datapath = {});

  const traces::TraceView& trace() const { return trace_; }
  /// \param reference  2 * index + sign, index in range
  Plane plane(std::uint32_t reference) const;
  /// A closed interval of depth.
  ZInterval interval(double z_min, double z_max) const;
  /// An interval that holds this one, whatever rounding does.
  ZInterval around(double z_min, double z_max) const;
  /// A stored depth.
  double depth(std::uint32_t word) const;
  /// Depth 1.
  double far() const;
  /// The depths by which a face or the wedge's vertices may cull a tile: the given ones, but
  /// in single precision the wedge's, since a pixel can be inside all planes by a rounding error
  /// that is larger than what such an interval leaves out.
  ZInterval culling_interval(ZInterval own, ZInterval wedge) const {
    return single() ? wedge : own;
  }
  /// Per-wedge constants of the light intensity or coverage.
  LightTerms terms(const traces::fb::Wedge& wedge) const;

 private:
  bool fixed() const { return datapath_.kind == DatapathKind::fixed; }
  bool single() const { return datapath_.kind == DatapathKind::float32; }

  const traces::TraceView& trace_;
  Datapath datapath_;
  datapath::ZSteps steps_;
};

}  // namespace wedgesim::model

#pragma once

#include <cstdint>
#include <vector>

#include "model/count/footprint.h"

namespace wedgesim::model {

/// What a wrong culling or acceptance of one configuration does to one pixel: nothing is assumed
/// of the tile tests, so a contribution that is lost is lost.
struct Correction {
  std::size_t position = 0;  // in block order
  std::int64_t penumbra = 0;
  std::int32_t umbra = 0;
};

/// Sums of contributions, in block order, filled by many threads.
class LightImage {
 public:
  explicit LightImage(const ZFrame& frame);

  /// Adds all inside pixels and all hits of a footprint.
  void add(const Primitive& primitive, const Footprint& footprint, const ZFrame& frame);

  std::int64_t penumbra(std::size_t position) const { return penumbra_[position]; }
  std::int32_t umbra(std::size_t position) const { return umbra_[position]; }
  /// Contributions to a pixel, umbra and penumbra.
  std::uint32_t contributions(std::size_t position) const { return contributions_[position]; }
  /// Distinct pixels inside at least one wedge.
  std::uint64_t pixels_inside_any() const;

 private:
  std::vector<std::int64_t> penumbra_;  // words
  std::vector<std::int32_t> umbra_;     // full lights, a wide stencil
  std::vector<std::uint32_t> contributions_;
  std::vector<std::uint64_t> inside_any_;  // a word a block
};

}  // namespace wedgesim::model

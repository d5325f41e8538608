#include <algorithm>

#include "model/count/bits.h"
#include "model/count/kernel.h"

namespace wedgesim::model {
namespace {

void inside(const Primitive& wedge, std::span<const Block> blocks, const std::uint64_t* candidates,
            std::uint64_t* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::uint64_t bits = 0;
    for_each_bit(candidates[i], [&](int bit) {
      const double z = blocks[i].z[bit];
      if (!(z >= wedge.z.min && z <= wedge.z.max)) return;
      const double x = centre_x(blocks[i], bit);
      const double y = centre_y(blocks[i], bit);
      for (const Plane& plane : wedge.planes) {
        if (!plane.inside(x, y, z)) return;
      }
      bits |= std::uint64_t{1} << bit;
    });
    result[i] = bits;
  }
}

void umbra(const Plane& plane, ZInterval interval, std::span<const Block> blocks,
           const std::uint64_t* candidates, UmbraBits* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    UmbraBits bits;
    for_each_bit(candidates[i], [&](int bit) {
      const double z = blocks[i].z[bit];
      const std::uint64_t one = std::uint64_t{1} << bit;
      if (plane.inside(centre_x(blocks[i], bit), centre_y(blocks[i], bit), z)) bits.inner |= one;
      if (z < interval.min) bits.before |= one;
      if (z > interval.max) bits.beyond |= one;
    });
    result[i] = bits;
  }
}

void words(const LightTerms& terms, double one, std::span<const Block> blocks,
           const std::uint64_t* sets, const std::uint64_t* negated, std::int64_t* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i, result += kBlockPixels) {
    if (sets[i] != 0) std::fill_n(result, kBlockPixels, 0);
    for_each_bit(sets[i], [&](int bit) {
      const std::int64_t word = to_word(
          contribution(terms, centre_x(blocks[i], bit), centre_y(blocks[i], bit), blocks[i].z[bit]),
          one);
      result[bit] = (negated[i] >> bit & 1) != 0 ? -word : word;
    });
  }
}

}  // namespace

const Kernel& scalar_kernel() {
  static const Kernel kernel{"scalar", inside, umbra, words};
  return kernel;
}

}  // namespace wedgesim::model

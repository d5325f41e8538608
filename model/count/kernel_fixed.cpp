#include "model/count/bits.h"
#include "model/count/kernel.h"

namespace wedgesim::model {
namespace {

// The pixels of a block that are inside a plane, among `candidates`: all, none, or one by one from
// the value at the block's corner, as hardware does.
std::uint64_t inside_plane(const Plane& plane, const Block& block, const Box& box,
                           std::uint64_t candidates) {
  const bool far_inside = plane.inward_c() >= 0.0;
  if (!plane.reaches(box, far_inside ? box.z.max : box.z.min)) return 0;
  if (plane.holds(box, far_inside ? box.z.min : box.z.max)) return candidates;
  const datapath::FixedForm& form = plane.form;
  const std::int64_t corner =
      form.at(datapath::place(block.bx * 8.0 + 0.5, block.by * 8.0 + 0.5, 0.0));
  std::uint64_t inside = 0;
  for_each_bit(candidates, [&](int bit) {
    const std::int64_t value = corner + 2 * (form.a * (bit & 7) + form.b * (bit >> 3)) +
                               form.c * static_cast<std::int64_t>(block.z[bit]);
    if ((value >= 0) != plane.minus) inside |= std::uint64_t{1} << bit;
  });
  return inside;
}

Box box_of(const Block& block) {
  return {block.bx * 8.0, block.bx * 8.0 + 8.0, block.by * 8.0, block.by * 8.0 + 8.0,
          block.z_interval};
}

std::uint64_t where(const Block& block, std::uint64_t candidates, const auto& holds) {
  std::uint64_t bits = 0;
  for_each_bit(candidates, [&](int bit) {
    if (holds(block.z[bit])) bits |= std::uint64_t{1} << bit;
  });
  return bits;
}

void inside(const Primitive& wedge, std::span<const Block> blocks, const std::uint64_t* candidates,
            std::uint64_t* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    const Box box = box_of(block);
    std::uint64_t left =
        where(block, candidates[i], [&](double z) { return z >= wedge.z.min && z <= wedge.z.max; });
    for (const Plane& plane : wedge.planes) {
      if (left == 0) break;
      left = inside_plane(plane, block, box, left);
    }
    result[i] = left;
  }
}

void umbra(const Plane& plane, ZInterval interval, std::span<const Block> blocks,
           const std::uint64_t* candidates, UmbraBits* result) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block& block = blocks[i];
    result[i] = {inside_plane(plane, block, box_of(block), candidates[i]),
                 where(block, candidates[i], [&](double z) { return z < interval.min; }),
                 where(block, candidates[i], [&](double z) { return z > interval.max; })};
  }
}

}  // namespace

const Kernel& fixed_kernel() {
  static const Kernel kernel{"fixed", inside, umbra, scalar_kernel().words};
  return kernel;
}

}  // namespace wedgesim::model

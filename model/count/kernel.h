#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/count/primitive.h"
#include "model/count/z_frame.h"

namespace wedgesim::model {

/// One block of a primitive's pixels; sets as in z_frame.h.
struct Block {
  std::uint32_t bx = 0, by = 0;
  const double* z = nullptr;  // 64 depths, row by row
  ZInterval z_interval;       // around them
};

/// The centre of one of a block's pixels.
inline double centre_x(const Block& block, int bit) { return block.bx * 8.0 + (bit & 7) + 0.5; }
inline double centre_y(const Block& block, int bit) { return block.by * 8.0 + (bit >> 3) + 0.5; }

/// What the umbra polygon's plane and interval say at a block's pixels.
struct UmbraBits {
  std::uint64_t inner = 0;   // inside the plane
  std::uint64_t before = 0;  // z below the polygon's interval
  std::uint64_t beyond = 0;  // z above it
};

/// The loops over pixels. Every kernel gives the same bits.
struct Kernel {
  const char* name;
  /// inside[i] = the pixels of candidates[i] inside the wedge: all planes, and z in its interval.
  void (*inside)(const Primitive& wedge, std::span<const Block> blocks,
                 const std::uint64_t* candidates, std::uint64_t* inside);
  /// Umbra bits at the pixels of candidates[i]; other bits are undefined.
  /// \param interval  the polygon's
  void (*umbra)(const Plane& plane, ZInterval interval, std::span<const Block> blocks,
                const std::uint64_t* candidates, UmbraBits* bits);
  /// words[64*i + bit] = the contribution of a pixel of sets[i], with its sign changed if it is in
  /// negated[i]; 0 at other pixels of a block whose set is not empty, undefined if it is.
  /// \param one  Datapath::one()
  void (*words)(const LightTerms& terms, double one, std::span<const Block> blocks,
                const std::uint64_t* sets, const std::uint64_t* negated, std::int64_t* words);
};

/// The plain loop, which says what the others must give; for every datapath.
const Kernel& scalar_kernel();

/// For the fixed datapath: integers, block by block.
const Kernel& fixed_kernel();

/// For the exact datapath, by Highway, for every instruction set that this processor runs, the
/// widest first; the first.
const std::vector<Kernel>& simd_kernels();
const Kernel& simd_kernel();

}  // namespace wedgesim::model

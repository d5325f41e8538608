#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "functional/geometry/disk_volumes.h"
#include "functional/raster/light_map.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Which of several crossings of a ray with umbra (penumbra) volumes a texel keeps.
enum class Crossing {
  /// Of one caster the nearest, which trims its umbra quads, but the farthest where the ray enters
  /// the caster more than once; of several casters the farthest.
  by_caster,
  farthest,  // of all: the paper's choice for concave and overlapping occluders
  nearest    // of all
};

struct DBufferOptions {
  int resolution = 1024;
  Distances distances = Distances::exact;
  Crossing crossing = Crossing::by_caster;
  /// |cx_s| kept for the umbra and the penumbra apart; without, one |cx_s|, and texels behind whose
  /// occluder the umbra is hold no penumbra (the paper's stencil).
  bool two_edges = false;
};

/// What the light disk's centre c sees in each texel (seed 002, section 3), by inverse distances
/// from c: what is not there is at infinity, 0, and shares of a penumbra need no division but one.
struct DBuffer {
  struct Texel {
    /// 1/|cx_o|: a little before the ray leaves the first caster, so that texels take neither what
    /// the light falls on nor what the caster stands on for the other side; of a thinner caster as
    /// far behind its lit face as that differs over a texel.
    float occluder;
    float umbra;     // 1/|cx_uv|: where it leaves the umbra; -1 where it enters none
    float penumbra;  // 1/|cx_pv|: where it enters the penumbra
    float edge;      // 1/|cx_s|
  };
  struct Count {
    std::uint64_t tests = 0;   // texels that drawn triangles cover, each read once
    std::uint64_t writes = 0;  // texels that they changed
  };

  LightView view;  // of width 0 if nothing casts
  int width = 0;   // texels of one row
  std::unique_ptr<Texel[]> texels;
  std::unique_ptr<float[]> penumbra_edge;  // 1/|cx_s| for |cx_pv|, if it is kept apart
  Count count;
};

/// Draws the D-buffer of a scene.
/// \param volumes, silhouettes  of each object that casts, in order
DBuffer draw_d_buffer(const Scene& scene, const LightDisk& disk,
                      const std::vector<DiskSilhouettes>& silhouettes,
                      const std::vector<DiskVolumes>& volumes, const DBufferOptions& options);

}  // namespace wedgesim::functional

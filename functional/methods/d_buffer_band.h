#pragma once

#include <tbb/cache_aligned_allocator.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "functional/geometry/disk_volumes.h"
#include "functional/methods/d_buffer_map.h"
#include "functional/raster/light_map.h"

namespace wedgesim::functional {

/// What of a caster is drawn into a D-buffer.
struct DBufferCaster {
  static constexpr std::uint8_t kLit = 1;   // tag of faces that some of the light is in front of
  static constexpr std::uint8_t kQuad = 1;  // tag of umbra sides that are not of the back belt
  MapTriangles faces;
  MapTriangles umbra;
  MapTriangles penumbra;  // the sides where rays enter
};

/// A scene ready to be drawn into a D-buffer. Interpolated triangles have as `value` distances from
/// the light's centre, as `other` those of the silhouette edges; exact ones as `other` the ratio of
/// both.
struct DBufferDrawing {
  const LightView& view;
  const DBufferOptions& options;
  MapTriangles receivers;  // the surfaces of all that only receives
  std::vector<DBufferCaster> casters;
};

/// Rows of a D-buffer being drawn, in blocks of texels: all planes of a block, then the next block,
/// so that slivers, as most sides of volumes are, touch few places in memory with full vectors.
/// What is not yet a texel of the map is kept as keys: 1/w of the place on the ray, or its
/// interpolated distance's inverse; greater is nearer.
class DBufferBand {
 public:
  enum Plane : std::size_t {
    surface,        // of the nearest surface of all that is there
    occluder,       // of the map so far; 0 where nothing is
    umbra,          // kNoUmbra where there is none, 0 where a ray never leaves it
    umbra_edge,     // of the map's |cx_s|
    penumbra,       // 0 where there is none
    penumbra_edge,  // if it is kept apart
    entries,        // of the caster being drawn: how often a ray enters it
    inside,         // umbra volumes entered less those left
    entry,          // the nearest entry; 0 if none
    behind_entry,   // a place that is not lit
    exit,           // the nearest place where a ray leaves it
    nearest,        // side of its volume, with its edge; 0 if none
    nearest_edge,
    farthest,
    farthest_edge,
    kPlanes
  };
  static constexpr float kNoUmbra = -1.0F;
  static constexpr int kRows = MapTriangles::kBandRows;

  explicit DBufferBand(int width)
      : blocks_(static_cast<std::size_t>((width + kBlockEdge - 1) / kBlockEdge)),
        words_(kRows / kBlockEdge * blocks_ * kBlockWords) {}

  /// A block's words of its first plane; those of others are word(plane) further on.
  float* block(int column, int row) {
    return words_.data() +
           (static_cast<std::size_t>(row) * blocks_ + static_cast<std::size_t>(column)) *
               kBlockWords;
  }
  static constexpr std::size_t word(Plane plane) { return plane * kBlock; }

  void clear() {
    for (std::size_t i = 0; i < words_.size(); i += kBlockWords) {
      std::fill_n(&words_[i], kBlockWords, 0.0F);
      std::fill_n(&words_[i + word(umbra)], kBlock, kNoUmbra);
    }
  }

 private:
  static constexpr std::size_t kBlockWords = kPlanes * kBlock;
  std::size_t blocks_;  // side by side
  std::vector<float, tbb::cache_aligned_allocator<float>> words_;
};

/// Draws a band of a D-buffer's rows; bands do not depend on each other.
/// \param texels  of the band; \param scratch  of the calling thread
void draw_d_buffer_band(const DBufferDrawing& drawing, int band, DBufferBand& scratch, DBuffer& map,
                        DBuffer::Count& count);

}  // namespace wedgesim::functional

#pragma once

#include <string>

#include "functional/methods/frame.h"
#include "functional/scene/scene.h"

namespace wedgesim::tests {

/// What was seen of one frame; `failure` is empty if every invariant of the model held.
struct InvariantReport {
  std::string failure;
  bool z_fail = false;             // the eye needs z-fail
  std::size_t witness_pixels = 0;  // that differ from the polygon-free brute force
  std::size_t wedges = 0;
};

/// Checks the invariants of docs/counting.md and docs/renderer.md on a frame:
/// - the block's LI words are the same for every mode, culling, acceptance, sharing, tile size,
///   thread count and kernel, none is lost to culling, and all pixels agree with the expected LI;
/// - a point outside every wedge has LI exactly 1 - k, k a whole number >= 0 (coverage);
/// - z-pass and z-fail give the same words on all surfaces (coverage, nothing near the eye);
/// - every silhouette vertex has even degree;
/// - the brute force differs only within 1/64 pixel of an umbra polygon's edge.
/// \param every_config  all combinations instead of one of each choice
InvariantReport check_invariants(const functional::Scene& scene,
                                 const functional::FrameOptions& options, bool every_config);

}  // namespace wedgesim::tests

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "functional/methods/frame.h"
#include "functional/scene/scene.h"
#include "model/count/count.h"

namespace wedgesim::tests {

/// What was seen of one frame; `failure` is empty if every invariant of the model held.
struct InvariantReport {
  std::string failure;
  bool z_fail = false;             // the eye needs z-fail
  std::size_t witness_pixels = 0;  // that differ from the polygon-free brute force
  std::size_t wedges = 0;
};

/// Checks that modes, cullings, acceptance, sharing, tile sizes, thread counts and kernels give the
/// same LI words and lose none, and that every pixel is within the datapath's bar (float32 has
/// none to hold: it is for comparison).
/// \param every_config  all combinations instead of one of each choice
/// \param words         (height, width) words, set by this
/// \return              what is wrong; empty if nothing
std::string check_words(const functional::Frame& frame, const model::Datapath& datapath,
                        model::ZChoice z, bool every_config, std::vector<std::int64_t>& words);

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

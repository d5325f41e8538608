#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "functional/methods/method.h"
#include "functional/scene/scene.h"
#include "reports/accuracy/errors.h"

namespace wedgesim::reports::accuracy {

/// Run times of the same work, all repetitions; seconds.
struct Timing {
  double one_thread = 0.0;  // median
  double all_threads = 0.0;
  std::vector<functional::Stage> stages;  // medians on all threads, by name
  std::size_t peak_bytes = 0;  // resident memory beyond what was there before; 0 where unknown
};

/// One choice of method and options on one scene, over all its lights.
struct Measured {
  functional::MethodChoice choice;
  std::optional<std::string> refused;  // why; nothing below is filled then
  std::array<Errors, kRegions.size()> errors;
  functional::MethodAccesses accesses;
  Timing timing;
  std::vector<std::vector<float>> visibility;  // of each light, (height, width, channels)

  const Errors& on(Region region) const { return errors[static_cast<std::size_t>(region)]; }
};

/// A scene with its reference and every choice that was measured on it.
struct SceneResult {
  functional::Scene scene;
  functional::Window window;
  functional::DepthBuffer depth;
  std::size_t triangles = 0;                  // of casters
  std::vector<std::vector<float>> reference;  // of each light
  double reference_seconds = 0.0;
  std::vector<Measured> methods;
};

struct MeasureOptions {
  std::vector<functional::MethodChoice> choices;  // empty: what each method has `compared`
  int rays = 4096;                                // of the reference, where it matters
  int repetitions = 5;                            // of each run time at least; 1: once
};

/// Measures every choice on a scene: one run for its values, then `repetitions` on one thread and
/// as many on all.
/// \param progress  told of each choice before it runs
/// \throws OptionError if an option of a choice is wrong
SceneResult measure(functional::Scene scene, const MeasureOptions& options,
                    const std::function<void(std::string_view choice)>& progress = {});

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "functional/methods/method_options.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What every shadow method is given: a scene and what its eye sees of it. All else a method makes
/// itself, every frame anew, and its run time holds it: silhouettes, volumes, maps, pixels.
struct MethodInput {
  const Scene& scene;
  const Window& window;
  const DepthBuffer& depth;
};

/// Words that a method reads and writes; one word = one access of one pixel or texel.
struct MethodAccesses {
  std::uint64_t z_reads = 0;     // of the eye's depth buffer
  std::uint64_t li_reads = 0;    // of light-intensity and stencil words
  std::uint64_t li_writes = 0;   // of them
  std::uint64_t sums = 0;        // reads and writes of sums over samples or parts of the light
  std::uint64_t map_reads = 0;   // of maps seen from the light, and of tables and textures
  std::uint64_t map_writes = 0;  // of maps seen from the light
  std::uint64_t bytes = 0;       // of all these, at the method's own word widths; 4 for a sum
  static constexpr std::uint64_t kSumBytes = 4;
};

/// A part of a method's run time.
struct Stage {
  std::string name;  // "tiles", "silhouettes", "volumes", "maps", "pixels"
  double seconds = 0.0;
};

/// What a method says of a frame.
struct Visibility {
  /// (height, width, channels) fraction of the light that reaches each pixel, as the method has it:
  /// not clamped; 1 for the sky.
  std::vector<float> values;
  int channels = 1;  // 3 if the light has a texture: fractions of the power of each colour
  MethodAccesses accesses;
  std::vector<Stage> stages;  // in order; they add up to the run time
};

/// A way to compute shadows, as the command and the comparison know it.
struct Method {
  std::string_view name;     // "ssv"
  std::string_view summary;  // one line: what it does
  std::string_view source;   // paper and section
  std::string_view options;  // one line: its keys, their values and defaults; empty if none
  /// The choices that stand for the method in a comparison, as text: "ssv", "ssv:texture=32".
  std::span<const std::string_view> compared;
  /// What its paper says it gets wrong: names of artifacts.
  std::span<const std::string_view> artifacts;
  bool takes_textures = false;  // whether it renders lights with a texture; others are refused
  /// \throws OptionError for a wrong option, InputError if it cannot render this scene, with the
  ///         reason
  Visibility (*render)(const MethodInput& input, const MethodOptions& options);
};

/// All methods, in the order of their papers.
std::span<const Method> methods();

/// The method of a choice: "NAME", "NAME-N" (its `samples`), "NAME:KEY=VALUE,KEY=VALUE".
struct MethodChoice {
  const Method* method = nullptr;
  MethodOptions options;
  std::string text;  // as it was given
};

/// \param place  the option that names the method, for errors
/// \throws InputError for an unknown method or an option that is not KEY=VALUE
MethodChoice choose_method(std::string_view place, std::string_view text);

/// Renders a choice and checks that the method knows every option it was given.
Visibility render_method(const MethodInput& input, const MethodChoice& choice);

}  // namespace wedgesim::functional

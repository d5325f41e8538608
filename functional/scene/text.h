#pragma once

#include <filesystem>
#include <string>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The font used where a scene names none: DejaVu Sans Bold, of the package fonts-dejavu-core.
std::filesystem::path default_font();

struct TextStyle {
  double height = 1.0;     // of the text's bounding box, world units
  double depth = 0.25;     // along z
  int curve_segments = 6;  // straight pieces for one curve of the outline
  std::filesystem::path font = default_font();
};

/// Extrudes text. It reads along x, seen from +z; stands on y = 0, centred on the y axis. Each
/// letter's outline is one closed two-manifold, its counters (the hole of a 0) are open.
/// \param text  characters from space to ~, at least one of them with an outline
/// \throws InputError if the font cannot be read, lacks a character or has outlines that cross
///         themselves, or if nothing is left to extrude
Mesh make_text(const std::string& text, const TextStyle& style);

}  // namespace wedgesim::functional

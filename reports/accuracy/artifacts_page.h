#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "reports/accuracy/accuracy_strips.h"
#include "reports/accuracy/artifacts.h"

namespace wedgesim::reports::accuracy {

/// An artifact with its pictures as they stand in the page: reference, what is wrong, its
/// difference and, if there is one, the remedy and its difference.
struct ArtifactPictures {
  ShownArtifact shown;
  std::vector<SmallPicture> panels;
};

/// Writes FOLDER/pictures/artifact_METHOD_NAME.png, all panels of an artifact side by side.
/// \throws InputError if a file cannot be written
std::vector<ArtifactPictures> write_artifacts(const std::filesystem::path& folder,
                                              std::vector<ShownArtifact> shown);

/// The section of the page; empty if there are none.
std::string artifacts_html(std::span<const ArtifactPictures> artifacts);

}  // namespace wedgesim::reports::accuracy

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/accuracy/accuracy_strips.h"
#include "reports/accuracy/artifacts_page.h"
#include "reports/accuracy/measure.h"
#include "reports/accuracy/recommend.h"

namespace wedgesim::reports::accuracy {

/// All that the page shows.
struct Report {
  const MeasureOptions& options;
  const std::vector<SceneResult>& scenes;
  const std::vector<Pictures>& pictures;  // of each scene
  const std::vector<ArtifactPictures>& artifacts;
};

/// The page as one HTML file that needs no other.
std::string accuracy_page(const Report& report);

/// Writes accuracy.html and accuracy.json into a folder, beside the files of write_pictures and
/// write_artifacts.
/// \param wish  null: nothing is recommended
/// \throws InputError if a file cannot be written
void write_accuracy(const std::filesystem::path& folder, const Report& report, const Wish* wish);

}  // namespace wedgesim::reports::accuracy

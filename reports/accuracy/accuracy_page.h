#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/accuracy/accuracy_strips.h"
#include "reports/accuracy/measure.h"
#include "reports/accuracy/recommend.h"

namespace wedgesim::reports::accuracy {

/// All that the page shows.
struct Report {
  const MeasureOptions& options;
  const std::vector<SceneResult>& scenes;
  const std::vector<Pictures>& pictures;  // of each scene
};

/// The page as one HTML file that needs no other.
std::string accuracy_page(const Report& report);

/// Writes accuracy.html and accuracy.json into a folder, beside write_pictures' files.
/// \param wish  null: nothing is recommended
/// \throws InputError if a file cannot be written
void write_accuracy(const std::filesystem::path& folder, const MeasureOptions& options,
                    const std::vector<SceneResult>& scenes, const std::vector<Pictures>& pictures,
                    const Wish* wish);

}  // namespace wedgesim::reports::accuracy

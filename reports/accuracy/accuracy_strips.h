#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {

/// A picture as it stands in the page.
struct SmallPicture {
  std::string png;  // the bytes
  int width = 0, height = 0;
};

/// A choice's pictures.
struct Strip {
  SmallPicture small;  // method and difference side by side; empty if it was refused
  std::string file;    // method, reference, difference at full size; its path beside the page
};

/// A scene's pictures.
struct Pictures {
  SmallPicture reference;
  std::vector<Strip> strips;  // of each choice
};

/// What each scene is called in links and files: its name as letters, digits, hyphens and dots,
/// numbered where one comes again.
std::vector<std::string> labels_of(const std::vector<SceneResult>& scenes);

/// Writes FOLDER/pictures/SCENE_CHOICE.png for each choice of the last scene that was not refused.
/// \param scenes  the last one with the visibility of its choices
/// \throws InputError if a file cannot be written
Pictures write_pictures(const std::filesystem::path& folder,
                        const std::vector<SceneResult>& scenes);

/// A picture in HTML.
/// \param words  what it shows
std::string image_html(const SmallPicture& picture, const std::string& words);

/// The scale of differences in HTML: their colours and numbers.
std::string scale_html();

}  // namespace wedgesim::reports::accuracy

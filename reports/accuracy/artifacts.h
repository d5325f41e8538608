#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "functional/methods/method.h"
#include "functional/scene/scene.h"
#include "reports/json.h"
#include "reports/sheet.h"

namespace wedgesim::reports::accuracy {

/// Pixels of a frame.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// How a picture differs from ray tracing within a crop, in units of full light.
struct CropErrors {
  double mean = 0.0;  // signed: above 0 is too light
  double rmse = 0.0;
  double step = 0.0;            // largest difference of neighbouring pixels of one surface
  double reference_step = 0.0;  // the same in the reference
  double bend = 0.0;            // largest second difference over four pixels either way
  double reference_bend = 0.0;
};

/// What must hold of the errors for an artifact to show.
struct Criterion {
  enum class Kind { too_dark, too_light, wrong, steps, bends };
  Kind kind = Kind::wrong;
  double bar = 0.0;  // above 0

  /// too_dark, too_light: the mean is beyond the bar; wrong: the RMSE; steps, bends: they are at
  /// least the bar and twice the reference's.
  bool holds(const CropErrors& errors) const;
  std::string text() const;  // "mean error at most -0.1"
};

/// What a paper says its method gets wrong, and where it shows.
struct Artifact {
  std::string_view name;    // of Method::artifacts
  std::string_view choice;  // of method and options that shows it
  std::string_view remedy;  // a choice that does not, or less; empty if there is none
  std::string_view scene;   // what is seen, for readers
  functional::Scene (*make)();
  Crop crop;
  Criterion criterion;
  std::string_view paper;  // and section
  std::string_view says;   // what the paper says
  std::string_view look;   // what to look at in the picture
};

/// All that are known, in the order of the methods.
std::span<const Artifact> artifacts();

/// A choice's picture of an artifact's crop, and its difference from the reference.
struct CropPicture {
  Panel picture, difference;
  CropErrors errors;
};

/// An artifact as it was found.
struct ShownArtifact {
  const Artifact* artifact = nullptr;
  const functional::Method* method = nullptr;
  Panel reference;
  CropPicture wrong;
  std::optional<CropPicture> remedy;
  bool shows() const { return artifact->criterion.holds(wrong.errors); }
};

/// Renders an artifact, its remedy and, in the crop, the reference.
/// \param rays  of each pixel of the reference
ShownArtifact show(const Artifact& artifact, int rays);

/// Those of the named methods.
/// \param progress  told of each before it is rendered
std::vector<ShownArtifact> show_artifacts(
    std::span<const std::string> methods, int rays,
    const std::function<void(std::string_view name)>& progress = {});

/// "artifacts" of the result.
Json artifacts_json(std::span<const ShownArtifact> shown);

}  // namespace wedgesim::reports::accuracy

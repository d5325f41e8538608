#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/accuracy/measure.h"
#include "reports/json.h"

namespace wedgesim::reports::accuracy {

/// A part of a published frame's time.
struct PublishedStage {
  std::string_view name;
  double milliseconds = 0.0;
};

/// A run time as a paper prints it, on the hardware of its day.
struct Published {
  std::string_view method;  // ours that is made after it
  std::string_view paper;
  std::string_view place;  // table or figure
  int year = 0;
  std::string_view hardware;
  std::string_view scene;
  std::size_t triangles = 0;  // 0: not said
  int width = 0, height = 0;  // 0: not said
  double frames_per_second = 0.0;
  std::string_view ours = "";  // the built-in scene made after its scene
  std::span<const PublishedStage> stages = {};

  double milliseconds() const { return 1e3 / frames_per_second; }
};

/// All that the papers publish, in the order of our methods.
std::span<const Published> published();

/// A published time and what of ours comes nearest: the same method's first choice on the scene
/// made after it, else on that whose triangles and pixels are nearest.
struct Beside {
  const Published* published = nullptr;
  const SceneResult* scene = nullptr;  // null: nothing of ours to put beside it
  const Measured* ours = nullptr;
  /// The same scene, or triangles and pixels each within a factor of two.
  bool comparable = false;
};
/// Of the methods that were measured; they point into `results`.
std::vector<Beside> beside_published(const std::vector<SceneResult>& results);

/// A table of what is comparable; empty if nothing is.
std::string published_text(const std::vector<SceneResult>& results);
/// The section of the page: all of the methods that were measured; empty if there are none.
std::string published_html(const std::vector<SceneResult>& results);
/// "published" of the result.
Json published_json(const std::vector<SceneResult>& results);

}  // namespace wedgesim::reports::accuracy

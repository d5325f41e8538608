#pragma once

#include <string>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {

/// What a scene's results say, in sentences: its front, what is fastest under an error and what
/// is most exact, and how much longer ray tracing takes for the same error.
std::vector<std::string> finding_words(const SceneResult& result);

/// Why the choices of a scene that were refused were: each reason once, with its choices.
struct Refusal {
  std::string choices;  // "hard, ssv and ssv:texture=32"
  std::string reason;
};
std::vector<Refusal> refusals(const SceneResult& result);

}  // namespace wedgesim::reports::accuracy

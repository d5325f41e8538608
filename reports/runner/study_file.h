#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/runner/configuration.h"
#include "reports/runner/frames.h"

namespace wedgesim::reports {

/// A study: every configuration on every frame. Point i is configuration i % configurations.size()
/// on frame i / configurations.size().
struct Study {
  StudyHead head;
  std::vector<FrameSpec> frames;
  std::vector<Configuration> configurations;  // all different
  bool pictures = false;
  double time_limit_seconds = 600.0;  // of a point

  std::size_t points() const { return frames.size() * configurations.size(); }
};

/// Reads a study's file; docs/studies.md describes it.
/// \param name  of the study
/// \param file  that errors name; relative paths start at its folder
/// \throws InputError at FILE:LINE for anything wrong in it, a scene, a frame, or a configuration
Study parse_study(std::string_view text, const std::string& name, const std::string& file,
                  const FrameOverrides& overrides = {});

/// A study inside the program, or a TOML file.
/// \throws InputError also if there is no such study, naming all of them
Study read_study(const std::string& name_or_file, const FrameOverrides& overrides = {});

/// A study file of reports/studies/, compiled in.
struct BuiltInStudy {
  std::string_view name, text;
};
std::span<const BuiltInStudy> built_in_studies();

}  // namespace wedgesim::reports

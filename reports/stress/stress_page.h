#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// A picture of the first failure of a family in an arithmetic (stress_picture.h).
struct FailurePicture {
  const Family* family = nullptr;
  Arithmetic arithmetic = Arithmetic::fixed;
  std::string png;  // the bytes
  int width = 0, height = 0;
};

/// The page as one HTML file that needs no other: words, table, charts, pictures.
std::string stress_page(const RunOptions& options, const std::vector<FamilyResult>& results,
                        const std::vector<FailurePicture>& pictures);

/// All that write_stress may write.
std::vector<std::filesystem::path> stress_files(const std::filesystem::path& folder);

/// Refuses a folder into which write_stress could not write, before long work.
/// \throws InputError as write_stress does
void require_stress_writable(const std::filesystem::path& folder);

/// Writes stress.json, stress.html and pictures/FAMILY_ARITHMETIC.png into a folder. Pictures that
/// an earlier run left there are removed.
/// \throws InputError if a file cannot be written
void write_stress(const std::filesystem::path& folder, const RunOptions& options,
                  const std::vector<FamilyResult>& results);

}  // namespace wedgesim::reports::stress

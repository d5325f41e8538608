#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// What a case is made from.
struct CaseName {
  const Family* family = nullptr;
  std::uint64_t seed = 0;
  double difficulty = 0.0;

  Case make() const { return family->make(seed, difficulty); }
};

/// \throws InputError naming all families
const Family& find_family(std::string_view name);

/// "FAMILY,SEED,DIFFICULTY"; the difficulty lies between the family's least and greatest level.
/// \param option  what an error names
/// \throws InputError
CaseName parse_case(std::string_view option, std::string_view text);

/// As parse_case reads it.
std::string to_text(const CaseName& name);

/// The shortest text of a number that reads the same: "0.001", "1e-6".
std::string difficulty_text(double difficulty);

}  // namespace wedgesim::reports::stress

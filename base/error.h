#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace wedgesim {

/// What the user gave is wrong. One line: where (file, key or option), what is wrong, what is
/// expected. The command prints it and ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  /// \param place     file with line or key, or option, as the user would look for it
  /// \param problem   what is wrong there
  /// \param expected  what would be right; may be empty
  InputError(std::string_view place, std::string_view problem, std::string_view expected = {});
};

/// What is simulated cannot go on, though the program is sound: say, a memory never answers.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A broken invariant of the program itself: never the user's fault.
class CheckError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace wedgesim

#pragma once

#include <string>
#include <string_view>

namespace wedgesim::cli {

/// Prints to standard output.
void print(std::string_view text);

/// To be called once after all printing, whichever way it was done.
/// \throws InputError if not all of it could be written
void finish_printing();

/// Prints one line to standard error, whatever names it holds: control characters are escaped.
void print_note(std::string_view line);

/// Control characters as \n, \t or \x1b.
std::string escaped(std::string_view text);

}  // namespace wedgesim::cli

#include "cli/print.h"

#include <fmt/format.h>

#include <cstdio>
#include <iostream>

#include "base/error.h"

namespace wedgesim::cli {

void print(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

void finish_printing() {
  const bool flushed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (!flushed || !std::cout.flush()) {
    throw InputError("standard output", "cannot be written", "room for what is printed");
  }
}

void print_note(std::string_view line) {
  const std::string text = escaped(line) + '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '\n') {
      result += "\\n";
    } else if (c == '\t') {
      result += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\x{:02x}", code);
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace wedgesim::cli

#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "cli/print.h"

namespace wedgesim::cli {

namespace {
constexpr std::string_view kClearLine = "\r\x1b[K";
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "{}", kClearLine);
}

void Progress::show(std::string_view what) {
  if (!terminal_) return;
  fmt::print(stderr, "{}{} ...", kClearLine, escaped(what));
  std::fflush(stderr);
}

}  // namespace wedgesim::cli

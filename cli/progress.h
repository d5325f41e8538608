#pragma once

#include <string_view>

namespace wedgesim::cli {

/// One line on standard error that says what long work is at; nothing unless that is a terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Takes the place of the line before.
  void show(std::string_view what);

 private:
  bool terminal_;
};

}  // namespace wedgesim::cli

#pragma once

#include <fmt/format.h>

#include <concepts>
#include <ostream>
#include <string_view>

namespace wedgesim::traces {

/// Writes JSON piece by piece, buffered; commas come by themselves. The caller keeps begin and end
/// in balance.
class JsonStream {
 public:
  explicit JsonStream(std::ostream& out) : out_(out) {}
  JsonStream(const JsonStream&) = delete;
  JsonStream& operator=(const JsonStream&) = delete;
  ~JsonStream() { flush(); }

  void begin(char bracket);  // '{' or '['
  void end(char bracket);    // '}' or ']'
  void line();               // the next element begins a line
  void key(std::string_view name);

  void null();
  void value(bool truth);
  void value(double number);
  void value(std::string_view text);
  void value(std::integral auto number) {
    separate();
    fmt::format_to(std::back_inserter(buffer_), "{}", number);
  }

 private:
  void separate();
  void append(std::string_view text) { buffer_.append(text.data(), text.data() + text.size()); }
  void flush();

  std::ostream& out_;
  fmt::memory_buffer buffer_;
  bool first_ = true;  // in the innermost bracket, or right after a key
  bool line_ = false;
};

}  // namespace wedgesim::traces

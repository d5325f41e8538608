#include "traces/json_stream.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace wedgesim::traces {
namespace {

constexpr std::size_t kFlushBytes = 1 << 16;

}  // namespace

void JsonStream::flush() {
  out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  buffer_.clear();
}

void JsonStream::separate() {
  if (!first_) buffer_.push_back(',');
  if (line_) buffer_.push_back('\n');
  first_ = false;
  line_ = false;
  if (buffer_.size() > kFlushBytes) flush();
}

void JsonStream::begin(char bracket) {
  separate();
  buffer_.push_back(bracket);
  first_ = true;
}

void JsonStream::end(char bracket) {
  if (line_) buffer_.push_back('\n');
  line_ = false;
  buffer_.push_back(bracket);
  first_ = false;
}

void JsonStream::line() { line_ = true; }

void JsonStream::key(std::string_view name) {
  value(name);
  buffer_.push_back(':');
  first_ = true;
}

void JsonStream::null() {
  separate();
  append("null");
}

void JsonStream::value(bool truth) {
  separate();
  append(truth ? "true" : "false");
}

void JsonStream::value(double number) {
  if (!std::isfinite(number)) return null();
  separate();
  const std::size_t begin = buffer_.size();
  fmt::format_to(std::back_inserter(buffer_), "{}", number);
  // An integer to a reader of JSON would lose the sign of -0.
  const std::string_view digits(buffer_.data() + begin, buffer_.size() - begin);
  if (digits.find_first_of(".e") == std::string_view::npos) append(".0");
}

void JsonStream::value(std::string_view text) {
  separate();
  append(nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace wedgesim::traces

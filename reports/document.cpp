#include "reports/document.h"

#include <iterator>

namespace wedgesim::reports {
namespace {

constexpr std::size_t kIndent = 2;

// Every line indented and ended.
std::string lines(const std::string& text, std::size_t indent) {
  std::string indented(indent, ' ');
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented.append(indent, ' ');
  }
  return indented + '\n';
}

// In Markdown a line's end is a blank.
std::string list(const std::string& text) {
  if (text.find('\n') == std::string::npos) return text + '\n';
  std::string items = "- ";
  for (const char c : text) {
    items += c;
    if (c == '\n') items += "- ";
  }
  return items + '\n';
}

}  // namespace

void Document::append(Document other) {
  std::move(other.parts_.begin(), other.parts_.end(), std::back_inserter(parts_));
}

std::string Document::text() const {
  std::string text;
  std::size_t indent = 0;
  for (const auto& part : parts_) {
    if (!text.empty()) text += '\n';
    if (const auto* heading = std::get_if<Heading>(&part)) {
      text += lines(heading->text, 0);
      indent = kIndent;
    } else if (const auto* paragraph = std::get_if<Paragraph>(&part)) {
      text += lines(paragraph->text, indent);
    } else {
      text += std::get<Table>(part).text(indent);
    }
  }
  return text;
}

std::string Document::markdown() const {
  std::string text;
  for (const auto& part : parts_) {
    if (!text.empty()) text += '\n';
    if (const auto* heading = std::get_if<Heading>(&part)) {
      text += "## " + heading->text + '\n';
    } else if (const auto* paragraph = std::get_if<Paragraph>(&part)) {
      text += list(paragraph->text);
    } else {
      text += std::get<Table>(part).markdown();
    }
  }
  return text;
}

}  // namespace wedgesim::reports

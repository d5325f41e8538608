#include "reports/page/html.h"

#include "base/check.h"

namespace wedgesim::reports::page {

std::string escape(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string element(std::string_view tag, std::string_view text) {
  const std::string name(tag);
  return '<' + name + '>' + escape(text) + "</" + name + '>';
}

std::string script_json(const Json& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string fill(std::string_view text,
                 const std::map<std::string, std::string, std::less<>>& values) {
  std::string filled;
  while (true) {
    const std::size_t begin = text.find("{{");
    filled += text.substr(0, begin);
    if (begin == std::string_view::npos) return filled;
    const std::size_t end = text.find("}}", begin);
    WEDGESIM_CHECK(end != std::string_view::npos);
    const auto value = values.find(text.substr(begin + 2, end - begin - 2));
    WEDGESIM_CHECK(value != values.end());
    filled += value->second;
    text.remove_prefix(end + 2);
  }
}

}  // namespace wedgesim::reports::page

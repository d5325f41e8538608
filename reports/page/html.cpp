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

std::string fact(std::size_t number, std::string_view what) {
  return "<li><strong>" + std::to_string(number) + "</strong> " + escape(what) + "</li>\n";
}

std::string number_heading(std::string_view name) {
  return "<th scope=\"col\" class=\"number\">" + escape(name) + "</th>";
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

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
    }
  }
  return text;
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

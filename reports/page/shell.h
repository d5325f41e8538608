#pragma once

#include <string>
#include <string_view>

#include "reports/json.h"

namespace wedgesim::reports::page {

/// A page's own contents; head, heading, scripts are the same on all pages (shell.html).
struct Contents {
  std::string title;
  std::string kind;      // HTML: what of wedgesim wrote it
  std::string question;  // what the page answers; may be empty
  std::string name;      // the class of its body
  std::string body;      // HTML: main and footer
  Json data;             // for its script
  std::string_view script;
};

/// The page as one HTML file that needs no other.
std::string in_shell(const Contents& contents);

}  // namespace wedgesim::reports::page

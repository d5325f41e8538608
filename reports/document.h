#pragma once

#include <string>
#include <variant>
#include <vector>

#include "reports/table.h"

namespace wedgesim::reports {

/// Headings, paragraphs and tables: for a terminal, or as Markdown.
class Document {
 public:
  void heading(std::string text) { parts_.emplace_back(Heading{std::move(text)}); }
  /// Lines, without a line feed at the end.
  void paragraph(std::string text) { parts_.emplace_back(Paragraph{std::move(text)}); }
  void table(Table table) { parts_.emplace_back(std::move(table)); }
  void append(Document other);

  /// What stands under a heading is indented.
  std::string text() const;
  std::string markdown() const;

 private:
  struct Heading {
    std::string text;
  };
  struct Paragraph {
    std::string text;
  };
  std::vector<std::variant<Heading, Paragraph, Table>> parts_;
};

}  // namespace wedgesim::reports

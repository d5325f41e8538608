#include "reports/page/shell.h"

#include "reports/page/assets.h"
#include "reports/page/html.h"

namespace wedgesim::reports::page {

std::string in_shell(const Contents& contents) {
  return fill(assets::shell(),
              {{"title", escape(contents.title)},
               {"kind", contents.kind},
               {"question", contents.question.empty() ? "" : element("p", contents.question)},
               {"class", escape(contents.name)},
               {"body", contents.body},
               {"css", std::string(assets::css())},
               {"licences", std::string(assets::licences())},
               {"data", script_json(contents.data)},
               {"vega", std::string(assets::vega())},
               {"vega_lite", std::string(assets::vega_lite())},
               {"vega_embed", std::string(assets::vega_embed())},
               {"script", std::string(contents.script)}});
}

}  // namespace wedgesim::reports::page

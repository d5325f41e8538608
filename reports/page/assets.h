#pragma once

#include <string_view>

namespace wedgesim::reports::page::assets {

// Files built into the program (CMakeLists.txt says where each is from).
std::string_view shell();              // shell.html, a template
std::string_view html();               // page.html, a template
std::string_view css();                // page.css
std::string_view script();             // script/*.js of it, one after another
std::string_view stress_html();        // stress.html, a template
std::string_view accuracy_html();      // accuracy.html, a template
std::string_view row_charts_script();  // script/*.js of these two
std::string_view vega();               // vega.min.js
std::string_view vega_lite();          // vega-lite.min.js
std::string_view vega_embed();         // vega-embed.min.js
std::string_view licences();           // of the three

}  // namespace wedgesim::reports::page::assets

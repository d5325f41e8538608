#include "reports/page/assets.h"

// The assembler reads the files; WEDGESIM_ASSETS is the folder that the build collects them in.
#define WEDGESIM_ASSET(name, file)                                                     \
  __asm__(".section .rodata\n.global wedgesim_asset_" #name "\nwedgesim_asset_" #name  \
          ":\n.incbin \"" WEDGESIM_ASSETS "/" file "\"\n.global wedgesim_asset_" #name \
          "_end\nwedgesim_asset_" #name "_end:\n.byte 0\n.previous\n");                \
  extern "C" const char wedgesim_asset_##name[];                                       \
  extern "C" const char wedgesim_asset_##name##_end[];                                 \
  std::string_view wedgesim::reports::page::assets::name() {                           \
    return {wedgesim_asset_##name, wedgesim_asset_##name##_end};                       \
  }

WEDGESIM_ASSET(shell, "shell.html")
WEDGESIM_ASSET(html, "page.html")
WEDGESIM_ASSET(css, "page.css")
WEDGESIM_ASSET(script, "page.js")
WEDGESIM_ASSET(stress_html, "stress.html")
WEDGESIM_ASSET(accuracy_html, "accuracy.html")
WEDGESIM_ASSET(row_charts_script, "row_charts.js")
WEDGESIM_ASSET(vega, "vega.min.js")
WEDGESIM_ASSET(vega_lite, "vega-lite.min.js")
WEDGESIM_ASSET(vega_embed, "vega-embed.min.js")
WEDGESIM_ASSET(licences, "licences.txt")

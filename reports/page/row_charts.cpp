#include "reports/page/row_charts.h"

#include <fmt/format.h>

#include "reports/page/chart.h"
#include "reports/page/chart_spec.h"
#include "reports/page/html.h"

namespace wedgesim::reports::page {

Json mark_channels(const std::vector<std::string>& series, Json x, Json y) {
  return {{"x", std::move(x)},
          {"y", std::move(y)},
          {"color", colour_channel(series)},
          {"opacity", opacity_channel(1.0)}};
}

Json tooltip_field(const std::string& field, const std::string& title) {
  return {{"field", field}, {"type", "nominal"}, {"title", title}};
}

std::string chart_html(const RowChart& chart, std::string_view heading) {
  return fmt::format(
      "<figure id=\"chart-{0}\" class=\"chart\">\n<{1}>{2}</{1}>\n<div class=\"plot\"></div>\n"
      "<figcaption>{3}</figcaption>\n</figure>\n",
      escape(chart.id), heading, escape(chart.title), escape(chart.caption));
}

std::string legend_html(std::string_view name) {
  return fmt::format(
      "<section id=\"selection\" aria-labelledby=\"selection-heading\">\n"
      "<h2 id=\"selection-heading\" class=\"hidden\">{0}</h2>\n"
      "<div class=\"series\" id=\"legend\" role=\"group\" aria-label=\"{0}\"></div>\n</section>\n",
      escape(name));
}

Json row_chart_data(const std::vector<std::string>& series, const std::vector<RowChart>& charts) {
  Json data{{"config", chart_config()}, {"names", series}};
  data["charts"] = Json::array();
  for (const RowChart& chart : charts) {
    data["charts"].push_back({{"id", chart.id}, {"spec", chart.spec}, {"rows", chart.rows}});
  }
  return data;
}

}  // namespace wedgesim::reports::page

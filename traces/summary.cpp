#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "traces/dump.h"

namespace wedgesim::traces {
namespace {

using nlohmann::json;

template <typename Values, typename Test>
auto count(const Values& values, Test test) {
  return std::count_if(values.begin(), values.end(), test);
}

std::string presence(std::size_t values) { return values == 0 ? "absent" : "present"; }

}  // namespace

std::string summary(const TraceView& trace) {
  const Header& header = trace.header;
  const auto linear =
      count(trace.wedges, [](const auto& wedge) { return wedge.kind() == fb::WedgeKind_linear; });
  const auto role = [&](fb::UmbraRole wanted) {
    return count(trace.umbra_polygons,
                 [wanted](const auto& polygon) { return polygon.role() == wanted; });
  };
  std::string text;
  const auto line = [&text](std::string_view name, const std::string& value) {
    text += fmt::format("{:<16}{}\n", name, value);
  };
  // Quoted: a name from a file may hold anything.
  line("name", json(header.name).dump(-1, ' ', true, json::error_handler_t::replace));
  line("checksum", fmt::format("{:016x}", header.checksum));
  line("size", fmt::format("{}x{}", header.width, header.height));
  line("lights", std::to_string(header.lights.size()));
  line("casters", std::to_string(header.casters.size()));
  line("vertices", std::to_string(trace.vertices.size()));
  line("planes", std::to_string(trace.planes.size()));
  line("faces", std::to_string(trace.faces.size()));
  line("wedges", fmt::format("{} ({} coverage, {} linear)", trace.wedges.size(),
                             static_cast<std::ptrdiff_t>(trace.wedges.size()) - linear, linear));
  line("umbra_polygons",
       fmt::format("{} ({} side, {} bottom, {} cap)", trace.umbra_polygons.size(),
                   role(fb::UmbraRole_side), role(fb::UmbraRole_bottom), role(fb::UmbraRole_cap)));
  line("depth", fb::EnumNameDepthFormat(header.depth_format));
  line("z_fail_needed", header.z_fail_needed ? "true" : "false");
  line("expected_li",
       trace.expected_li.empty()
           ? presence(0)
           : fmt::format("present, z-{}", fb::EnumNameZMethod(header.expected_z_method)));
  line("li_sensitivity", presence(trace.li_sensitivity.size()));
  return text;
}

}  // namespace wedgesim::traces

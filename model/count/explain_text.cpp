#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "model/count/explain.h"

namespace wedgesim::model {
namespace {

using Text = std::back_insert_iterator<std::string>;

double light(std::int64_t word) { return std::ldexp(static_cast<double>(word), -40); }

std::string_view outcome_text(const UmbraExplanation& umbra, bool fail) {
  switch (umbra.outcome) {
    case UmbraExplanation::Outcome::culled:
      return "tile culled";
    case UmbraExplanation::Outcome::accepted:
      return "tile accepted without reading z";
    case UmbraExplanation::Outcome::cap:
      return "cap, fails without reading z";
    case UmbraExplanation::Outcome::read:
      break;
  }
  if (fail) return umbra.hit ? "fails" : "does not fail";
  return umbra.hit ? "passes" : "does not pass";
}

void write_umbra(const UmbraExplanation& umbra, bool fail, Text text) {
  fmt::format_to(text, "  {} polygon {}, facing {}: ", traces::fb::EnumNameUmbraRole(umbra.role),
                 umbra.polygon, umbra.eye_facing ? "the eye" : "away");
  if (umbra.outcome != UmbraExplanation::Outcome::cap) {
    fmt::format_to(text, "v {:+.6g}{}, {}, ", umbra.value,
                   umbra.interval_decides ? ", z beyond its interval decides" : "",
                   umbra.inner ? "inner" : "not inner");
  }
  fmt::format_to(text, "{}: {:+d}\n", outcome_text(umbra, fail), umbra.step);
}

void write_wedge(const WedgeExplanation& wedge, bool fail, Text text) {
  if (wedge.wedge) {
    fmt::format_to(text, "wedge {}\n", *wedge.wedge);
  } else {
    fmt::format_to(text, "umbra polygon without a wedge\n");
  }
  for (const FaceExplanation& face : wedge.faces) {
    fmt::format_to(text, "  face {}: {}\n", face.face,
                   face.culled_by == Cull::none
                       ? std::string("survives")
                       : fmt::format("culled by {}", spelling(face.culled_by)));
  }
  for (const PlaneExplanation& plane : wedge.planes) {
    fmt::format_to(
        text, "  plane {}{}: v {:+.6g}, {}\n", traces::is_minus(plane.reference) ? '-' : '+',
        traces::plane_index(plane.reference), plane.value, plane.inside ? "inside" : "outside");
  }
  if (!wedge.faces.empty()) {
    fmt::format_to(text, "  depth {:.9g} to {:.9g}: the point is {} the wedge", wedge.z.min,
                   wedge.z.max, wedge.inside ? "inside" : "outside");
    if (wedge.inside && wedge.kind == traces::fb::WedgeKind_coverage) {
      fmt::format_to(text, ", {} the umbra polygon's plane", wedge.inner ? "within" : "before");
    }
    fmt::format_to(text, ": {:+.9f}\n", light(wedge.words));
  }
  if (wedge.umbra) write_umbra(*wedge.umbra, fail, text);
  fmt::format_to(text, "  {} z reads, {} LI writes{}\n", wedge.z_reads, wedge.li_writes,
                 wedge.umbra && wedge.umbra->shared ? ", shared" : "");
}

}  // namespace

std::string to_text(const Explanation& explanation) {
  const CountConfig& config = explanation.config;
  const bool fail = explanation.method == ZMethod::fail;
  std::string result;
  const Text text(result);
  fmt::format_to(text, "pixel {},{}: z {:.9g} (word {}){}\n", explanation.x, explanation.y,
                 explanation.z, explanation.depth_word, explanation.sky ? ", sky" : "");
  fmt::format_to(text, "{}, z-{}, cull {}, umbra-cull {}, accept {}, share {}\n",
                 spelling(config.mode), fail ? "fail" : "pass", spelling(config.cull),
                 spelling(config.umbra_cull), spelling(config.accept), spelling(config.share));
  const Box& tile = explanation.tile;
  fmt::format_to(text, "tile of {}: x {} to {}, y {} to {}, z {:.9g} to {:.9g}\n", config.tile,
                 tile.x0, tile.x1, tile.y0, tile.y1, tile.z.min, tile.z.max);
  for (const WedgeExplanation& wedge : explanation.wedges) write_wedge(wedge, fail, text);
  fmt::format_to(text, "{} z reads, {} LI writes; LI = 1", explanation.z_reads,
                 explanation.li_writes);
  for (const WedgeExplanation& wedge : explanation.wedges) {
    if (wedge.words != 0) fmt::format_to(text, " {:+.9f}", light(wedge.words));
    if (wedge.umbra && wedge.umbra->step != 0) fmt::format_to(text, " {:+d}", wedge.umbra->step);
  }
  fmt::format_to(text, " = {:.9f}", light(explanation.word));
  if (explanation.expected) fmt::format_to(text, "; expected {:.9f}", *explanation.expected);
  result += '\n';
  return result;
}

}  // namespace wedgesim::model

#include "functional/methods/renderer.h"

#include <algorithm>
#include <array>

#include "functional/methods/frame.h"
#include "functional/methods/stopwatch.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

Visibility render_wedges(const MethodInput& input, fb::WedgeKind kind) {
  FrameOptions options;
  options.kind = kind;
  options.depth = &input.depth;
  options.depth_format = input.depth.format;
  Visibility result;
  Stopwatch stopwatch(result);
  const Frame frame = make_frame(input.scene, options);
  result.values.resize(frame.trace.expected_li.size());
  std::ranges::transform(frame.trace.expected_li, result.values.begin(),
                         [](double li) { return static_cast<float>(li); });
  stopwatch.end("pixels");
  return result;
}

Visibility render_coverage(const MethodInput& input, const MethodOptions& options) {
  options.check_all_known();
  return render_wedges(input, fb::WedgeKind_coverage);
}

Visibility render_linear(const MethodInput& input, const MethodOptions& options) {
  options.check_all_known();
  return render_wedges(input, fb::WedgeKind_linear);
}

}  // namespace

const Method kCoverage{.name = "coverage",
                       .summary = "Wedges with exact coverage, in double precision",
                       .source = "Papers III and IV; the renderer that makes traces",
                       .options = "",
                       .compared = {},
                       .artifacts = {},
                       .render = render_coverage};

const Method kLinear{.name = "linear",
                     .summary = "Wedges with linear interpolation, in double precision",
                     .source = "Papers I and II; the renderer that makes traces",
                     .options = "",
                     .compared = {},
                     .artifacts = {},
                     .render = render_linear};

}  // namespace wedgesim::functional

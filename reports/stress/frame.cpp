#include "reports/stress/frame.h"

#include "functional/scene/scene_check.h"

namespace wedgesim::reports::stress {

functional::Frame frame_of(const Case& stress_case) {
  functional::FrameOptions options = stress_case.options;
  options.depth = stress_case.depth.get();
  functional::check_scene(stress_case.scene, stress_case.scene.name);
  return functional::make_frame(stress_case.scene, options);
}

model::ZMethod method_of(const functional::Frame& frame) {
  return frame.trace.header.expected_z_method == traces::fb::ZMethod_fail ? model::ZMethod::fail
                                                                          : model::ZMethod::pass;
}

model::Datapath datapath_of(Arithmetic arithmetic, const Case& stress_case) {
  switch (arithmetic) {
    case Arithmetic::fixed: {
      model::Datapath datapath(model::DatapathKind::fixed);
      datapath.formats = stress_case.formats;
      return datapath;
    }
    case Arithmetic::float32:
      return {model::DatapathKind::float32};
    case Arithmetic::double_precision:
    case Arithmetic::renderer:
      break;
  }
  return {model::DatapathKind::exact};
}

std::vector<double> li_of(const std::vector<std::int64_t>& sums, const model::Datapath& datapath) {
  std::vector<double> li;
  li.reserve(sums.size());
  for (const std::int64_t sum : sums) {
    const std::int64_t word =
        datapath.kind == model::DatapathKind::fixed ? datapath.formats.li.wrap(sum) : sum;
    li.push_back(static_cast<double>(word) / datapath.one());
  }
  return li;
}

}  // namespace wedgesim::reports::stress

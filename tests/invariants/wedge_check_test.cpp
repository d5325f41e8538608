// Are the wedges that a datapath gets wrong among those that are flagged, and is none flagged that
// the default formats or double precision get right? On every built-in scene, both wedge kinds and
// lights.
#include "model/count/wedge_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "model/count/count.h"

namespace wedgesim::tests {
namespace {

using functional::LightShape;
using model::Datapath;
using model::DatapathKind;
using traces::fb::WedgeKind;

// Which wedges cover a pixel, with a rasterized face or their umbra polygon.
std::vector<bool> covering(const std::vector<model::Primitive>& wedges, int x, int y) {
  std::vector<bool> result;
  for (const model::Primitive& wedge : wedges) {
    result.push_back((wedge.polygon && wedge.polygon->outline.covers(x, y)) ||
                     std::ranges::any_of(wedge.faces, [&](const model::RasterFace& face) {
                       return face.outline.covers(x, y);
                     }));
  }
  return result;
}

struct Seen {
  std::size_t wedges = 0, flagged = 0;
  std::size_t innocent = 0;    // flagged, and on no mismatched pixel
  std::size_t mismatched = 0;  // pixels
  std::size_t unflagged = 0;   // of them on no flagged wedge
};

void look(const traces::TraceView& trace, const Datapath& datapath, Seen& seen) {
  std::vector<bool> flagged(trace.wedges.size());
  for (const model::WedgeFlag& flag : model::flag_wedges(trace, datapath)) {
    flagged[flag.wedge] = true;
  }
  model::CountOptions options;
  options.datapath = datapath;
  options.maps = true;
  const model::CountConfig config;
  const auto results = model::count(trace, {&config, 1}, options);
  const model::Operands operands(trace, datapath);
  std::vector<model::Primitive> wedges;
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    wedges.push_back(model::wedge_primitive(operands, results[0].z, i));
  }
  std::vector<bool> guilty(trace.wedges.size());
  const auto width = static_cast<int>(trace.header.width);
  for (std::size_t pixel = 0; pixel < results[0].li.size(); ++pixel) {
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    const auto error =
        model::compare_pixel(trace, results[0].z, x, y, results[0].li[pixel], datapath);
    if (!error || model::matches(*error, datapath)) continue;
    ++seen.mismatched;
    const std::vector<bool> here = covering(wedges, x, y);
    bool named = false;
    for (std::size_t i = 0; i < here.size(); ++i) {
      named = named || (here[i] && flagged[i]);
      guilty[i] = guilty[i] || here[i];
    }
    seen.unflagged += named ? 0 : 1;
  }
  for (std::size_t i = 0; i < flagged.size(); ++i) {
    seen.wedges += 1;
    seen.flagged += flagged[i] ? 1 : 0;
    seen.innocent += flagged[i] && !guilty[i] ? 1 : 0;
  }
}

template <typename F>
void for_each_trace(F&& f) {
  for (const functional::SceneInfo& info : functional::built_in_scenes()) {
    if (info.name == "mesh") continue;  // a template, for a user's mesh
    if (info.name == "bunny" && !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
      continue;
    }
    for (const WedgeKind kind : {WedgeKind::WedgeKind_coverage, WedgeKind::WedgeKind_linear}) {
      for (const LightShape light : {LightShape::rectangle, LightShape::sphere}) {
        if (info.name == "fire" && light == LightShape::sphere) continue;  // textured
        functional::SceneOptions options;
        options.size = {160, 107};
        options.light_shape = light;
        functional::FrameOptions frame_options;
        frame_options.kind = kind;
        SCOPED_TRACE(info.name);
        f(functional::make_frame(functional::load_scene(info.name, options), frame_options)
              .trace.view());
      }
    }
  }
}

Datapath narrow(int form_bits) {
  Datapath datapath(DatapathKind::fixed);
  datapath.formats.form_bits = form_bits;
  datapath.formats.li = {12, 20};  // so that what is seen comes from the forms
  return datapath;
}

TEST(WedgeCheck, FlagsNothingThatIsRight) {
  for_each_trace([](const traces::TraceView& trace) {
    EXPECT_TRUE(model::flag_wedges(trace, DatapathKind::exact).empty());
    EXPECT_TRUE(model::flag_wedges(trace, DatapathKind::fixed).empty());
  });
}

TEST(WedgeCheck, EveryMismatchedPixelIsOnAFlaggedWedge) {
  std::vector<std::pair<Datapath, Seen>> datapaths{{DatapathKind::float32, {}}};
  for (const int form_bits : {44, 48, 50, 52}) datapaths.push_back({narrow(form_bits), {}});
  for_each_trace([&](const traces::TraceView& trace) {
    for (auto& [datapath, seen] : datapaths) look(trace, datapath, seen);
  });
  for (const auto& [datapath, seen] : datapaths) {
    std::cout << spelling(datapath.kind) << ", form_bits " << datapath.formats.form_bits << ": "
              << seen.flagged << " of " << seen.wedges << " wedges flagged, " << seen.innocent
              << " of them on no mismatched pixel; " << seen.mismatched << " pixels mismatched, "
              << seen.unflagged << " on no flagged wedge\n";
    EXPECT_EQ(seen.unflagged, 0u);
    EXPECT_GT(seen.mismatched, 0u);
  }
}

}  // namespace
}  // namespace wedgesim::tests

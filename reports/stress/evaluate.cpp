#include "reports/stress/evaluate.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "reports/stress/exact_plane.h"
#include "traces/depth.h"

namespace wedgesim::reports::stress {
namespace {

using model::Primitive;

// A contribution may leave [0, 1] by its own rounding.
constexpr double kRounding = 1e-4;

struct Pixel {
  std::size_t index = 0;
  int x = 0, y = 0;
  double z = 0.0;       // as the datapath takes it
  double window_z = 0;  // stored depth
  double centre_x() const { return x + 0.5; }
  double centre_y() const { return y + 0.5; }
};

bool covers(const Primitive& primitive, int x, int y) {
  return std::any_of(primitive.faces.begin(), primitive.faces.end(),
                     [&](const model::RasterFace& face) { return face.outline.covers(x, y); });
}

class Walk {
 public:
  Walk(const traces::TraceView& trace, model::ZMethod method, const model::Datapath& datapath)
      : trace_(trace), method_(method), datapath_(datapath), operands_(trace, datapath_) {
    const auto width = static_cast<std::size_t>(trace.header.width);
    for (std::size_t i = 0; i < trace.depth.size(); ++i) {
      pixels_.push_back({i, static_cast<int>(i % width), static_cast<int>(i / width),
                         operands_.depth(trace.depth[i]),
                         traces::decode_depth(trace.header.depth_format, trace.depth[i])});
    }
    result_.sums.assign(pixels_.size(), static_cast<std::int64_t>(datapath_.one()));
    result_.contributions.assign(pixels_.size(), 0);
  }

  Evaluation run() {
    for (std::uint32_t w = 0; w < trace_.wedges.size(); ++w) {
      const Primitive primitive = model::wedge_primitive(operands_, method_, w);
      add_polygon(primitive);
      add_wedge(primitive);
    }
    for (const std::uint32_t i : model::lone_polygons(trace_, method_)) {
      add_polygon(model::lone_primitive(operands_, method_, i));
    }
    return std::move(result_);
  }

 private:
  void add_polygon(const Primitive& primitive) {
    if (!primitive.polygon) return;
    const model::RasterUmbra& umbra = *primitive.polygon;
    const auto step = umbra.stencil_step * static_cast<std::int64_t>(datapath_.one());
    for (const Pixel& p : pixels_) {
      if (!umbra.outline.covers(p.x, p.y)) continue;
      const bool hit = umbra.cap || model::is_inner(umbra, true, p.centre_x(), p.centre_y(), p.z) ==
                                        umbra.hits_inner;
      if (hit) result_.sums[p.index] += step;
    }
  }

  void add_wedge(const Primitive& wedge) {
    std::vector<const Pixel*> inside;
    for (const Pixel& p : pixels_) {
      if (!covers(wedge, p.x, p.y)) continue;
      if (is_inside(wedge, p)) inside.push_back(&p);
    }
    std::vector<double> values;
    values.reserve(inside.size());
    const auto start = std::chrono::steady_clock::now();
    for (const Pixel* p : inside) {
      values.push_back(model::contribution(wedge.terms, p->centre_x(), p->centre_y(), p->z));
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    result_.seconds += spent.count();
    result_.visits += inside.size();
    for (std::size_t i = 0; i < inside.size(); ++i) add_value(wedge, *inside[i], values[i]);
  }

  bool is_inside(const Primitive& wedge, const Pixel& p) {
    const traces::fb::Wedge& record = trace_.wedges[*wedge.wedge];
    bool inside = p.z >= wedge.z.min && p.z <= wedge.z.max;
    for (std::size_t i = 0; i < wedge.planes.size(); ++i) {
      const bool said = wedge.planes[i].inside(p.centre_x(), p.centre_y(), p.z);
      const std::uint32_t reference = (*record.planes())[static_cast<std::uint16_t>(i)];
      const int sign = exact_sign(trace_.planes[traces::plane_index(reference)], p.centre_x(),
                                  p.centre_y(), p.window_z);
      result_.signs += 1;
      result_.wrong_signs += said == ((sign >= 0) != traces::is_minus(reference)) ? 0 : 1;
      inside = inside && said;
    }
    return inside;
  }

  void add_value(const Primitive& wedge, const Pixel& p, double value) {
    result_.contributions[p.index] += 1;
    if (!std::isfinite(value)) {
      result_.not_finite += 1;
      return;
    }
    result_.saturated += value < -kRounding || value > 1.0 + kRounding ? 1 : 0;
    const bool fixed = datapath_.kind == model::DatapathKind::fixed;
    const std::int64_t word =
        fixed ? datapath_.formats.li.of(value) : model::to_word(value, datapath_.one());
    result_.sums[p.index] += wedge.coverage && !is_inner(wedge, p) ? -word : word;
  }

  bool is_inner(const Primitive& wedge, const Pixel& p) const {
    if (wedge.polygon && wedge.polygon->outline.covers(p.x, p.y)) {
      return model::is_inner(*wedge.polygon, true, p.centre_x(), p.centre_y(), p.z);
    }
    return wedge.inner.inside(p.centre_x(), p.centre_y(), p.z);
  }

  const traces::TraceView& trace_;
  model::ZMethod method_;
  model::Datapath datapath_;
  model::Operands operands_;
  std::vector<Pixel> pixels_;
  Evaluation result_;
};

}  // namespace

Evaluation evaluate(const traces::TraceView& trace, model::ZMethod method,
                    const model::Datapath& datapath) {
  return Walk(trace, method, datapath).run();
}

std::vector<std::vector<std::uint32_t>> wedges_at(const traces::TraceView& trace,
                                                  const std::vector<std::size_t>& pixels) {
  std::vector<std::vector<std::uint32_t>> wedges(pixels.size());
  const model::Operands operands(trace);
  for (std::uint32_t w = 0; w < trace.wedges.size() && !pixels.empty(); ++w) {
    for (const model::ZMethod method : {model::ZMethod::pass, model::ZMethod::fail}) {
      const Primitive primitive = model::wedge_primitive(operands, method, w);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto x = static_cast<int>(pixels[i] % trace.header.width);
        const auto y = static_cast<int>(pixels[i] / trace.header.width);
        const bool here = covers(primitive, x, y) ||
                          (primitive.polygon && primitive.polygon->outline.covers(x, y));
        if (here && (wedges[i].empty() || wedges[i].back() != w)) wedges[i].push_back(w);
      }
    }
  }
  return wedges;
}

}  // namespace wedgesim::reports::stress

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
    const auto count = static_cast<std::uint32_t>(trace_.wedges.size());
    for (std::uint32_t w = 0; w < count; ++w) {
      add_part(w, model::wedge_primitive(operands_, method_, w));
    }
    for (const std::uint32_t i : model::lone_polygons(trace_, method_)) {
      add_part(count + i, model::lone_primitive(operands_, method_, i));
    }
    return std::move(result_);
  }

 private:
  void add_part(std::uint32_t number, const Primitive& primitive) {
    const std::vector<std::int64_t> before = result_.sums;
    add_polygon(primitive);
    if (primitive.wedge) add_wedge(primitive);
    Evaluation::Part part{number, {}};
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::int64_t change = result_.sums[i] - before[i];
      if (change != 0) part.shares.push_back({i, static_cast<double>(change) / datapath_.one()});
    }
    result_.parts.push_back(std::move(part));
  }

  void add_polygon(const Primitive& primitive) {
    if (!primitive.polygon) return;
    const model::RasterUmbra& umbra = *primitive.polygon;
    const auto step = umbra.stencil_step * static_cast<std::int64_t>(datapath_.one());
    for (const Pixel& p : pixels_) {
      if (!umbra.outline.covers(p.x, p.y)) continue;
      if (!umbra.cap && p.z >= umbra.z.min && p.z <= umbra.z.max) {
        count_sign(trace_.umbra_polygons[*primitive.umbra].plane(),
                   umbra.inner.inside(p.centre_x(), p.centre_y(), p.z), p);
      }
      const bool hit = umbra.cap || model::is_inner(umbra, true, p.centre_x(), p.centre_y(), p.z) ==
                                        umbra.hits_inner;
      if (hit) result_.sums[p.index] += step;
    }
  }

  void add_wedge(const Primitive& wedge) {
    std::vector<const Pixel*> inside;
    for (const Pixel& p : pixels_) {
      if (!wedge.faces_cover(p.x, p.y)) continue;
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
      count_sign((*record.planes())[static_cast<std::uint16_t>(i)], said, p);
      inside = inside && said;
    }
    return inside;
  }

  // Of a plane that is said to have a pixel inside, or not.
  void count_sign(std::uint32_t reference, bool said, const Pixel& p) {
    const int sign = exact_sign(trace_.planes[traces::plane_index(reference)], p.centre_x(),
                                p.centre_y(), p.window_z);
    result_.signs += 1;
    result_.wrong_signs += said == ((sign >= 0) != traces::is_minus(reference)) ? 0 : 1;
  }

  // Single precision saturates what it gives: what counts is what it had before.
  static double before_saturation(const Primitive& wedge, const Pixel& p, double value) {
    const auto* single = std::get_if<model::SingleTerms>(&wedge.terms);
    if (single == nullptr) return value;
    return static_cast<double>(model::unsaturated(*single, static_cast<float>(p.centre_x()),
                                                  static_cast<float>(p.centre_y()),
                                                  static_cast<float>(p.z)));
  }

  void add_value(const Primitive& wedge, const Pixel& p, double value) {
    result_.contributions[p.index] += 1;
    const double before = before_saturation(wedge, p, value);
    result_.not_finite += std::isfinite(before) ? 0 : 1;
    result_.saturated += before < -kRounding || before > 1.0 + kRounding ? 1 : 0;
    if (!std::isfinite(value)) return;
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
  std::vector<std::vector<std::uint32_t>> found(pixels.size());
  if (pixels.empty()) return found;
  const model::Operands operands(trace);
  const auto add = [&](const Primitive& primitive, std::uint32_t number) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const auto x = static_cast<int>(pixels[i] % trace.header.width);
      const auto y = static_cast<int>(pixels[i] / trace.header.width);
      const bool here = primitive.faces_cover(x, y) ||
                        (primitive.polygon && primitive.polygon->outline.covers(x, y));
      if (here && (found[i].empty() || found[i].back() != number)) found[i].push_back(number);
    }
  };
  const auto count = static_cast<std::uint32_t>(trace.wedges.size());
  for (std::uint32_t w = 0; w < count; ++w) {
    for (const model::ZMethod method : {model::ZMethod::pass, model::ZMethod::fail}) {
      add(model::wedge_primitive(operands, method, w), w);
    }
  }
  for (const std::uint32_t i : model::lone_polygons(trace, model::ZMethod::fail)) {
    add(model::lone_primitive(operands, model::ZMethod::fail, i), count + i);
  }
  return found;
}

}  // namespace wedgesim::reports::stress

#include "model/count/wedge_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace wedgesim::model {
namespace {

using traces::fb::Wedge;

constexpr double kMostSteps = 1.0 / 8.0;
constexpr double kMostPixels = 1.0 / 2048.0;

glm::dvec3 vec(const traces::fb::Vec3& v) { return {v.x(), v.y(), v.z()}; }

// How far off a form is, and what a step of stored z and a pixel change in it.
struct Form {
  double error = 0.0, per_step = 0.0, per_pixel = 0.0;

  /// By how many times what is allowed its zero is off; a form that never changes has none.
  double excess() const {
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    const double steps = per_step > 0.0 ? error / per_step / kMostSteps : kNowhere;
    const double pixels = per_pixel > 0.0 ? error / per_pixel / kMostPixels : kNowhere;
    return std::min(steps, pixels);
  }
};

// The coordinates of one vector: judged as one, by the worst error and the steepest of them.
Form together(std::initializer_list<Form> forms) {
  Form all;
  for (const Form& form : forms) {
    all.error = std::max(all.error, form.error);
    all.per_step = std::max(all.per_step, form.per_step);
    all.per_pixel = std::max(all.per_pixel, form.per_pixel);
  }
  return all;
}

class Check {
 public:
  Check(const traces::TraceView& trace, const Datapath& datapath)
      : trace_(trace),
        operands_(trace, datapath),
        width_(trace.header.width),
        height_(trace.header.height),
        steps_(trace.header.depth_format, trace.depth),
        rounding_(datapath.kind == DatapathKind::float32 ? 0x1p-24 : 0x1p-53),
        fixed_(datapath.kind == DatapathKind::fixed) {}

  WedgeFlag operator()(std::uint32_t index) const {
    const Wedge& wedge = trace_.wedges[index];
    const bool coverage = wedge.kind() == traces::fb::WedgeKind_coverage;
    if (coverage && vec(wedge.edge_begin()) == vec(wedge.edge_end()))
      return {index, FlagReason::edge, 2.0};
    double plane = plane_form(wedge.umbra_plane()).excess();
    for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
      plane = std::max(plane, plane_form((*wedge.planes())[i]).excess());
    }
    // The light of a `linear` wedge comes from its planes.
    const double light = coverage ? light_excess(wedge) : 0.0;
    return plane < light ? WedgeFlag{index, FlagReason::light, light}
                         : WedgeFlag{index, FlagReason::plane, plane};
  }

 private:
  Form of(const datapath::FixedForm& form) const {
    const auto size = [](std::int64_t x) { return std::fabs(static_cast<double>(x)); };
    return {width_ + height_ + 0.5 * (static_cast<double>(steps_.high() - steps_.low()) + 1.0),
            size(form.c), 2.0 * std::max(size(form.a), size(form.b))};
  }
  Form of(const Row& row) const {
    const double a = std::fabs(row.a), b = std::fabs(row.b), c = std::fabs(row.c);
    const double size = a * width_ + b * height_ + c + std::fabs(row.d);
    return {4.0 * rounding_ * size, c / steps_.one(), std::max(a, b)};
  }

  Form plane_form(std::uint32_t reference) const {
    const Plane plane = operands_.plane(reference);
    return fixed_ ? of(plane.form) : of(Row{plane.a, plane.b, plane.c, plane.d});
  }

  double light_excess(const Wedge& wedge) const {
    if (fixed_) return fixed_excess(std::get<FixedTerms>(operands_.terms(wedge)).setup);
    const LightTerms terms = light_terms(trace_, wedge);
    double worst = 0.0;
    if (const auto* rectangle = std::get_if<RectangleTerms>(&terms)) {
      for (const auto& end : rectangle->ends) worst = std::max(worst, of(end.w).excess());
      return worst;
    }
    const auto& sphere = std::get<SphereTerms>(terms);
    for (const double end : sphere.ends) {
      worst = std::max(
          worst, together({of_difference(sphere.w, end, sphere.along),
                           of_difference(sphere.w, sphere.distance, sphere.out), of(sphere.normal)})
                     .excess());
    }
    return worst;
  }

  // w e - p, both rounded before.
  Form of_difference(const Row& w, double e, const Row& p) const {
    const auto difference = [e](double of_w, double of_p) { return of_w * e - of_p; };
    Form form = of(Row{difference(w.a, p.a), difference(w.b, p.b), difference(w.c, p.c), 0.0});
    form.error = of(w).error * std::fabs(e) + of(p).error;
    return form;
  }

  double fixed_excess(const datapath::LightSetup& setup) const {
    double worst = 0.0;
    const auto judge = [&](const datapath::FixedForm& form) {
      worst = std::max(worst, of(form).excess());
    };
    if (const auto* rectangle = std::get_if<datapath::RectangleSetup>(&setup)) {
      // An end's u and v are on the exponent of w, and matter in proportion to it.
      for (const auto& end : rectangle->ends) judge(end.w);
      return worst;
    }
    const auto& disc = std::get<datapath::DiscSetup>(setup);
    for (const auto& form : {disc.along, disc.out, disc.normal, disc.w, disc.beyond}) judge(form);
    for (const auto& end : disc.ends) {
      judge(end.along);
      judge(end.turn);
    }
    return worst;
  }

  const traces::TraceView& trace_;
  Operands operands_;
  double width_, height_;
  datapath::ZSteps steps_;
  double rounding_;
  bool fixed_;
};

}  // namespace

std::string_view name(FlagReason reason) {
  static constexpr std::array<std::string_view, 3> kNames{"plane", "light", "edge"};
  return kNames[static_cast<std::size_t>(reason)];
}

std::string_view describe(FlagReason reason) {
  switch (reason) {
    case FlagReason::plane:
      return "a plane is rounded too far";
    case FlagReason::light:
      return "the edge, as seen from a point, is rounded too far";
    case FlagReason::edge:
      return "the edge has no length";
  }
  return "";
}

std::vector<WedgeFlag> flag_wedges(const traces::TraceView& trace, const Datapath& datapath) {
  const Check check(trace, datapath);
  std::vector<WedgeFlag> flags;
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    const WedgeFlag flag = check(i);
    if (!(flag.value <= 1.0)) flags.push_back(flag);
  }
  return flags;
}

}  // namespace wedgesim::model

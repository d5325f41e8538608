#include "model/count/rounding_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "model/datapath/form.h"
#include "traces/depth.h"

namespace wedgesim::model {
namespace {

// By how many errors a form is moved: one at a time, but sides are told by the differences of two.
// What lies between may be more than what lies at the ends.
constexpr std::array kMoves{-2.0, -1.0, 1.0, 2.0};

// A form at a point, and how far its value may be off.
struct Reading {
  double value = 0.0, error = 0.0;
  bool is_unsure() const { return std::fabs(value) <= error; }
};

struct Point {
  double x = 0.0, y = 0.0, z = 0.0;  // as the datapath takes them
};

Reading read(const datapath::FixedForm& form, const Point& p) {
  return {static_cast<double>(form.at(datapath::place(p.x, p.y, p.z))),
          p.x + p.y + 0.5 * (std::fabs(p.z) + 1.0)};
}

template <typename Real>
Reading read(const RowOf<Real>& row, const Point& p) {
  const auto size = [](auto x) { return std::fabs(static_cast<double>(x)); };
  const double terms = size(row.a) * p.x + size(row.b) * p.y + size(row.c) * p.z + size(row.d);
  constexpr double kUnit = 0.5 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  return {static_cast<double>(
              row.at(static_cast<Real>(p.x), static_cast<Real>(p.y), static_cast<Real>(p.z))),
          4.0 * kUnit * terms};
}

Reading read(const Plane& plane, const Point& p) {
  if (plane.arithmetic == Arithmetic::fixed) return read(plane.form, p);
  if (plane.arithmetic == Arithmetic::double_precision) {
    return read(Row{plane.a, plane.b, plane.c, plane.d}, p);
  }
  const auto single = [](double x) { return static_cast<float>(x); };
  return read(RowOf<float>{single(plane.a), single(plane.b), single(plane.c), single(plane.d)}, p);
}

void shift(datapath::FixedForm& form, double by) {
  form.d += static_cast<std::int64_t>(by < 0.0 ? std::floor(by) : std::ceil(by));
}
template <typename Form>
void shift(Form& form, double by) {
  form.d = static_cast<decltype(form.d)>(static_cast<double>(form.d) + by);
}

// Each form that a light intensity or coverage is made from.
template <typename Real, typename F>
void for_each_form(LinearTermsOf<Real>& terms, F f) {
  for (Plane& plane : terms.planes) f(plane);
}
template <typename Real, typename F>
void for_each_form(RectangleTermsOf<Real>& terms, F f) {
  for (auto& end : terms.ends) {
    for (auto* form : {&end.u, &end.v, &end.w}) f(*form);
  }
}
template <typename Real, typename F>
void for_each_form(SphereTermsOf<Real>& terms, F f) {
  for (auto* form : {&terms.along, &terms.out, &terms.normal, &terms.w}) f(*form);
}
template <typename F>
void for_each_form(datapath::LinearSetup& setup, F f) {
  for (datapath::FixedForm& plane : setup.planes) f(plane);
}
template <typename F>
void for_each_form(datapath::RectangleSetup& setup, F f) {
  for (auto& end : setup.ends) {
    for (auto* form : {&end.u, &end.v, &end.w}) f(*form);
  }
  for (auto* form : {&setup.line.a, &setup.line.b, &setup.line.c}) f(*form);
}
template <typename F>
void for_each_form(datapath::DiscSetup& setup, F f) {
  for (auto* form : {&setup.along, &setup.out, &setup.normal, &setup.w, &setup.beyond}) f(*form);
  for (auto& end : setup.ends) {
    f(end.along);
    f(end.turn);
  }
}
template <typename F>
void for_each_form(LightTerms& terms, F f) {
  const auto visit = [&](auto& of) { for_each_form(of, f); };
  if (auto* fixed = std::get_if<FixedTerms>(&terms)) return std::visit(visit, fixed->setup);
  if (auto* single = std::get_if<SingleTerms>(&terms)) return std::visit(visit, *single);
  if (auto* linear = std::get_if<LinearTerms>(&terms)) return visit(*linear);
  if (auto* sphere = std::get_if<SphereTerms>(&terms)) return visit(*sphere);
  visit(std::get<RectangleTerms>(terms));
}

// What moving forms one at a time does not show. In floating point an edge is clipped to a
// rectangle by shares of its length: of an edge with both ends far outside, as seen
// from the point, what is small beside it is lost.
template <typename Real>
double lost_by_clipping(const RectangleTermsOf<Real>& terms, const Point& p) {
  const auto size = [&](const auto& form) { return std::fabs(read(form, p).value); };
  const auto& [begin, end] = terms.ends;
  const double reach =
      std::min(std::max(size(begin.u), size(begin.v)), std::max(size(end.u), size(end.v)));
  const double height = std::min(size(begin.w), size(end.w));
  return 2.0 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * reach / height;
}
double lost_by_clipping(const datapath::RectangleSetup&, const Point&) { return 0.0; }

// And an edge that may be behind the point as well as before it may be anywhere; so may an end, if
// its way there is not sure either.
template <typename Terms>
double lost_together(const Terms&, const Point&) {
  return 0.0;
}
template <typename Rectangle>
double lost_rectangle(const Rectangle& terms, const Point& p) {
  const auto is_unsure = [&](const auto& form) { return read(form, p).is_unsure(); };
  const auto is_behind = [&](const auto& end) { return is_unsure(end.w); };
  const auto is_anywhere = [&](const auto& end) {
    return is_behind(end) && (is_unsure(end.u) || is_unsure(end.v));
  };
  const bool lost =
      std::ranges::all_of(terms.ends, is_behind) || std::ranges::any_of(terms.ends, is_anywhere);
  return lost ? 1.0 : lost_by_clipping(terms, p);
}
template <typename Real>
double lost_together(const RectangleTermsOf<Real>& terms, const Point& p) {
  return lost_rectangle(terms, p);
}
double lost_together(const datapath::RectangleSetup& setup, const Point& p) {
  return lost_rectangle(setup, p);
}
// And so may an edge whose distance from the centre of a sphere's disc is off by much of its
// radius.
double lost_disc(double off_normal, double normal, double beyond, double distance) {
  constexpr double kMuch = 0.25;
  return distance * off_normal > kMuch * std::hypot(normal, beyond) ? 1.0 : 0.0;
}
template <typename Real>
double lost_together(const SphereTermsOf<Real>& terms, const Point& p) {
  const Reading normal = read(terms.normal, p);
  const auto distance = static_cast<double>(terms.distance);
  const double beyond = read(terms.w, p).value * distance - read(terms.out, p).value;
  return lost_disc(normal.error, normal.value, beyond, distance);
}
double lost_together(const datapath::DiscSetup& setup, const Point& p) {
  const auto scaled = [](const datapath::FixedForm& form, double x) {
    return std::ldexp(x, form.exponent);
  };
  const Reading normal = read(setup.normal, p);
  return lost_disc(scaled(setup.normal, normal.error), scaled(setup.normal, normal.value),
                   scaled(setup.beyond, read(setup.beyond, p).value),
                   std::sqrt(setup.distance_squared));
}
double lost_together(const LightTerms& terms, const Point& p) {
  const auto visit = [&](const auto& of) { return lost_together(of, p); };
  if (const auto* fixed = std::get_if<FixedTerms>(&terms)) return std::visit(visit, fixed->setup);
  if (const auto* single = std::get_if<SingleTerms>(&terms)) return std::visit(visit, *single);
  if (const auto* rectangle = std::get_if<RectangleTerms>(&terms)) return visit(*rectangle);
  if (const auto* sphere = std::get_if<SphereTerms>(&terms)) return visit(*sphere);
  return 0.0;
}

bool is_same(const Plane& p, const Plane& q) {
  return p.a == q.a && p.b == q.b && p.c == q.c && p.d == q.d;
}

// Something that may be decided either way.
struct Choice {
  bool no = false, yes = false;
  static Choice sure(bool is) { return {!is, is}; }
};

Choice inside(const Plane& plane, const Point& p) {
  if (read(plane, p).is_unsure()) return {true, true};
  return Choice::sure(plane.inside(p.x, p.y, p.z));
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

// One primitive at one pixel.
class PixelShare {
 public:
  /// \param terms  those of the primitive, to be moved and put back
  PixelShare(const Primitive& primitive, LightTerms& terms, bool wedge, bool polygon)
      : primitive_(primitive), terms_(terms), wedge_(wedge), polygon_(polygon) {}

  /// As the datapath gives it.
  double at(const Point& p) const {
    const bool inner = polygon_ ? is_inner(*primitive_.polygon, true, p.x, p.y, p.z)
                                : primitive_.wedge && primitive_.inner.inside(p.x, p.y, p.z);
    const bool in_wedge =
        wedge_ && in_interval(p) && std::ranges::all_of(primitive_.planes, [&](const Plane& plane) {
          return plane.inside(p.x, p.y, p.z);
        });
    return of_polygon(inner) + (in_wedge ? of_wedge(inner, light(p)) : 0.0);
  }

  /// All that it may be.
  void add(const Point& p, Range& range) const {
    const Choice inner = inner_at(p);
    if (inner.no) add(p, false, range);
    if (inner.yes) add(p, true, range);
  }

 private:
  void add(const Point& p, bool inner, Range& range) const {
    const Choice in_wedge = in_wedge_at(p, inner);
    if (in_wedge.no) range.add(of_polygon(inner));
    if (!in_wedge.yes) return;
    const double value = light(p);
    const double off = light_off(p, value);
    for (const double moved : {value - off, value + off}) {
      range.add(of_polygon(inner) + of_wedge(inner, moved));
    }
  }

  double of_polygon(bool inner) const {
    if (!polygon_) return 0.0;
    const RasterUmbra& umbra = *primitive_.polygon;
    return umbra.cap || inner == umbra.hits_inner ? umbra.stencil_step : 0.0;
  }
  double of_wedge(bool inner, double value) const {
    return primitive_.coverage && !inner ? -value : value;
  }
  bool in_interval(const Point& p) const {
    return p.z >= primitive_.z.min && p.z <= primitive_.z.max;
  }

  Choice inner_at(const Point& p) const {
    if (polygon_) {
      const RasterUmbra& umbra = *primitive_.polygon;
      const bool by_plane = !umbra.cap && p.z >= umbra.z.min && p.z <= umbra.z.max;
      return by_plane ? inside(umbra.inner, p) : Choice::sure(is_inner(umbra, true, p.x, p.y, p.z));
    }
    return primitive_.wedge ? inside(primitive_.inner, p) : Choice::sure(false);
  }

  // A plane of the wedge that is the umbra polygon's is decided as that one.
  Choice in_wedge_at(const Point& p, bool inner) const {
    if (!wedge_ || !in_interval(p)) return Choice::sure(false);
    Choice all = Choice::sure(true);
    for (const Plane& plane : primitive_.planes) {
      Choice one = inside(plane, p);
      if (one.no && one.yes && is_same(plane, primitive_.inner)) {
        one = Choice::sure(inner == (plane.minus == primitive_.inner.minus));
      }
      if (!one.yes) return Choice::sure(false);
      all.no = all.no || one.no;
    }
    return all;
  }

  double light(const Point& p) const { return contribution(terms_, p.x, p.y, p.z); }

  double light_off(const Point& p, double value) const {
    double sum = std::min(lost_together(terms_, p), 1.0);
    for_each_form(terms_, [&](auto& form) {
      const Reading reading = read(form, p);
      const auto kept = form;
      double most = 0.0;
      for (const double by : kMoves) {
        shift(form, by * reading.error);
        most = std::max(most, std::fabs(light(p) - value));
        form = kept;
      }
      sum += most;
    });
    return sum;
  }

  const Primitive& primitive_;
  LightTerms& terms_;
  bool wedge_, polygon_;
};

}  // namespace

RoundingBound::RoundingBound(const Operands& operands, const Datapath& datapath) {
  const traces::TraceView& trace = operands.trace();
  const traces::fb::DepthFormat format = trace.header.depth_format;
  const datapath::ZSteps steps(format, trace.depth);
  const bool fixed = datapath.kind == DatapathKind::fixed;
  const bool single = datapath.kind == DatapathKind::float32;
  const auto unrounded = [&](std::uint32_t word) {
    return fixed ? steps.unrounded(word) : traces::decode_depth(format, word);
  };
  const auto width = static_cast<std::size_t>(trace.header.width);
  pixels_.reserve(trace.depth.size());
  for (std::size_t i = 0; i < trace.depth.size(); ++i) {
    const std::uint32_t word = trace.depth[i];
    Pixel pixel;
    pixel.index = i;
    pixel.column = static_cast<int>(i % width);
    pixel.row = static_cast<int>(i / width);
    const double z = operands.depth(word);
    pixel.z[0] = z;
    if (unrounded(word) != z) {
      const auto beside = [&](float to) {
        return static_cast<double>(std::nextafter(static_cast<float>(z), to));
      };
      pixel.z[1] = single ? beside(0.0F) : z - 1.0;
      pixel.z[2] = single ? beside(1.0F) : z + 1.0;
      pixel.depths = 3;
    }
    const auto next = [&](int farther) { return traces::step_depth(format, word, farther); };
    pixel.nearer = operands.depth(next(-1));
    pixel.farther = operands.depth(next(1));
    pixels_.push_back(pixel);
  }
}

std::vector<Doubt> RoundingBound::operator()(const Primitive& primitive) const {
  std::vector<Doubt> doubts;
  LightTerms terms = primitive.terms;
  for (const Pixel& pixel : pixels_) {
    const bool wedge = primitive.faces_cover(pixel.column, pixel.row);
    const bool polygon =
        primitive.polygon && primitive.polygon->outline.covers(pixel.column, pixel.row);
    if (!wedge && !polygon) continue;
    const PixelShare share(primitive, terms, wedge, polygon);
    Range range;
    const auto point = [&](std::size_t k) {
      return Point{pixel.column + 0.5, pixel.row + 0.5, pixel.z[k]};
    };
    for (std::size_t k = 0; k < pixel.depths; ++k) share.add(point(k), range);
    Doubt doubt;
    doubt.pixel = pixel.index;
    const double own = share.at(point(0));
    doubt.li = std::max(range.high - own, own - range.low);
    const auto change = [&](double z) {
      Point moved = point(0);
      moved.z = z;
      return share.at(moved) - own;
    };
    doubt.nearer = change(pixel.nearer);
    doubt.farther = change(pixel.farther);
    if (doubt.li > 0.0 || doubt.nearer != 0.0 || doubt.farther != 0.0) doubts.push_back(doubt);
  }
  return doubts;
}

}  // namespace wedgesim::model

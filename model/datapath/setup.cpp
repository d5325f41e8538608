#include "model/datapath/setup.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <tuple>
#include <type_traits>

#include "model/datapath/disc_frame.h"

namespace wedgesim::model::datapath {
namespace {

using traces::fb::Matrix4;

glm::dvec3 vec(const traces::fb::Vec3& v) { return {v.x(), v.y(), v.z()}; }

LinearForm matrix_row(const Matrix4& matrix, std::uint16_t row) {
  const auto at = [&](int column) {
    return (*matrix.columns())[static_cast<std::uint16_t>(4 * column + row)];
  };
  return {at(0), at(1), at(2), at(3)};
}

LinearForm plane_form(const traces::TraceView& trace, std::uint32_t reference) {
  const traces::fb::Plane& plane = trace.planes[traces::plane_index(reference)];
  return {plane.a(), plane.b(), plane.c(), plane.d()};
}

LinearSetup linear_setup(const traces::TraceView& trace, const traces::fb::Wedge& wedge,
                         const ZSteps& steps, const Formats& formats) {
  LinearSetup setup;
  for (std::uint16_t i = 0; i < setup.planes.size(); ++i) {
    const std::uint32_t reference = (*wedge.planes())[i];
    FixedForm& plane = setup.planes[i];
    plane = quantize_alone(plane_form(trace, reference), steps, formats.form_bits);
    if (traces::is_minus(reference)) {
      plane = {-plane.a, -plane.b, -plane.c, -plane.d, plane.exponent};
    }
  }
  for (std::uint16_t i = 0; i < setup.factors.size(); ++i) {
    setup.factors[i] = formats.round()((*wedge.linear_factors())[i]);
  }
  return setup;
}

// With H the point's distance from the light's plane and h the edge's, the line from the point
// through the edge's end meets the plane at (H*u - h*U, H*v - h*V) / (H - h*W); the cross product
// of both ends is H times the line, which is linear in the point.
RectangleSetup rectangle_setup(const Matrix4& light_from_window, const glm::dvec3& begin,
                               const glm::dvec3& end, const ZSteps& steps, const Formats& formats) {
  const LinearForm u = matrix_row(light_from_window, 0);
  const LinearForm v = matrix_row(light_from_window, 1);
  const LinearForm h = matrix_row(light_from_window, 2);
  const LinearForm w = matrix_row(light_from_window, 3);
  const auto fixed = [&](const auto& forms) {
    const int exponent = common_exponent(forms, steps, formats.form_bits);
    std::array<FixedForm, std::tuple_size_v<std::decay_t<decltype(forms)>>> result;
    for (std::size_t i = 0; i < result.size(); ++i) {
      result[i] = quantize(forms[i], steps, exponent);
    }
    return result;
  };
  const auto project = [&](const glm::dvec3& e) -> RectangleSetup::End {
    const auto forms = fixed(
        std::array{combine(h, e.x, u, -e.z), combine(h, e.y, v, -e.z), combine(h, 1.0, w, -e.z)});
    return {forms[0], forms[1], forms[2]};
  };
  const glm::dvec3 edge = end - begin;
  const glm::dvec3 normal = glm::cross(begin, end);
  const auto line = fixed(std::array{combine(h, -edge.y, v, edge.z, w, -normal.x),
                                     combine(h, edge.x, u, -edge.z, w, -normal.y),
                                     combine(h, normal.z, v, normal.y, u, normal.x)});
  return {{project(begin), project(end)}, {line[0], line[1], line[2]}};
}

DiscSetup disc_setup(const Matrix4& light_from_window, const glm::dvec3& begin,
                     const glm::dvec3& end, const ZSteps& steps, const Formats& formats) {
  const LinearForm w = matrix_row(light_from_window, 3);
  const auto component = [&](const glm::dvec3& axis) {
    const auto row = [&](std::uint16_t i) { return matrix_row(light_from_window, i); };
    return combine(row(0), axis.x, row(1), axis.y, row(2), axis.z);
  };
  const DiscFrame frame = disc_frame(begin, end);
  const LinearForm along = component(frame.along);
  const LinearForm out = component(frame.out);
  const auto fixed = [&](const LinearForm& form) {
    return quantize_alone(form, steps, formats.form_bits);
  };
  const Rounder round = formats.round();
  DiscSetup setup;
  setup.along = fixed(along);
  setup.out = fixed(out);
  setup.normal = fixed(component(frame.normal));
  setup.w = fixed(w);
  setup.beyond = fixed(combine(w, frame.distance, out, -1.0));
  for (std::size_t i = 0; i < 2; ++i) {
    const double at = frame.ends[i];
    setup.ends[i] = {fixed(combine(w, at, along, -1.0)),
                     fixed(combine(along, frame.distance, out, -at)), round(at)};
  }
  setup.distance_squared = round(frame.distance * frame.distance);
  return setup;
}

}  // namespace

FixedPlane plane_setup(const traces::TraceView& trace, std::uint32_t reference, const ZSteps& steps,
                       const Formats& formats) {
  return {quantize_alone(plane_form(trace, reference), steps, formats.form_bits),
          traces::is_minus(reference)};
}

LightSetup light_setup(const traces::TraceView& trace, const traces::fb::Wedge& wedge,
                       const ZSteps& steps, const Formats& formats) {
  if (wedge.kind() == traces::fb::WedgeKind_linear) {
    return linear_setup(trace, wedge, steps, formats);
  }
  const traces::Light& light = trace.header.lights[wedge.light()];
  const glm::dvec3 begin = vec(wedge.edge_begin());
  const glm::dvec3 end = vec(wedge.edge_end());
  if (light.shape == traces::fb::LightShape_sphere) {
    return disc_setup(light.light_from_window, begin, end, steps, formats);
  }
  return rectangle_setup(light.light_from_window, begin, end, steps, formats);
}

double contribution(const LightSetup& setup, const Place& at, Rounder round) {
  if (const auto* linear = std::get_if<LinearSetup>(&setup)) {
    return intensity(*linear, at, round);
  }
  if (const auto* disc = std::get_if<DiscSetup>(&setup)) return coverage(*disc, at, round);
  return coverage(std::get<RectangleSetup>(setup), at, round);
}

}  // namespace wedgesim::model::datapath

// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/d_buffer_pixels.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/d_buffer_pixels.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/methods/light_places_simd.h"
#include "functional/raster/lanes_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE V load(const float* from) { return hn::LoadU(kTag, from); }
HWY_INLINE V between_0_and_1(V t) { return hn::Min(hn::Max(t, hn::Zero(kTag)), set(1.0F)); }

HWY_INLINE V area_beside_line(V t) {
  float parts[kLanes];
  hn::StoreU(t, kTag, parts);
  for (float& part : parts) {
    const double s = 1.0 - 2.0 * static_cast<double>(part);  // from the centre, radii
    part = static_cast<float>((std::acos(s) - s * std::sqrt(1.0 - s * s)) / M_PI);
  }
  return load(parts);
}

// Points on the light's rays, by their inverse distances from its centre.
struct Points {
  V inverse;
  M unlit;
};

class Lookup {
 public:
  Lookup(const DBuffer& map, const DBufferPixels& options) : map_(map), options_(options) {
    const MapRays rays(map.view);
    const glm::dvec3 at_origin = rays.at(0.0, 0.0);
    const glm::dvec3 dx = rays.at(1.0, 0.0) - at_origin;
    const glm::dvec3 dy = rays.at(0.0, 1.0) - at_origin;
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      ray_[axis] = {static_cast<float>(dx[i]), static_cast<float>(dy[i]),
                    static_cast<float>(at_origin[i])};
    }
  }

  HWY_INLINE M shows(V x, V y) const {
    const V low = set(-1.0F);
    const V high = set(static_cast<float>(map_.width) + 1.0F);
    return hn::And(hn::And(hn::Gt(x, low), hn::Gt(y, low)),
                   hn::And(hn::Lt(x, high), hn::Lt(y, high)));
  }

  HWY_INLINE V visible(V x, V y, V inverse_depth, M unlit) const {
    const Points points{hn::Div(inverse_depth, ray_length(x, y)), unlit};
    if (!options_.bilinear) return at_texels(hn::Floor(x), hn::Floor(y), points);
    const V one = set(1.0F);
    const V left = hn::Floor(hn::Sub(x, set(0.5F)));
    const V top = hn::Floor(hn::Sub(y, set(0.5F)));
    const V fx = hn::Sub(hn::Sub(x, set(0.5F)), left);
    const V fy = hn::Sub(hn::Sub(y, set(0.5F)), top);
    const auto along = [&](V row) HWY_ATTR {
      return hn::Add(hn::Mul(hn::Sub(one, fx), at_texels(left, row, points)),
                     hn::Mul(fx, at_texels(hn::Add(left, one), row, points)));
    };
    return hn::Add(hn::Mul(hn::Sub(one, fy), along(top)), hn::Mul(fy, along(hn::Add(top, one))));
  }

 private:
  HWY_INLINE V ray_length(V x, V y) const {
    V square = hn::Zero(kTag);
    for (const auto& [dx, dy, at_origin] : ray_) {
      const V part = hn::Add(set(at_origin), hn::Add(hn::Mul(set(dx), x), hn::Mul(set(dy), y)));
      square = hn::Add(square, hn::Mul(part, part));
    }
    return hn::Sqrt(square);
  }

  // Visibility at texels (x, y), whole numbers; 1 outside the map.
  HWY_INLINE V at_texels(V x, V y, const Points& points) const {
    const V zero = hn::Zero(kTag);
    const V size = set(static_cast<float>(map_.width));
    const M in_map = hn::And(hn::And(hn::Ge(x, zero), hn::Ge(y, zero)),
                             hn::And(hn::Lt(x, size), hn::Lt(y, size)));
    const hn::RebindToSigned<D> whole;
    const auto column = hn::ConvertTo(whole, hn::IfThenElseZero(in_map, x));
    const auto row = hn::ConvertTo(whole, hn::IfThenElseZero(in_map, y));
    const auto texel = hn::Add(hn::Mul(row, hn::Set(whole, map_.width)), column);
    const auto word = hn::ShiftLeft<2>(texel);
    const float* words = &map_.texels[0].occluder;
    const V occluder = hn::GatherIndex(kTag, words, word);
    const V umbra = hn::GatherIndex(kTag, words + 1, word);
    const V penumbra = hn::GatherIndex(kTag, words + 2, word);
    const V edge = hn::GatherIndex(kTag, words + 3, word);

    const M hidden =
        hn::And(hn::Ge(umbra, zero), hn::Or(points.unlit, hn::Lt(points.inverse, occluder)));
    const V crossed = hn::IfThenElse(hidden, umbra, penumbra);
    V of_edge = edge;
    if (map_.penumbra_edge) {
      const V other = hn::GatherIndex(kTag, map_.penumbra_edge.get(), texel);
      of_edge = hn::IfThenElse(hidden, edge, other);
    }
    // Before the side that its ray crosses a point is in the umbra, or in the light.
    const M beyond = hn::Lt(points.inverse, crossed);
    const V way = hn::IfThenElseZero(beyond, through(points.inverse, crossed, of_edge));
    const V t = hn::IfThenElse(hidden, way, hn::Sub(set(1.0F), way));
    return hn::IfThenElse(in_map, visible_part(t), set(1.0F));
  }

  // How far points are through the penumbra of an edge from where its volume's side is crossed: 0
  // there, 1/2 at the plane through the centre and the edge. All by inverse distances.
  HWY_INLINE V through(V point, V crossed, V edge) const {
    const V way = hn::Sub(crossed, point);
    const V two = set(2.0F);
    if (options_.parameter == DBufferPixels::Parameter::derived) {
      return between_0_and_1(hn::Div(way, hn::Mul(two, hn::Sub(edge, point))));
    }
    return between_0_and_1(
        hn::Div(hn::Mul(way, crossed), hn::Mul(hn::Mul(two, point), hn::Sub(edge, crossed))));
  }

  HWY_INLINE V visible_part(V t) const {
    switch (options_.falloff) {
      case DBufferPixels::Falloff::smooth:
        return hn::Mul(hn::Sub(set(3.0F), hn::Mul(set(2.0F), t)), hn::Mul(t, t));
      case DBufferPixels::Falloff::sqrt:
        return hn::Sqrt(t);
      case DBufferPixels::Falloff::exact:
        break;
    }
    return area_beside_line(t);
  }

  const DBuffer& map_;
  DBufferPixels options_;
  std::array<std::array<float, 3>, 3> ray_;  // of each axis of the world: dx, dy, at (0, 0)
};

std::uint64_t look_up_row(const MethodInput& input, const DBuffer& map,
                          const LightFromEye& from_eye, const std::vector<Facing>& facings,
                          const DBufferPixels& options, int y, float* values) {
  const Lookup lookup(map, options);
  std::uint64_t looked_up = 0;
  LightPlaces places;
  std::array<float, LightPlaces::kPixels> in_shade{};
  for (int x = 0; x < input.window.width; x += LightPlaces::kPixels) {
    const int pixels = std::min(LightPlaces::kPixels, input.window.width - x);
    const auto some = static_cast<std::size_t>(pixels);
    place_pixels(from_eye, input.depth, x, y, pixels, places);
    const std::uint32_t* triangles =
        &input.depth
             .triangle[static_cast<std::size_t>(y) * static_cast<std::size_t>(input.window.width) +
                       static_cast<std::size_t>(x)];
    for (std::size_t i = 0; i < some; ++i) {
      in_shade[i] =
          triangles[i] != DepthBuffer::kSky && facings[triangles[i]] != Facing::light ? 1.0F : 0.0F;
    }
    for (std::size_t i = 0; i < some; i += kLanes) {
      const V px = load(&places.x[i]);
      const V py = load(&places.y[i]);
      M on = lookup.shows(px, py);
      on = hn::And(on, hn::FirstN(kTag, some - i));
      if (hn::AllFalse(kTag, on)) continue;
      looked_up += hn::CountTrue(kTag, on);
      const M shade = hn::Gt(load(&in_shade[i]), hn::Zero(kTag));
      const V value = lookup.visible(px, py, load(&places.inverse_depth[i]), shade);
      hn::BlendedStore(value, on, kTag, values + x + i);
    }
  }
  return looked_up;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(look_up_row);
}  // namespace

std::uint64_t look_up_pixels(const MethodInput& input, const DBuffer& map,
                             const std::vector<Facing>& facings, const DBufferPixels& options,
                             std::vector<float>& values) {
  const LightFromEye from_eye(map.view, input.window);
  const auto width = static_cast<std::size_t>(input.window.width);
  std::vector<std::uint64_t> looked_up(static_cast<std::size_t>(input.window.height), 0);
  tbb::parallel_for(std::size_t{0}, looked_up.size(), [&](std::size_t y) {
    looked_up[y] = HWY_DYNAMIC_DISPATCH(look_up_row)(
        input, map, from_eye, facings, options, static_cast<int>(y), values.data() + y * width);
  });
  const std::uint64_t all = std::accumulate(looked_up.begin(), looked_up.end(), std::uint64_t{0});
  return options.bilinear ? 4 * all : all;
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE

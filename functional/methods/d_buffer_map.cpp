#include "functional/methods/d_buffer_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "functional/methods/caster_layer.h"

namespace wedgesim::functional {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();
constexpr float kNothing = -1.0F;             // a key where there is no umbra
constexpr double kBeforeFirstVertex = 0.999;  // the near plane, of the least height of a caster
// |cx_o| lies this share of the way through a caster before the far side.
constexpr float kInside = 0.05F;
using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  return {mesh.positions[triangle[0]], mesh.positions[triangle[1]], mesh.positions[triangle[2]]};
}

LightView view_of(const Scene& scene, const LightDisk& disk,
                  const std::vector<DiskVolumes>& volumes, int resolution) {
  std::vector<glm::dvec3> points;
  double least = std::numeric_limits<double>::infinity();
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      points.push_back(p);
      least = std::min(least, disk.height(p));
    }
  }
  for (const DiskVolumes& caster : volumes) {
    for (const VolumeTriangle& triangle : caster.penumbra) {
      points.insert(points.end(), triangle.corners.begin(), triangle.corners.end());
    }
  }
  if (points.empty()) return {};
  return make_light_view(disk.centre, disk.normal, kBeforeFirstVertex * least, points, resolution);
}

// How near something on a ray is: 1/w where distances are exact, else 1/distance of interpolated
// distances. What is kept of a texel becomes a distance only at the end.
class Keys {
 public:
  Keys(const LightView& view, Distances kind) : centre_(view.eye), rays_(view), kind_(kind) {}

  // Calls texel(x, key) for x_begin ≤ x < x_end.
  template <typename Texel>
  void along(const MapTriangle& t, const Corners& corners, int y, int x_begin, int x_end,
             Texel&& texel) const {
    const TexelPlane& plane = t.inverse_w;
    const double row = plane.b * (y + 0.5) + plane.c;
    const double low = 1.0 / t.w_high;
    const double high = 1.0 / t.w_low;
    if (kind_ == Distances::exact) {
      for (int x = x_begin; x < x_end; ++x) {
        texel(x, static_cast<float>(std::clamp(plane.a * (x + 0.5) + row, low, high)));
      }
      return;
    }
    const TexelPlane distance = t.over_w(distances(corners));
    for (int x = x_begin; x < x_end; ++x) {
      const double inverse = std::clamp(plane.a * (x + 0.5) + row, low, high);
      texel(x, static_cast<float>(inverse / distance.at(x + 0.5, y + 0.5)));
    }
  }

  double distance(double x, double y, float key) const {
    return kind_ == Distances::exact ? rays_.length(x, y) / static_cast<double>(key)
                                     : 1.0 / static_cast<double>(key);
  }

  // |cx_s| of a side that is at (x, y).
  double edge_distance(const MapTriangle& t, const VolumeTriangle& side, double x, double y,
                       float key) const {
    const double d = distance(x, y, key);
    if (kind_ == Distances::exact) {
      return d / std::max(1.0, t.over_w(side.ratios).at(x, y) / static_cast<double>(key));
    }
    std::array<double, 3> at_corners = distances(side.corners);
    for (std::size_t i = 0; i < 3; ++i) at_corners[i] /= side.ratios[i];
    return std::min(d, t.over_w(at_corners).at(x, y) * t.w(x, y));
  }

 private:
  std::array<double, 3> distances(const Corners& corners) const {
    return {glm::distance(corners[0], centre_), glm::distance(corners[1], centre_),
            glm::distance(corners[2], centre_)};
  }

  glm::dvec3 centre_;
  MapRays rays_;
  Distances kind_;
};

// Sides of a volume and how they are drawn.
struct Sides {
  Sides(const LightView& view, std::vector<VolumeTriangle> all)
      : triangles(std::move(all)), drawn(view, corners_of_all(triangles)) {}
  static std::vector<Corners> corners_of_all(const std::vector<VolumeTriangle>& sides) {
    std::vector<Corners> corners;
    corners.reserve(sides.size());
    for (const VolumeTriangle& side : sides) corners.push_back(side.corners);
    return corners;
  }

  std::vector<VolumeTriangle> triangles;
  MapTriangles drawn;
};

class Drawer {
 public:
  Drawer(const Scene& scene, const DBufferOptions& options, const LightView& view)
      : scene_(scene),
        options_(options),
        size_(static_cast<std::size_t>(view.width)),
        keys_(view, options.distances),
        surface_(size_ * size_, 0.0F),
        layer_(size_ * size_),
        row_tests_(size_, 0),
        row_writes_(size_, 0) {
    map_.view = view;
    map_.width = view.width;
    map_.occluder.assign(size_ * size_, 0.0F);
    map_.umbra.assign(size_ * size_, kNothing);
    map_.penumbra.assign(size_ * size_, 0.0F);
    map_.umbra_edge.assign(size_ * size_, 0.0F);
    map_.penumbra_edge.assign(options.two_edges ? size_ * size_ : 0, 0.0F);
  }

  // The surfaces of all that only receives.
  void draw_receivers() {
    std::vector<Corners> triangles;
    for (const Object& object : scene_.objects) {
      if (object.casts) continue;
      for (const auto& t : object.mesh.triangles) triangles.push_back(corners_of(object.mesh, t));
    }
    draw({map_.view, triangles}, triangles, [&](const MapTriangle&, int y) {
      return [this, y](std::size_t texel, float key) { raise(surface_[texel], key, y); };
    });
  }

  // A caster's faces and umbra volume: |cx_o|, |cx_uv|, |cx_s|.
  void draw_umbra(const Mesh& mesh, const DiskSilhouettes& silhouettes,
                  const DiskVolumes& volumes) {
    std::vector<Corners> faces;
    faces.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) faces.push_back(corners_of(mesh, t));
    const MapTriangles drawn(map_.view, faces);
    draw(drawn, faces, [&](const MapTriangle& t, int y) {
      const bool lit = silhouettes.facings[t.index] != DiskFacing::none;
      return [this, y, lit, enters = t.faces_light](std::size_t texel, float key) {
        if (enters) {
          raise(surface_[texel], key, y);
          layer_[texel].enter(key);
        } else {
          layer_[texel].leave(key);
        }
        if (lit) layer_[texel].cross(enters);
      };
    });
    std::vector<VolumeTriangle> all = volumes.umbra;
    const std::size_t quads = all.size();
    all.insert(all.end(), volumes.back_belt.begin(), volumes.back_belt.end());
    const Sides sides(map_.view, std::move(all));
    draw(sides.drawn, Sides::corners_of_all(sides.triangles), [&](const MapTriangle& t, int) {
      return [this, quad = t.index < quads, leaves = !t.faces_light, id = sides.drawn.id(t)](
                 std::size_t texel, float key) {
        CasterLayer::Texel& layer = layer_[texel];
        if (quad) layer.cross(!leaves);
        // Of quads that have run past the other side of their caster, none before it counts.
        if (leaves && key <= layer.entry) layer.offer({key, id});
      };
    });
    merge(united(drawn.box(), sides.drawn.box()),
          [&](CasterLayer::Texel& layer, std::size_t texel, int x, int y) {
            if (layer.entries == 0) return;
            const float exit = layer.exit > 0.0F ? layer.exit : layer.entry;
            raise(map_.occluder[texel], exit + kInside * (layer.entry - exit), y);
            const bool near = options_.crossing == Crossing::nearest ||
                              (options_.crossing == Crossing::by_caster && layer.entries == 1);
            const SideKey side = near ? layer.nearest : layer.farthest;
            // A ray that grazes the caster may leave before, by rounding, it enters.
            const bool grazes = layer.inside <= 0 && side.key == 0.0F;
            const float key = layer.inside > 0 ? 0.0F : (grazes ? layer.entry : side.key);
            float& umbra = map_.umbra[texel];
            if (umbra != kNothing && !(nearest_caster() ? key > umbra : key < umbra)) return;
            umbra = key;
            if (grazes) {
              map_.umbra_edge[texel] = static_cast<float>(keys_.distance(x + 0.5, y + 0.5, key));
            } else if (key > 0.0F) {
              map_.umbra_edge[texel] = edge_distance(sides, side, x, y);
            }
            ++row_writes_[static_cast<std::size_t>(y)];
          });
  }

  // A caster's penumbra volume, where it is in front of all surfaces: |cx_pv|, |cx_s|.
  void draw_penumbra(const DiskVolumes& volumes) {
    const Sides sides(map_.view, volumes.penumbra);
    draw(sides.drawn, Sides::corners_of_all(sides.triangles), [&](const MapTriangle& t, int) {
      return [this, enters = t.faces_light, id = sides.drawn.id(t)](std::size_t texel, float key) {
        if (enters && key > surface_[texel]) layer_[texel].offer({key, id});
      };
    });
    merge(sides.drawn.box(), [&](CasterLayer::Texel& layer, std::size_t texel, int x, int y) {
      if (layer.nearest.key == 0.0F) return;
      if (!options_.two_edges && map_.umbra[texel] != kNothing) return;
      const SideKey side = options_.crossing == Crossing::farthest ? layer.farthest : layer.nearest;
      float& penumbra = map_.penumbra[texel];
      const bool better = nearest_caster() ? side.key > penumbra : side.key < penumbra;
      if (penumbra != 0.0F && !better) return;
      penumbra = side.key;
      auto& edges = options_.two_edges ? map_.penumbra_edge : map_.umbra_edge;
      edges[texel] = edge_distance(sides, side, x, y);
      ++row_writes_[static_cast<std::size_t>(y)];
    });
  }

  // Turns keys into distances.
  DBuffer finish() {
    tbb::parallel_for(std::size_t{0}, size_, [&](std::size_t y) {
      for (std::size_t x = 0; x < size_; ++x) {
        const std::size_t texel = y * size_ + x;
        float& occluder = map_.occluder[texel];
        float& umbra = map_.umbra[texel];
        float& penumbra = map_.penumbra[texel];
        const bool nothing = occluder == 0.0F && umbra == kNothing && penumbra == 0.0F;
        const double of_unit = nothing ? 1.0
                                       : keys_.distance(static_cast<double>(x) + 0.5,
                                                        static_cast<double>(y) + 0.5, 1.0F);
        const auto distance = [of_unit](float key) {
          return key == 0.0F ? kNowhere : static_cast<float>(of_unit / static_cast<double>(key));
        };
        occluder = distance(occluder);
        umbra = umbra == kNothing ? 0.0F : distance(umbra);
        penumbra = distance(penumbra);
      }
    });
    map_.tests = std::accumulate(row_tests_.begin(), row_tests_.end(), std::uint64_t{0});
    map_.writes = std::accumulate(row_writes_.begin(), row_writes_.end(), std::uint64_t{0});
    return std::move(map_);
  }

 private:
  bool nearest_caster() const { return options_.crossing == Crossing::nearest; }

  void raise(float& kept, float key, int y) {
    if (!(key > kept)) return;
    kept = key;
    ++row_writes_[static_cast<std::size_t>(y)];
  }

  float edge_distance(const Sides& sides, const SideKey& side, int x, int y) const {
    const MapTriangle& t = sides.drawn[side.triangle];
    return static_cast<float>(
        keys_.edge_distance(t, sides.triangles[t.index], x + 0.5, y + 0.5, side.key));
  }

  // \param make_texel  of a triangle and a row: the function that is called with texel and key
  template <typename MakeTexel>
  void draw(const MapTriangles& drawn, const std::vector<Corners>& corners,
            MakeTexel&& make_texel) {
    drawn.for_each_row([&](const MapTriangle& t, int y, int x_begin, int x_end) {
      row_tests_[static_cast<std::size_t>(y)] += static_cast<std::uint64_t>(x_end - x_begin);
      const auto texel = make_texel(t, y);
      const std::size_t row = static_cast<std::size_t>(y) * size_;
      keys_.along(t, corners[t.index], y, x_begin, x_end,
                  [&](int x, float key) { texel(row + static_cast<std::size_t>(x), key); });
    });
  }

  static MapTriangles::Box united(const MapTriangles::Box& a, const MapTriangles::Box& b) {
    return {std::min(a.x_begin, b.x_begin), std::max(a.x_end, b.x_end),
            std::min(a.y_begin, b.y_begin), std::max(a.y_end, b.y_end)};
  }

  // Takes over the layer where a caster may have been drawn, and empties it there.
  template <typename Take>
  void merge(const MapTriangles::Box& box, Take&& take) {
    tbb::parallel_for(box.y_begin, std::max(box.y_begin, box.y_end), [&](int y) {
      for (int x = box.x_begin; x < box.x_end; ++x) {
        const std::size_t texel = static_cast<std::size_t>(y) * size_ + static_cast<std::size_t>(x);
        if (layer_[texel].untouched()) continue;
        take(layer_[texel], texel, x, y);
        layer_[texel] = {};
      }
    });
  }

  const Scene& scene_;
  DBufferOptions options_;
  std::size_t size_;
  Keys keys_;
  std::vector<float> surface_;  // key of the nearest surface of all that is there
  CasterLayer layer_;
  std::vector<std::uint64_t> row_tests_, row_writes_;
  DBuffer map_;
};

}  // namespace

DBuffer draw_d_buffer(const Scene& scene, const LightDisk& disk,
                      const std::vector<DiskSilhouettes>& silhouettes,
                      const std::vector<DiskVolumes>& volumes, const DBufferOptions& options) {
  const LightView view = view_of(scene, disk, volumes, options.resolution);
  if (view.width == 0) return {};
  Drawer drawer(scene, options, view);
  drawer.draw_receivers();
  std::size_t caster = 0;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    drawer.draw_umbra(object.mesh, silhouettes[caster], volumes[caster]);
    ++caster;
  }
  // Only now is every surface known.
  for (const DiskVolumes& of_caster : volumes) drawer.draw_penumbra(of_caster);
  return drawer.finish();
}

}  // namespace wedgesim::functional

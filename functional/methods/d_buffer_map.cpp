#include "functional/methods/d_buffer_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

namespace wedgesim::functional {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();
constexpr double kBeforeFirstVertex = 0.999;  // the near plane, of the least height of a caster
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

// Distances from the light's centre along one row of one triangle.
class RowDistances {
 public:
  RowDistances(const MapRays& rays, const glm::dvec3& centre, Distances kind)
      : rays_(rays), centre_(centre), kind_(kind) {}

  // Calls texel(x, distance) for x_begin ≤ x < x_end.
  template <typename Texel>
  void operator()(const MapTriangle& triangle, const Corners& corners, int y, int x_begin,
                  int x_end, Texel&& texel) const {
    if (kind_ == Distances::exact) {
      for (int x = x_begin; x < x_end; ++x) {
        texel(x, triangle.w(x + 0.5, y + 0.5) * rays_.length(x + 0.5, y + 0.5));
      }
      return;
    }
    const TexelPlane over_w = triangle.over_w(distances(corners));
    for (int x = x_begin; x < x_end; ++x) {
      texel(x, triangle.w(x + 0.5, y + 0.5) * over_w.at(x + 0.5, y + 0.5));
    }
  }

  std::array<double, 3> distances(const Corners& corners) const {
    return {glm::distance(corners[0], centre_), glm::distance(corners[1], centre_),
            glm::distance(corners[2], centre_)};
  }
  Distances kind() const { return kind_; }

 private:
  MapRays rays_;
  glm::dvec3 centre_;
  Distances kind_;
};

// |cx_s| on one triangle of a volume, from the distance of the point and its place in the map.
class EdgeDistance {
 public:
  EdgeDistance(const MapTriangle& drawn, const VolumeTriangle& triangle,
               const RowDistances& distances)
      : drawn_(drawn), exact_(distances.kind() == Distances::exact) {
    if (exact_) {
      over_w_ = drawn.over_w(triangle.ratios);
    } else {
      std::array<double, 3> at_corners = distances.distances(triangle.corners);
      for (std::size_t i = 0; i < 3; ++i) at_corners[i] /= triangle.ratios[i];
      over_w_ = drawn.over_w(at_corners);
    }
  }
  float operator()(int x, int y, double distance) const {
    const double value = drawn_.w(x + 0.5, y + 0.5) * over_w_.at(x + 0.5, y + 0.5);
    const double edge = exact_ ? distance / std::max(1.0, value) : std::min(value, distance);
    return static_cast<float>(edge);
  }

 private:
  const MapTriangle& drawn_;
  bool exact_;
  TexelPlane over_w_;
};

// What one caster has on the rays of a map; all empty between two casters.
struct CasterLayer {
  explicit CasterLayer(std::size_t texels)
      : entries(texels, 0), inside(texels, 0), distance(texels, 0.0F), edge(texels, 0.0F) {}
  std::vector<std::uint8_t> entries;  // whether the ray enters it
  std::vector<std::int16_t> inside;   // umbra volumes entered less those left
  std::vector<float> distance;        // of the crossing kept; 0 if none
  std::vector<float> edge;            // |cx_s| there

  void offer(std::size_t texel, float d, Keep keep, const auto& edge_of) {
    float& kept = distance[texel];
    if (kept != 0.0F && !(keep == Keep::nearest ? d < kept : d > kept)) return;
    kept = d;
    edge[texel] = edge_of();
  }
  void cross(std::size_t texel, bool into) { into ? ++inside[texel] : --inside[texel]; }
  void clear(std::size_t texel) {
    entries[texel] = 0;
    inside[texel] = 0;
    distance[texel] = 0.0F;
  }
};

class Drawer {
 public:
  Drawer(const Scene& scene, const LightDisk& disk, const DBufferOptions& options,
         const LightView& view)
      : scene_(scene),
        options_(options),
        size_(static_cast<std::size_t>(view.width)),
        distances_(MapRays(view), disk.centre, options.distances),
        within_(options.crossing == Crossing::farthest ? Keep::farthest : Keep::nearest),
        among_(options.crossing == Crossing::nearest ? Keep::nearest : Keep::farthest),
        surface_(size_ * size_, kNowhere),
        layer_(size_ * size_),
        row_tests_(size_, 0),
        row_writes_(size_, 0) {
    map_.view = view;
    map_.width = view.width;
    map_.occluder.assign(size_ * size_, kNowhere);
    map_.umbra.assign(size_ * size_, 0.0F);
    map_.penumbra.assign(size_ * size_, kNowhere);
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
    draw(triangles, [&](const MapTriangle& t, int y, int x_begin, int x_end) {
      distances_(t, triangles[t.index], y, x_begin, x_end,
                 [&](int x, double d) { lower(surface_, at(x, y), static_cast<float>(d), y); });
    });
  }

  // A caster's faces and umbra quads: |cx_o|, |cx_uv|, |cx_s|.
  void draw_umbra(const Mesh& mesh, const DiskSilhouettes& silhouettes,
                  const DiskVolumes& volumes) {
    std::vector<Corners> faces;
    faces.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles) faces.push_back(corners_of(mesh, t));
    MapTriangles::Box box = draw(faces, [&](const MapTriangle& t, int y, int x_begin, int x_end) {
      const bool lit = silhouettes.facings[t.index] != DiskFacing::none;
      distances_(t, faces[t.index], y, x_begin, x_end, [&](int x, double d) {
        const std::size_t texel = at(x, y);
        lower(t.faces_light ? surface_ : map_.occluder, texel, static_cast<float>(d), y);
        if (t.faces_light) layer_.entries[texel] = 1;
        if (lit) layer_.cross(texel, t.faces_light);
      });
    });
    std::vector<VolumeTriangle> sides = volumes.umbra;
    const std::size_t quads = sides.size();
    sides.insert(sides.end(), volumes.back_belt.begin(), volumes.back_belt.end());
    box = united(box, draw_sides(sides, [&](const MapTriangle& t, std::size_t texel, float d,
                                            const auto& edge_of) {
                   if (t.index < quads) layer_.cross(texel, t.faces_light);
                   if (!t.faces_light) layer_.offer(texel, d, within_, edge_of);
                 }));
    merge(box, [&](std::size_t texel, int y) {
      if (layer_.entries[texel] == 0) return;
      const float kept = layer_.distance[texel];
      const float d = layer_.inside[texel] > 0 || kept == 0.0F ? kNowhere : kept;
      float& umbra = map_.umbra[texel];
      if (umbra != 0.0F && !(among_ == Keep::nearest ? d < umbra : d > umbra)) return;
      umbra = d;
      map_.umbra_edge[texel] = layer_.edge[texel];
      ++row_writes_[static_cast<std::size_t>(y)];
    });
  }

  // A caster's penumbra volume, where it is in front of all surfaces: |cx_pv|, |cx_s|.
  void draw_penumbra(const DiskVolumes& volumes) {
    const MapTriangles::Box box =
        draw_sides(volumes.penumbra,
                   [&](const MapTriangle& t, std::size_t texel, float d, const auto& edge_of) {
                     if (t.faces_light && d < surface_[texel])
                       layer_.offer(texel, d, within_, edge_of);
                   });
    merge(box, [&](std::size_t texel, int y) {
      const float d = layer_.distance[texel];
      if (d == 0.0F || (!options_.two_edges && map_.umbra[texel] != 0.0F)) return;
      float& penumbra = map_.penumbra[texel];
      const bool better = among_ == Keep::nearest ? d < penumbra : d > penumbra;
      if (penumbra != kNowhere && !better) return;
      penumbra = d;
      (options_.two_edges ? map_.penumbra_edge : map_.umbra_edge)[texel] = layer_.edge[texel];
      ++row_writes_[static_cast<std::size_t>(y)];
    });
  }

  DBuffer finish() {
    map_.tests = std::accumulate(row_tests_.begin(), row_tests_.end(), std::uint64_t{0});
    map_.writes = std::accumulate(row_writes_.begin(), row_writes_.end(), std::uint64_t{0});
    return std::move(map_);
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * size_ + static_cast<std::size_t>(x);
  }

  void lower(std::vector<float>& map, std::size_t texel, float d, int y) {
    if (!(d < map[texel])) return;
    map[texel] = d;
    ++row_writes_[static_cast<std::size_t>(y)];
  }

  template <typename Row>
  MapTriangles::Box draw(const std::vector<Corners>& triangles, Row&& row) {
    const MapTriangles drawn(map_.view, triangles);
    drawn.for_each_row([&](const MapTriangle& t, int y, int x_begin, int x_end) {
      row_tests_[static_cast<std::size_t>(y)] += static_cast<std::uint64_t>(x_end - x_begin);
      row(t, y, x_begin, x_end);
    });
    return drawn.box();
  }

  // Calls side(triangle, texel, distance, function that gives |cx_s|).
  template <typename Side>
  MapTriangles::Box draw_sides(const std::vector<VolumeTriangle>& sides, Side&& side) {
    std::vector<Corners> triangles;
    triangles.reserve(sides.size());
    for (const VolumeTriangle& t : sides) triangles.push_back(t.corners);
    return draw(triangles, [&](const MapTriangle& t, int y, int x_begin, int x_end) {
      const EdgeDistance edge(t, sides[t.index], distances_);
      distances_(t, triangles[t.index], y, x_begin, x_end, [&](int x, double d) {
        side(t, at(x, y), static_cast<float>(d), [&] { return edge(x, y, d); });
      });
    });
  }

  static MapTriangles::Box united(const MapTriangles::Box& a, const MapTriangles::Box& b) {
    return {std::min(a.x_begin, b.x_begin), std::max(a.x_end, b.x_end),
            std::min(a.y_begin, b.y_begin), std::max(a.y_end, b.y_end)};
  }

  // Calls texel(index, row) where a caster may have been drawn and empties its layer there.
  template <typename Texel>
  void merge(const MapTriangles::Box& box, Texel&& texel) {
    tbb::parallel_for(box.y_begin, std::max(box.y_begin, box.y_end), [&](int y) {
      for (int x = box.x_begin; x < box.x_end; ++x) {
        texel(at(x, y), y);
        layer_.clear(at(x, y));
      }
    });
  }

  const Scene& scene_;
  DBufferOptions options_;
  std::size_t size_;
  RowDistances distances_;
  Keep within_, among_;
  std::vector<float> surface_;  // the nearest surface of all that is there
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
  Drawer drawer(scene, disk, options, view);
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

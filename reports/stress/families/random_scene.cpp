#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "reports/stress/families/random_case.h"
#include "reports/stress/families/random_genes.h"
#include "reports/stress/families/random_shapes.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Light;
using functional::LightShape;
using functional::Mesh;
using functional::Scene;

enum SceneGene : std::size_t {
  kKind = scene_place("kind"),
  kFormat = scene_place("format"),
  kZFail = scene_place("z_fail"),
  kLight = scene_place("light"),
  kLightSize = scene_place("light_size"),
  kLightFlat = scene_place("light_flat"),
  kLightTiltX = scene_place("light_tilt_x"),
  kLightTiltZ = scene_place("light_tilt_z"),
  kLightRoll = scene_place("light_roll"),
  kScale = scene_place("scale"),
  kOffset = scene_place("offset"),
  kOffsetWay = scene_place("offset_way"),
  kAxes = scene_place("axes"),
  kTurn = scene_place("turn"),
  kGrid = scene_place("grid"),
  kFloorTiltX = scene_place("floor_tilt_x"),
  kFloorTiltZ = scene_place("floor_tilt_z"),
  kFloorSize = scene_place("floor_size"),
  kWall = scene_place("wall"),
  kEyePlace = scene_place("eye_place"),
  kEyeX = scene_place("eye_x"),
  kEyeY = scene_place("eye_y"),
  kEyeZ = scene_place("eye_z"),
  kEyeDistance = scene_place("eye_distance"),
  kView = scene_place("view"),
  kNear = scene_place("near"),
  kFar = scene_place("far"),
  kTargetX = scene_place("target_x"),
  kTargetZ = scene_place("target_z"),
  kCloseUp = scene_place("close_up"),
  kUp = scene_place("up"),
  kCasters = scene_place("casters")
};
enum CasterGene : std::size_t {
  kShape = caster_place("shape"),
  kDepth = caster_place("depth"),
  kSize = caster_place("size"),
  kThick = caster_place("thick"),
  kPyramid = caster_place("pyramid"),
  kX = caster_place("x"),
  kZ = caster_place("z"),
  kCasterTurn = caster_place("turn"),
  kVertices = caster_place("x0"),  // and eleven more
  kMove = caster_place("move"),    // and three more
  kThen = caster_place("then"),    // likewise
};
static_assert(caster_place("z3") == kVertices + 11 && caster_place("move_by") == kMove + 3 &&
              caster_place("then_by") == kThen + 3);

constexpr double kFloorDepth = 2.0;  // below the light's centre, which is the origin at first
// Of the view: narrower ones would show the rounding of the scene's own coordinates.
constexpr double kNarrowest = 0x1p-18;
constexpr std::array<glm::dvec3, 4> kNudges{
    {{0.375, 0.25, 0.125}, {-0.25, 0.125, 0.375}, {0.125, -0.375, 0.25}, {-0.125, -0.25, -0.375}}};

double power(int exponent) { return std::ldexp(1.0, exponent); }

class Maker {
 public:
  explicit Maker(const Genes& genes) : genes_(genes) {}

  Case make() {
    Case result;
    Scene& scene = result.scene;
    scene.name = "random";
    scene.place = "random case";
    scene.width = scene.height = 8;
    make_light(scene.light);
    const std::size_t casters = genes_[kCasters] == 0 ? 1 : 2;
    for (std::size_t i = 0; i < casters; ++i) meshes_.push_back(make_caster(i));
    add_receivers(scene);
    for (std::size_t i = 0; i < casters; ++i) {
      meshes_[i].name = i == 0 ? "first" : "second";
      scene.objects.push_back({meshes_[i], true});
    }
    make_camera(scene.camera);
    place(scene);
    result.options.kind =
        genes_[kKind] == 1 ? traces::fb::WedgeKind_linear : traces::fb::WedgeKind_coverage;
    result.options.depth_format = static_cast<traces::fb::DepthFormat>(genes_[kFormat]);
    if (genes_[kZFail] == 1) result.options.z_method = traces::fb::ZMethod_fail;
    return result;
  }

 private:
  int caster_gene(std::size_t caster, std::size_t gene) const {
    return genes_[kSceneGenes + caster * kCasterGenes + gene];
  }

  double depth_of(std::size_t caster) const {
    const int depth = caster_gene(caster, kDepth);
    return depth > 0 ? kFloorDepth - power(-depth) : power(depth);
  }
  double size_of(std::size_t caster) const { return power(caster_gene(caster, kSize) - 2); }
  // As a slope: across for each unit of the way down.
  glm::dvec2 middle_of(std::size_t caster) const {
    return glm::dvec2(caster_gene(caster, kX), caster_gene(caster, kZ)) / 16.0;
  }

  void make_light(Light& light) const {
    const glm::dvec3 down(genes_[kLightTiltX], -16.0, genes_[kLightTiltZ]);
    const glm::dvec3 u = glm::cross(down, glm::dvec3(genes_[kLightRoll], 0.0, 8.0));
    const glm::dvec3 v = glm::cross(down, u);
    // Of the size of a caster that is near to the light.
    const int limit = genes_[kLight] == 0 ? 30 : 2;
    const double size = power(std::min(genes_[kLightSize], limit) - 2) * std::min(1.0, depth_of(0));
    if (genes_[kLight] == 0) {
      light.half_u = size * glm::normalize(u);
      light.half_v = size * power(-genes_[kLightFlat]) * glm::normalize(v);
    } else if (genes_[kLight] == 6) {
      light.shape = LightShape::point;
    } else {
      light.shape = LightShape::sphere;
      light.radius = size;
    }
  }

  Mesh make_caster(std::size_t caster) const {
    const Shape shape = shape_of(caster_gene(caster, kShape));
    const double depth = depth_of(caster);
    const double size = size_of(caster);
    const double thickness = power(caster_gene(caster, kThick) - 3);
    const double turn = 0.375 * caster_gene(caster, kCasterTurn);
    Mesh mesh;
    mesh.triangles = shape.triangles;
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
      glm::dvec3 p = shape.corners[i];
      if (turn != 0.0) {
        p = {std::cos(turn) * p.x - std::sin(turn) * p.z, p.y,
             std::sin(turn) * p.x + std::cos(turn) * p.z};
      }
      if (i < 4) {
        const std::size_t gene = kVertices + 3 * i;
        p += glm::dvec3(caster_gene(caster, gene), caster_gene(caster, gene + 1),
                        caster_gene(caster, gene + 2)) /
             8.0;
      }
      const glm::dvec2 slope = middle_of(caster) + size * glm::dvec2(p.x, p.z);
      const double down = depth * (1.0 - thickness * p.y);
      const double out = caster_gene(caster, kPyramid) == 1 ? down : depth;
      mesh.positions.emplace_back(out * slope.x, -down, out * slope.y);
    }
    move(mesh, caster, kMove);
    move(mesh, caster, kThen);
    snap(mesh, depth);
    return mesh;
  }

  // Puts one vertex where it is degenerate, or nearly so: exactly if `by` is 0.
  void move(Mesh& mesh, std::size_t caster, std::size_t gene) const {
    const int by = caster_gene(caster, gene + 3);
    const auto vertex = [&](int i) -> glm::dvec3& {
      return mesh.positions[static_cast<std::size_t>(i) % mesh.positions.size()];
    };
    const int number = caster_gene(caster, gene + 1);
    glm::dvec3& p = vertex(number);
    const glm::dvec3 b = vertex(caster_gene(caster, gene + 2));
    const glm::dvec3 c = vertex(caster_gene(caster, gene + 2) + 1);
    const double scale = depth_of(caster) * size_of(caster);
    const glm::dvec3 nudge =
        by == 0 ? glm::dvec3(0.0)
                : scale * power(-std::abs(by)) * kNudges[static_cast<std::size_t>(number) % 4];
    switch (caster_gene(caster, gene)) {
      case 1:  // onto another vertex
        p = b + nudge;
        break;
      case 2:  // onto the line through two others
        p = 0.5 * (b + c) + nudge;
        break;
      case 3:  // onto the line through the light and another
        p = 1.5 * b + nudge;
        break;
      case 4:  // into the plane through the light and two others
        p = 0.75 * b + 0.5 * c + nudge;
        break;
      case 5:  // far away from the light or near to it
        p *= power(by / 2);
        break;
      default:
        break;
    }
  }

  void snap(Mesh& mesh, double depth) const {
    if (genes_[kGrid] == 0) return;
    const double step = std::exp2(std::ceil(std::log2(depth))) * power(-genes_[kGrid]);
    for (glm::dvec3& p : mesh.positions) p = step * glm::round(p / step);
  }

  double floor_at(double x, double z) const {
    return (genes_[kFloorTiltX] * x + genes_[kFloorTiltZ] * z) / 16.0 - kFloorDepth;
  }

  // Where the first caster's shadow is, or that of its first vertex.
  glm::dvec3 target() const {
    const double step = view_width() / 8.0;
    const glm::dvec3& vertex = meshes_[0].positions[0];
    const glm::dvec2 slope = genes_[kCloseUp] == 1 && vertex.y < 0.0
                                 ? glm::dvec2(vertex.x, vertex.z) / -vertex.y
                                 : middle_of(0);
    const glm::dvec2 at =
        kFloorDepth * slope + step * glm::dvec2(genes_[kTargetX], genes_[kTargetZ]);
    return {at.x, floor_at(at.x, at.y), at.y};
  }

  double view_width() const {
    double width = 2.0 * kFloorDepth * size_of(0);
    if (genes_[kCloseUp] == 1) {
      const double light = power(std::min(genes_[kLightSize], 2) - 2);
      const double to_floor = kFloorDepth - depth_of(0);
      width = std::min(width, 4.0 * light * to_floor / std::max(1.0, depth_of(0)));
    }
    return std::max(width * power(genes_[kView]), kNarrowest);
  }

  void add_receivers(Scene& scene) const {
    const double half = power(genes_[kFloorSize] + 2);
    const glm::dvec2 at = kFloorDepth * middle_of(0);
    Mesh floor;
    floor.name = "floor";
    for (const auto& [x, z] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}) {
      const double px = at.x + half * x;
      const double pz = at.y + half * z;
      floor.positions.emplace_back(px, floor_at(px, pz), pz);
    }
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.objects.push_back({floor});
    if (genes_[kWall] == 0) return;
    Mesh wall;
    wall.name = "wall";
    const double x = at.x + 2.0 * size_of(0);
    wall.positions = {{x, -kFloorDepth - half, at.y - half},
                      {x, -kFloorDepth - half, at.y + half},
                      {x, -0.5 * kFloorDepth, at.y}};
    wall.triangles = {{0, 1, 2}};
    scene.objects.push_back({wall});
  }

  void make_camera(functional::Camera& camera) const {
    camera.target = target();
    glm::dvec3 way(4 + genes_[kEyeX], std::max(6 + genes_[kEyeY], 0), 1 + genes_[kEyeZ]);
    if (way == glm::dvec3(0.0)) way.y = 1.0;
    const double distance = view_width() * power(genes_[kEyeDistance] + 1);
    const Mesh& mesh = meshes_[0];
    const glm::dvec3 a = mesh.positions[0];
    const glm::dvec3 b = mesh.positions[1];
    const glm::dvec3 towards = distance * glm::normalize(way);
    switch (genes_[kEyePlace]) {
      case 1:  // in the plane of a shadow quad
        camera.eye = way.x / 8.0 * a + way.y / 8.0 * b;
        break;
      case 2:  // near the light
        camera.eye = power(-std::abs(genes_[kEyeDistance])) * glm::normalize(way);
        break;
      case 3:  // in the umbra
        camera.eye = camera.target * (0.5 + genes_[kEyeX] / 32.0);
        break;
      case 4:  // where it sees the floor nearly edge-on
        camera.eye = camera.target + glm::dvec3(towards.x, 0.0, towards.z);
        camera.eye.y =
            floor_at(camera.eye.x, camera.eye.z) + distance * power(-std::abs(genes_[kEyeY]));
        break;
      case 5:  // on the ray through a vertex
        camera.eye = 1.25 * a;
        break;
      default:
        camera.eye = camera.target + towards;
        break;
    }
    const double away = glm::distance(camera.eye, camera.target);
    camera.field_of_view_degrees =
        std::min(glm::degrees(2.0 * std::atan2(0.5 * view_width(), away)), 160.0);
    camera.near_plane = away * power(-3 - genes_[kNear]);
    camera.far_plane = away * power(3 + genes_[kFar]);
    constexpr std::array<glm::dvec3, 3> kUps{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    camera.up = kUps[static_cast<std::size_t>(genes_[kUp])];
  }

  // Into the world: turned, moved, scaled.
  void place(Scene& scene) const {
    glm::dmat3 turn(1.0);
    const auto first = static_cast<std::size_t>(genes_[kAxes]) % 3;
    for (std::size_t i = 0; i < 3; ++i) {
      glm::dvec3 axis(0.0);
      axis[static_cast<int>((i + first) % 3)] = genes_[kAxes] >= 3 && i != 1 ? -1.0 : 1.0;
      turn[static_cast<int>(i)] = axis;
    }
    if (genes_[kTurn] != 0) turn = off_the_axes(0.3 * genes_[kTurn]) * turn;
    const auto bit = [&](int i) { return (genes_[kOffsetWay] >> i) % 2 == 0 ? 1.0 : -0.375; };
    const glm::dvec3 offset = genes_[kOffset] == 0
                                  ? glm::dvec3(0.0)
                                  : power(genes_[kOffset]) * glm::dvec3(bit(0), bit(1), bit(2));
    const double scale = power(genes_[kScale]);
    const auto point = [&](const glm::dvec3& p) { return scale * (turn * p + offset); };
    for (functional::Object& object : scene.objects) {
      for (glm::dvec3& p : object.mesh.positions) p = point(p);
    }
    scene.light.centre = point(scene.light.centre);
    scene.light.half_u = scale * (turn * scene.light.half_u);
    scene.light.half_v = scale * (turn * scene.light.half_v);
    scene.light.radius *= scale;
    scene.camera.eye = point(scene.camera.eye);
    scene.camera.target = point(scene.camera.target);
    scene.camera.up = turn * scene.camera.up;
    scene.camera.near_plane *= scale;
    scene.camera.far_plane *= scale;
  }

  static glm::dmat3 off_the_axes(double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const glm::dmat3 about_y(c, 0, -s, 0, 1, 0, s, 0, c);
    const glm::dmat3 about_z(c, s, 0, -s, c, 0, 0, 0, 1);
    return about_z * about_y;
  }

  const Genes& genes_;
  std::vector<Mesh> meshes_;
};

}  // namespace

Case case_of(const Genes& genes) { return Maker(genes).make(); }

}  // namespace wedgesim::reports::stress

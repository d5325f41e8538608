#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// What families build their scenes from: a floor, a light above it, casters between them that the
/// light sees as polygons, and a camera below the casters that sees little else than the floor.

/// Height of the light above the floor, world units; "the size of the scene" in parameters.
inline constexpr double kSize = 8.0;
/// Along the edge of the floor.
inline constexpr double kFloorSide = 3.0 * kSize;
/// Of a light where nothing is said about it.
inline constexpr double kLightRadius = 0.8;
/// Slope from the middle of a caster to its corners.
inline constexpr double kAcross = 0.28;
/// How far below the light casters are that need no other place.
inline constexpr double kDepth = 5.0;

/// Numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) / 9007199254740992.0);
  }

 private:
  std::mt19937_64 engine_;
};

/// Directions from the light are slopes: (x, z) for each unit of the way down.
using Slope = glm::dvec2;

/// A case without casters.
struct Stage {
  Case result;
  Random random;
  Slope aim;  // where casters should be: the camera looks at their shadow

  functional::Light& light() { return result.scene.light; }
  functional::Camera& camera() { return result.scene.camera; }
};

/// The floor, the light of a seed's variant of radius `light_radius` and a camera.
Stage make_stage(std::uint64_t seed, double light_radius);

/// Half the larger side of a rectangular light, the radius of a sphere.
double radius_of(const functional::Light& light);
/// Scales a light to a radius; 0 makes it a point.
void resize(functional::Light& light, double radius);

/// The point, or points, below the light in a direction.
/// \param depth  along y, world units
glm::dvec3 below(const functional::Light& light, const Slope& slope, double depth);
std::vector<glm::dvec3> below(const functional::Light& light, const std::vector<Slope>& slopes,
                              double depth);
/// The slope rounded to 1/1024, so that points in it at depths of few bits are exact.
Slope on_grid(const Slope& slope);
/// Slopes of a regular polygon round `middle`, from +x towards +z.
std::vector<Slope> ring(const Slope& middle, double radius, int corners, double turn);

/// A closed mesh whose silhouette from the light is a given loop: two pyramids over it, one nearer
/// to the light, one farther. What faces the light does so by the slopes of the loop alone.
/// \param middle  slope about which the loop is star-shaped
/// \param loop    corners from +x towards +z
functional::Mesh between_pyramids(const functional::Light& light, const Slope& middle,
                                  const std::vector<glm::dvec3>& loop);

/// A square round the aim at kDepth: a harmless caster.
/// \return its corners, from +x towards +z
std::vector<glm::dvec3> add_plate(Stage& stage);

void add_caster(Case& result, functional::Mesh mesh, const std::string& name = "caster");

/// Powers of ten from 10^first to 10^last, rising or falling, each the double nearest to it.
/// \param first, last  -12 to 12
std::vector<double> decades(int first, int last);
/// The same followed by more.
std::vector<double> decades(int first, int last, const std::vector<double>& then);

}  // namespace wedgesim::reports::stress

#include "functional/methods/linear_volumes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "base/check.h"
#include "base/error.h"
#include "functional/geometry/linear_wedge.h"
#include "functional/geometry/round_corners.h"
#include "functional/methods/screen_sides.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

class Builder {
 public:
  Builder(const Scene& scene, const Window& window, const Light& light,
          const LinearChoices& choices)
      : light_(light),
        choices_(choices),
        sides_(window),
        pyramid_(window),
        bounds_(bounds_of(scene.objects)) {
    bounds_.grow(light.centre);
  }

  std::vector<ScreenSide> volume(const ShadowCaster& caster) const {
    const auto& loops = caster.silhouette.loops;
    std::vector<std::vector<ScreenSide>> parts(loops.size());
    std::vector<std::vector<glm::dvec3>> far(loops.size());
    std::vector<std::uint8_t> meets(loops.size(), 0);
    tbb::parallel_for(std::size_t{0}, loops.size(), [&](std::size_t i) {
      meets[i] = add_loop(caster, loops[i], parts[i], far[i]) ? 1 : 0;
    });
    std::vector<ScreenSide> all;
    for (auto& part : parts) std::move(part.begin(), part.end(), std::back_inserter(all));
    if (!choices_.umbra_polygons) return all;
    const bool needed = std::ranges::find(meets, 1) != meets.end() ||
                        ends_need_z_fail(caster, light_.centre, pyramid_);
    if (needed && choices_.z == ZChoice::pass) refuse_z_pass(caster.mesh->name);
    const bool z_fail = choices_.z == ZChoice::fail || (choices_.z == ZChoice::automatic && needed);
    if (!z_fail) return all;
    add_caps(caster, all);
    const SidedPlane bottom(caster.end_plane.plane);
    for (const std::vector<glm::dvec3>& corners : far) {
      for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const std::array<glm::dvec3, 3> outline{corners[0], corners[i + 1], corners[i]};
        sides_.add_umbra(outline, bottom, fb::UmbraRole_bottom, true, all);
      }
    }
    for (ScreenSide& side : all) side.umbra.z_fail = true;
    return all;
  }

 private:
  // True if z-pass would be wrong with it.
  bool add_loop(const ShadowCaster& caster, const std::vector<SilhouetteEdge>& loop,
                std::vector<ScreenSide>& sides, std::vector<glm::dvec3>& far) const {
    std::vector<glm::dvec3> corners;
    for (const SilhouetteEdge& edge : loop) corners.push_back(caster.mesh->positions[edge.begin]);
    if (choices_.round_corners) corners = round_corners(corners, light_.centre);
    bool meets = false;
    for (const LinearWedge& wedge :
         linear_wedges(light_, std::move(corners), caster.end_plane, bounds_)) {
      const std::size_t first = sides.size();
      if (choices_.umbra_polygons) meets |= add_front(wedge, sides);
      add_wedge(wedge, first, sides);
      far.push_back(wedge.umbra[2]);
    }
    return meets;
  }

  // The front face of a wedge; where its rays had to leave the front plane it is two triangles in
  // planes of their own.
  bool add_front(const LinearWedge& wedge, std::vector<ScreenSide>& sides) const {
    const std::array<glm::dvec3, 4>& outline = wedge.umbra;
    const glm::dvec4& front = wedge.volume.planes[0];
    const double tolerance = 1e-9 * glm::distance(outline[0], outline[2]);
    const bool flat = std::all_of(outline.begin() + 2, outline.end(), [&](const glm::dvec3& p) {
      return std::abs(glm::dot(glm::dvec3(front), p) + front.w) <= tolerance;
    });
    if (flat) {
      sides_.add_umbra(outline, SidedPlane(front), fb::UmbraRole_side, true, sides);
    } else {
      for (const std::size_t i : {1U, 2U}) {
        const std::array<glm::dvec3, 3> triangle{outline[0], outline[i], outline[i + 1]};
        const glm::dvec3 out = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        sides_.add_umbra(triangle, SidedPlane({-out, glm::dot(out, triangle[0])}),
                         fb::UmbraRole_side, true, sides);
      }
    }
    return pyramid_.meets(outline);
  }

  void add_wedge(const LinearWedge& wedge, std::size_t first,
                 std::vector<ScreenSide>& sides) const {
    if (wedge.volume.faces.empty()) return;
    ScreenWedge* screen =
        sides_.add_wedge(wedge.volume, SidedPlane(wedge.volume.planes[0]), first, sides);
    if (screen == nullptr) return;
    CHECK_LE(screen->planes.size(), screen->forms.size());
    screen->forms.fill(WindowForm(0.0, 0.0, 0.0, 1.0));
    std::ranges::copy(screen->planes, screen->forms.begin());
    std::ranges::transform(wedge.factors, screen->constants.begin(),
                           [](double factor) { return static_cast<float>(factor); });
    // Where the wedge adds even to points beyond it, only what is before all of it is culled.
    if (!choices_.umbra_polygons) screen->planes.clear();
  }

  void add_caps(const ShadowCaster& caster, std::vector<ScreenSide>& sides) const {
    const Mesh& mesh = *caster.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (caster.silhouette.light_facing[t] == 0) continue;
      const auto& corner = mesh.triangles[t];
      const std::array<glm::dvec3, 3> outline{mesh.positions[corner[0]], mesh.positions[corner[1]],
                                              mesh.positions[corner[2]]};
      sides_.add_umbra(outline, SidedPlane(), fb::UmbraRole_cap, false, sides);
    }
  }

  const Light& light_;
  LinearChoices choices_;
  ScreenSides sides_;
  NearPyramid pyramid_;
  Bounds bounds_;
};

}  // namespace

std::vector<ScreenSide> build_linear_volumes(const Scene& scene, const Window& window,
                                             const Light& light,
                                             const std::vector<ShadowCaster>& casters,
                                             const LinearChoices& choices) {
  const Builder builder(scene, window, light, choices);
  std::vector<ScreenSide> sides;
  for (const ShadowCaster& caster : casters) {
    try {
      std::vector<ScreenSide> volume = builder.volume(caster);
      std::move(volume.begin(), volume.end(), std::back_inserter(sides));
    } catch (const InputError& error) {
      throw InputError(scene.place, error.what());
    }
  }
  return sides;
}

}  // namespace wedgesim::functional

// Run times as the papers print them.
#include <array>

#include "reports/accuracy/published.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr std::string_view kPaper1 = "Paper I";
constexpr std::string_view kPaper2 = "Paper II";
constexpr std::string_view kPaper3 = "Paper III";
constexpr std::string_view kPaper4 = "Paper IV";
constexpr std::string_view kDBuffer = "D-buffer";
constexpr std::string_view kOcclusion = "Occlusion camera";
constexpr std::string_view kRings = "Silhouette rings";

constexpr std::string_view kAthlon = "Athlon 1.5 GHz, in software";
constexpr std::string_view kPentium = "Pentium 4 1.7 GHz, GeForce3, wedges in software";
constexpr std::string_view kSoftware = "PC of 1.3 to 2.4 GHz, in software";
constexpr std::string_view kRadeon = "Radeon 9800";
constexpr std::string_view kQuadro = "PC of 3 GHz, Quadro FX 3000";
constexpr std::string_view kGeForce8 = "Xeon 3.2 GHz, GeForce 8800 GTX";

using Stages = std::array<PublishedStage, 4>;
constexpr Stages stages_of(double silhouettes, double shadow_map, double distortion_map,
                           double pixels) {
  return {{{"silhouettes", silhouettes},
           {"shadow map", shadow_map},
           {"distortion map", distortion_map},
           {"pixels", pixels}}};
}
constexpr Stages kBunny = stages_of(8.0, 0.8, 1.7, 8.2);
constexpr Stages kCow = stages_of(2.6, 0.5, 0.6, 5.0);
constexpr Stages kDragon = stages_of(27.7, 1.8, 5.3, 16.5);
constexpr Stages kF16 = stages_of(0.4, 0.4, 0.4, 4.7);
constexpr Stages kTeapots = stages_of(1.2, 0.4, 0.5, 4.9);
constexpr Stages kVenus = stages_of(6.2, 0.6, 1.4, 7.7);

constexpr Published one(std::string_view method, std::string_view paper, std::string_view place,
                        int year, std::string_view hardware, std::string_view scene,
                        std::size_t triangles, int width, int height, double frames_per_second,
                        std::string_view ours = "", std::span<const PublishedStage> stages = {}) {
  return {method, paper, place, year, hardware, scene, triangles, width, height, frames_per_second,
          ours,   stages};
}
constexpr Published wedge_2002(std::string_view place, std::string_view scene,
                               double frames_per_second) {
  return one("wedge-2002", kPaper1, place, 2002, kAthlon, scene, 0, 512, 512, frames_per_second);
}
constexpr Published restructured(std::string_view place, std::string_view scene,
                                 double frames_per_second, std::string_view ours) {
  return one("wedge-restructured", kPaper2, place, 2003, kPentium, scene, 0, 640, 427,
             frames_per_second, ours);
}
constexpr Published ssv(std::string_view place, std::string_view scene, int edge,
                        double frames_per_second, std::string_view ours = "") {
  return one("ssv", kPaper3, place, 2003, kSoftware, scene, 0, edge, edge, frames_per_second, ours);
}
constexpr Published optimized(std::string_view place, std::string_view scene,
                              double frames_per_second, std::string_view ours = "") {
  return one("ssv-optimized", kPaper4, place, 2003, kRadeon, scene, 0, 0, 0, frames_per_second,
             ours);
}
constexpr Published d_buffer(std::string_view scene, std::size_t triangles, int edge,
                             double frames_per_second) {
  return one("d-buffer", kDBuffer, "table 1", 2004, kQuadro, scene, triangles, edge, edge,
             frames_per_second);
}
constexpr Published occlusion(std::string_view scene, std::size_t triangles, int edge,
                              double frames_per_second, std::string_view ours = "",
                              std::span<const PublishedStage> stages = {}) {
  return one("occlusion-camera", kOcclusion, "table 1", 2007, kGeForce8, scene, triangles, edge,
             edge, frames_per_second, ours, stages);
}

constexpr std::array kPublished{
    wedge_2002("section 7, figure 12", "A logo over teapots", 1.8),
    wedge_2002("section 7, figure 13", "A simple caster", 2.0),
    restructured("figure 9", "Columns", 7.0, "columns"),
    restructured("section 7", "Columns, without zmin", 2.6, "columns"),
    restructured("figure 10", "Fractal landscape of 100,000 triangles", 1.75, "fractal"),
    restructured("figure 11", "The text 2002 over teapots", 3.6, "text2002"),
    restructured("figure 1", "Venus, a sphere and a floor", 1.0, ""),
    ssv("figure 6", "A cylinder", 512, 5.0, "cylinder"),
    ssv("section 5.2", "A fairy, large light", 100, 3.0),
    ssv("section 5.2", "A fairy, large light", 256, 0.51),
    ssv("section 5.2", "A fairy, large light", 512, 0.14),
    ssv("section 5.2", "Sixteen lights as one texture", 256, 0.8),
    ssv("section 5.2", "Sixteen lights as one texture", 512, 0.4),
    optimized("section 7", "A cylinder, up to", 150.0, "cylinder"),
    optimized("abstract", "More complex casters, normally", 50.0),
    d_buffer("Varying distance", 224, 300, 212.0),
    d_buffer("Varying distance", 224, 600, 120.0),
    d_buffer("Varying distance", 224, 1000, 61.0),
    d_buffer("Varying light", 960, 300, 107.0),
    d_buffer("Varying light", 960, 600, 75.0),
    d_buffer("Varying light", 960, 1000, 45.0),
    d_buffer("Complex caster", 5760, 300, 14.2),
    d_buffer("Complex caster", 5760, 600, 13.0),
    d_buffer("Complex caster", 5760, 1000, 12.1),
    d_buffer("Complex caster, simplified", 1440, 300, 28.4),
    d_buffer("Complex caster, simplified", 1440, 600, 21.3),
    d_buffer("Complex caster, simplified", 1440, 1000, 16.9),
    occlusion("F-16", 4500, 512, 180.2, "", kF16),
    occlusion("F-16", 4500, 1024, 58.6),
    occlusion("Two teapots", 13000, 512, 186.6, "", kTeapots),
    occlusion("Two teapots", 13000, 1024, 76.5),
    occlusion("Cow and sphere", 26000, 512, 135.1, "", kCow),
    occlusion("Cow and sphere", 26000, 1024, 68.9),
    occlusion("Venus and sphere", 64000, 512, 84.7, "", kVenus),
    occlusion("Venus and sphere", 64000, 1024, 39.6),
    occlusion("Bunny", 70000, 512, 85.4, "bunny", kBunny),
    occlusion("Bunny", 70000, 1024, 41.6, "bunny"),
    occlusion("Dragon and sphere", 270000, 512, 29.6, "", kDragon),
    occlusion("Dragon and sphere", 270000, 1024, 24.5),
    // About 5,000 vertices: a closed mesh has twice as many triangles.
    one("silhouette-rings", kRings, "section 4", 0, "PC of 1 GHz", "A mesh, three samples", 10000,
        0, 0, 10.0),
};

}  // namespace

std::span<const Published> published() { return kPublished; }

}  // namespace wedgesim::reports::accuracy

// What the D-buffer gets right beside other methods, and what its paper says it gets wrong.
#include "functional/methods/d_buffer.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/error.h"
#include "functional/geometry/light_disk.h"
#include "functional/scene/primitives.h"
#include "tests/functional/methods/instruction_sets.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 160;

Object object_at(Mesh mesh, const glm::dvec3& at, bool casts) {
  for (glm::dvec3& p : mesh.positions) p += at;
  Object object;
  object.mesh = std::move(mesh);
  object.casts = casts;
  return object;
}

// A floor at y = 0 seen from below, so that nothing hides it, under a light at height 10.
Scene floor_scene(double floor, double half_light) {
  Scene scene;
  scene.width = scene.height = kSize;
  scene.camera.eye = glm::dvec3(0.01, -40.0, 0.02);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  scene.camera.field_of_view_degrees = 2.0 * std::atan(0.5 * floor / 40.0) * 180.0 / M_PI;
  scene.camera.near_plane = 10.0;
  scene.light.centre = {0.0, 10.0, 0.0};
  scene.light.half_u = {half_light, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, half_light};
  scene.objects.push_back(object_at(make_plane({floor, floor}, {1, 1}), glm::dvec3(0.0), false));
  return scene;
}

struct Rendered {
  Window window;
  DepthBuffer depth;
  explicit Rendered(const Scene& scene)
      : window(make_window(scene.camera, scene.width, scene.height)),
        depth(render_depth(window, scene.objects, traces::fb::DepthFormat_float32)) {}
  std::vector<float> by(const Scene& scene, const std::string& choice) const {
    return visibility(scene, choice).values;
  }
  Visibility visibility(const Scene& scene, const std::string& choice) const {
    return render_method({scene, window, depth}, choose_method("--method", choice));
  }
};

double rmse(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double error =
        std::clamp(static_cast<double>(a[i]), 0.0, 1.0) - static_cast<double>(b[i]);
    sum += error * error;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double darkness(const std::vector<float>& values) {
  double sum = 0.0;
  for (const float v : values) sum += 1.0 - std::clamp(static_cast<double>(v), 0.0, 1.0);
  return sum;
}

// Pixels that are called black although much light reaches them.
int falsely_black(const std::vector<float>& values, const std::vector<float>& truth) {
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    count += values[i] < 0.002F && truth[i] > 0.05F ? 1 : 0;
  }
  return count;
}

// The paper's figures 1 and 7: under a large light a block and a board of the same outline, as the
// light's centre sees them, cast different shadows. A silhouette from the centre gives both the
// same; the D-buffer's umbra is right for both.
TEST(DBuffer, OneSilhouetteIsNotEnoughUnderALargeLight) {
  const auto scene_of = [](double thickness) {
    Scene scene = floor_scene(10.0, 2.5);
    scene.objects.push_back(
        object_at(make_box({2.5, thickness, 2.5}), {0.0, 4.5 - thickness, 0.0}, true));
    return scene;
  };
  const Scene board = scene_of(0.02);
  const Scene block = scene_of(2.5);
  const Rendered of_board(board);
  const Rendered of_block(block);
  const std::vector<float> board_truth = of_board.by(board, "raytraced-256");
  const std::vector<float> block_truth = of_block.by(block, "raytraced-256");
  const auto black = [](const std::vector<float>& values) {
    return static_cast<double>(std::ranges::count_if(values, [](float v) { return v < 0.002F; }));
  };
  const double true_black = black(block_truth);
  const double coverage_black = black(of_block.by(block, "coverage"));
  const double d_buffer_black = black(of_block.by(block, "d-buffer"));
  std::cout << "black pixels under the block: truth " << true_black << ", coverage "
            << coverage_black << ", d-buffer " << d_buffer_black << "; under the board: truth "
            << black(board_truth) << '\n';
  EXPECT_GT(true_black, 5.0 * black(board_truth));
  EXPECT_EQ(rmse(of_board.by(board, "coverage"), of_block.by(block, "coverage")), 0.0);
  EXPECT_LT(coverage_black, 0.2 * true_black);
  EXPECT_NEAR(d_buffer_black, true_black, 0.2 * true_black);
}

// Artifact too-dark-small-occluder: what is smaller than the light has no umbra, light passes on
// both sides, and one edge alone says too little of it; √t makes it lighter.
TEST(DBuffer, SmallOccludersCastTooDarkShadows) {
  Scene scene = floor_scene(8.0, 1.5);
  scene.objects.push_back(object_at(make_box({0.5, 0.5, 0.5}), {0.0, 3.0, 0.0}, true));
  const Rendered rendered(scene);
  const std::vector<float> truth = rendered.by(scene, "raytraced-256");
  const double smooth = darkness(rendered.by(scene, "d-buffer")) / darkness(truth);
  const double root = darkness(rendered.by(scene, "d-buffer:falloff=sqrt")) / darkness(truth);
  std::cout << "darkness of a small occluder's shadow over the truth: smooth " << smooth
            << ", sqrt " << root << '\n';
  EXPECT_GT(smooth, 1.5);
  EXPECT_LT(std::abs(root - 1.0), std::abs(smooth - 1.0));

  // A large occluder's is right.
  Scene large = floor_scene(16.0, 0.5);
  large.objects.push_back(object_at(make_box({5.0, 0.5, 5.0}), {0.0, 3.0, 0.0}, true));
  const Rendered of_large(large);
  const double right =
      darkness(of_large.by(large, "d-buffer")) / darkness(of_large.by(large, "raytraced-256"));
  std::cout << "of a large one: smooth " << right << '\n';
  EXPECT_NEAR(right, 1.0, 0.02);
}

// Artifact concave-occluder: behind two boards one above the other a texel keeps the lower one's
// umbra alone, so all on the lower board behind the upper one is black.
TEST(DBuffer, OverlappingOccludersLoseThePenumbraBetweenThem) {
  Scene scene = floor_scene(12.0, 1.0);
  scene.camera.eye = {6.0, 14.0, 8.0};
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.field_of_view_degrees = 40.0;
  scene.camera.near_plane = 1.0;
  const Object upper = object_at(make_box({2.0, 0.1, 2.0}), {-1.4, 4.5, 0.0}, true);
  const Object lower = object_at(make_box({4.0, 0.1, 4.0}), {0.0, 2.0, 0.0}, true);
  scene.objects.push_back(upper);
  scene.objects.push_back(lower);
  Scene alone = scene;  // the lower board receives only: a texel need not choose
  alone.objects[2].casts = false;
  const auto black = [](const Scene& of) {
    const Rendered rendered(of);
    std::vector<float> truth = rendered.by(of, "raytraced-256");
    // Of the lower board alone.
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const bool there = rendered.depth.triangle[i] != DepthBuffer::kSky;
      if (!there || rendered.depth.surface(i).object != 2) truth[i] = 0.0F;
    }
    return falsely_black(rendered.by(of, "d-buffer"), truth);
  };
  const int overlapping = black(scene);
  const int separate = black(alone);
  std::cout << "falsely black pixels: " << overlapping << " where both cast, " << separate
            << " where only the upper board does\n";
  EXPECT_GT(overlapping, 100);
  EXPECT_LT(separate, overlapping / 20);
}

// Artifact acute-corner: near an acute corner two edges cut the light, one alone is known.
TEST(DBuffer, AcuteCornersAreOffMoreThanStraightEdges) {
  const auto error_of = [](double half_angle_degrees) {
    const double length = 6.0;
    const double half = length * std::tan(half_angle_degrees * M_PI / 180.0);
    // The corner is over the middle of the floor.
    Mesh blade =
        make_thin_polygon({{0.0, 0.0}, {length, half}, {length + 0.1, 0.0}, {length, -half}});
    Scene scene = floor_scene(3.0, 0.5);
    scene.objects.push_back(object_at(std::move(blade), {0.0, 5.0, 0.0}, true));
    const Rendered rendered(scene);
    return rmse(rendered.by(scene, "d-buffer:falloff=exact"), rendered.by(scene, "raytraced-256"));
  };
  const double acute = error_of(12.0);
  const double blunt = error_of(80.0);
  std::cout << "RMSE round a corner of 24 degrees " << acute << ", of 160 degrees " << blunt
            << '\n';
  EXPECT_GT(acute, 3.0 * blunt);
}

// Artifact map-resolution: what is wrong falls with the size of a texel.
TEST(DBuffer, ErrorsFallWithTheResolutionOfTheMap) {
  Scene scene = floor_scene(9.0, 0.15);
  scene.objects.push_back(object_at(make_box({3.0, 0.5, 2.0}), {0.2, 3.0, 0.1}, true));
  const Rendered rendered(scene);
  const std::vector<float> truth = rendered.by(scene, "raytraced-256");
  double last = 1.0;
  for (const char* choice :
       {"d-buffer:resolution=128", "d-buffer:resolution=256", "d-buffer:resolution=512"}) {
    const double error = rmse(rendered.by(scene, choice), truth);
    std::cout << choice << ": RMSE " << error << '\n';
    EXPECT_LT(error, 0.85 * last);
    last = error;
  }
  EXPECT_LT(rmse(rendered.by(scene, "d-buffer:resolution=128,lookup=bilinear"), truth),
            rmse(rendered.by(scene, "d-buffer:resolution=128"), truth));
}

// Under a straight edge the parameter t is exact: with the disk's own area so is the visibility.
// As printed, Eq. 3 is not.
TEST(DBuffer, VisibilityOfAStraightEdge) {
  Scene scene = floor_scene(3.0, 1.0);
  scene.light.shape = LightShape::sphere;
  scene.light.radius = 1.0;
  scene.objects.push_back(object_at(make_box({12.0, 0.1, 12.0}), {6.0, 5.0, 0.0}, true));
  const Rendered rendered(scene);
  // The disk is across the way to the board's middle.
  const LightDisk disk = disk_of(scene.light, {6.0, 5.05, 0.0});
  std::vector<float> truth;
  for (std::size_t i = 0; i < rendered.depth.words.size(); ++i) {
    const glm::dvec3 x = world_point(
        rendered.window, static_cast<double>(i % kSize) + 0.5, static_cast<double>(i / kSize) + 0.5,
        traces::decode_depth(rendered.depth.format, rendered.depth.words[i]));
    // Points of the disk on the open side of the edge's plane through x; the edge is the lower or
    // the upper one of the board's side.
    int open = 0;
    constexpr int kRings = 20;
    constexpr int kSpokes = 32;
    for (int k = 0; k < kRings * kSpokes; ++k) {
      const double ring = std::sqrt((k / kSpokes + 0.5) / kRings);
      const glm::dvec3 p =
          disk.centre + ring * (disk.rim(2.0 * M_PI * (k % kSpokes) / kSpokes) - disk.centre);
      const auto blocked = [&](double height) {
        const double share = height / p.y;
        return x.x + share * (p.x - x.x) > 0.0;
      };
      open += blocked(5.0) || blocked(5.1) ? 0 : 1;
    }
    truth.push_back(static_cast<float>(open) / (kRings * kSpokes));
  }
  const double exact = rmse(rendered.by(scene, "d-buffer:falloff=exact"), truth);
  const double smooth = rmse(rendered.by(scene, "d-buffer"), truth);
  const double printed =
      rmse(rendered.by(scene, "d-buffer:falloff=exact,parameter=printed"), truth);
  std::cout << "RMSE under a straight edge: exact " << exact << ", smooth " << smooth
            << ", as printed " << printed << '\n';
  EXPECT_LT(exact, 0.01);
  EXPECT_LT(smooth, 0.04);
  EXPECT_GT(printed, 5.0 * exact);
}

// Two faces in one place: the depth buffer names one, which may be the other one of what is seen.
// Seen from above the polygon is lit, from below it is not.
TEST(DBuffer, AThinCasterIsLitOnTheLightsSideAlone) {
  Scene scene = floor_scene(12.0, 1.0);
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.camera.field_of_view_degrees = 40.0;
  scene.camera.near_plane = 1.0;
  scene.objects.push_back(
      object_at(make_thin_polygon({{-2.0, -1.0}, {-2.3, 1.8}, {0.2, 2.2}, {2.1, -1.0}}),
                {0.0, 3.0, 0.0}, true));
  for (const double height : {9.0, 1.0}) {
    scene.camera.eye = {3.0, height, 4.0};
    scene.camera.target = {0.0, 3.0, 0.0};
    const Rendered rendered(scene);
    const auto on_polygon = [&](int x, int y) {
      const auto i = static_cast<std::size_t>(y * kSize + x);
      return rendered.depth.triangle[i] != DepthBuffer::kSky &&
             rendered.depth.surface(i).object == 1;
    };
    const std::vector<float> truth = rendered.by(scene, "raytraced-64");
    for (const char* choice : {"d-buffer", "d-buffer:resolution=256,lookup=bilinear"}) {
      const std::vector<float> values = rendered.by(scene, choice);
      int seen = 0;
      int wrong = 0;
      constexpr int kTexel = 2;  // pixels: as near to the outline the map has what is beside it
      for (int y = kTexel; y < kSize - kTexel; ++y) {
        for (int x = kTexel; x < kSize - kTexel; ++x) {
          if (!on_polygon(x - kTexel, y) || !on_polygon(x + kTexel, y) ||
              !on_polygon(x, y - kTexel) || !on_polygon(x, y + kTexel)) {
            continue;
          }
          const auto i = static_cast<std::size_t>(y * kSize + x);
          ++seen;
          wrong += std::abs(values[i] - truth[i]) > 0.01F ? 1 : 0;
        }
      }
      EXPECT_GT(seen, 1000) << height;
      EXPECT_EQ(wrong, 0) << height << ' ' << choice;
    }
  }
}

TEST(DBuffer, RefusesWhatItsPaperDoesNotTreat) {
  Scene scene = floor_scene(8.0, 1.0);
  scene.objects.push_back(object_at(make_box({1.0, 1.0, 1.0}), {0.0, 9.5, 0.0}, true));
  const Rendered rendered(scene);
  EXPECT_THROW(rendered.by(scene, "d-buffer"), InputError);  // reaches the light's plane
  scene.objects.pop_back();
  EXPECT_EQ(darkness(rendered.by(scene, "d-buffer")), 0.0);  // nothing casts
  scene.light.shape = LightShape::point;
  EXPECT_THROW(rendered.by(scene, "d-buffer"), InputError);
}

TEST(DBuffer, SameWhateverTheThreadsAndCountsItsAccesses) {
  Scene scene = floor_scene(8.0, 1.0);
  for (int i = 0; i < 4; ++i) {
    scene.objects.push_back(
        object_at(make_sphere(0.6, 16, 12), {1.1 * i - 1.5, 2.0 + 0.3 * i, 0.2 * i}, true));
  }
  const Rendered rendered(scene);
  const Visibility nearest = rendered.visibility(scene, "d-buffer");
  const Visibility bilinear = rendered.visibility(scene, "d-buffer:lookup=bilinear");
  const std::size_t pixels = nearest.values.size();
  EXPECT_EQ(nearest.accesses.z_reads, pixels);
  EXPECT_EQ(nearest.accesses.li_writes, pixels);
  EXPECT_GT(nearest.accesses.map_writes, 0U);
  // A lookup is 16 bytes, all else 4.
  const auto lookups = [](const MethodAccesses& a) {
    return (a.bytes - 4 * (a.z_reads + a.li_writes + a.map_reads + a.map_writes)) / 12;
  };
  EXPECT_LE(lookups(nearest.accesses), pixels);
  EXPECT_GT(lookups(nearest.accesses), pixels / 10);
  EXPECT_EQ(lookups(bilinear.accesses), 4 * lookups(nearest.accesses));
  EXPECT_EQ(bilinear.accesses.map_reads - nearest.accesses.map_reads,
            3 * lookups(nearest.accesses));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(rendered.by(scene, "d-buffer"), nearest.values);
}

TEST(DBuffer, DoesNotDependOnTheInstructionSet) {
  Scene scene = floor_scene(8.0, 1.0);
  for (int i = 0; i < 3; ++i) {
    scene.objects.push_back(
        object_at(make_sphere(0.6, 16, 12), {1.1 * i - 1.5, 2.0 + 0.3 * i, 0.2 * i}, true));
  }
  const Rendered rendered(scene);
  for (const char* choice :
       {"d-buffer:resolution=301", "d-buffer:resolution=128,lookup=bilinear,channels=5",
        "d-buffer:resolution=128,distances=interpolated,crossing=nearest"}) {
    const std::vector<float> widest = rendered.by(scene, choice);
    for_each_instruction_set([&](const char* name) {
      EXPECT_EQ(rendered.by(scene, choice), widest) << choice << ", " << name;
    });
  }
}

}  // namespace
}  // namespace wedgesim::functional

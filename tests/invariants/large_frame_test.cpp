// Does a frame of 8192 x 8192 pixels with 100,000 wedges stay within 4 GB, made and counted?
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <iostream>

#include "functional/methods/frame.h"
#include "model/count/count.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim {
namespace {

constexpr double kMostGigabytes = 4.0;

// A grid of small boxes over a floor: six silhouette edges each.
functional::Scene many_boxes(int side) {
  functional::Scene scene;
  scene.name = "many-boxes";
  scene.width = 8192;
  scene.height = 8192;
  functional::Mesh floor;
  floor.name = "floor";
  floor.positions = {{-60, 0, -60}, {60, 0, -60}, {60, 0, 60}, {-60, 0, 60}};
  floor.triangles = {{0, 2, 1}, {0, 3, 2}};
  functional::Mesh boxes;
  boxes.name = "boxes";
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const glm::dvec3 low(80.0 * i / side - 40.0, 1.0, 80.0 * j / side - 40.0);
      const auto first = static_cast<std::uint32_t>(boxes.positions.size());
      for (int k = 0; k < 8; ++k) {
        boxes.positions.push_back(low + 0.2 * glm::dvec3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
      }
      for (const std::array<std::uint32_t, 3>& t : {std::array<std::uint32_t, 3>{0, 2, 1},
                                                    {1, 2, 3},
                                                    {4, 5, 6},
                                                    {5, 7, 6},
                                                    {0, 1, 4},
                                                    {1, 5, 4},
                                                    {2, 6, 3},
                                                    {3, 6, 7},
                                                    {0, 4, 2},
                                                    {2, 4, 6},
                                                    {1, 3, 5},
                                                    {3, 7, 5}}) {
        boxes.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
    }
  }
  scene.objects = {{std::move(floor), false, {}}, {std::move(boxes), true, {}}};
  scene.light.centre = {43.1, 60.0, 47.3};
  scene.light.half_u = {0.5, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.5};
  scene.camera.eye = {0.0, 90.0, 70.0};
  scene.camera.near_plane = 1.0;
  scene.camera.far_plane = 400.0;
  scene.camera.field_of_view_degrees = 50.0;
  return scene;
}

// Runs a step in a process of its own; its peak memory in gigabytes, or -1 if it failed.
double peak_of(const std::function<bool()>& step) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      _exit(step() ? 0 : 1);
    } catch (const std::exception& e) {
      std::cerr << e.what() << std::endl;
      _exit(1);
    }
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) return -1.0;
  return static_cast<double>(usage.ru_maxrss) / (1024.0 * 1024.0);
}

TEST(LargeFrame, StaysWithinFourGigabytes) {
  const auto path = std::filesystem::temp_directory_path() / "wedgesim-large.wtrace";
  const double made = peak_of([&] {
    const functional::Frame frame = functional::make_frame(many_boxes(135));
    std::cout << frame.trace.wedges.size() << " wedges" << std::endl;
    traces::write_trace(path, frame.trace);
    return frame.trace.wedges.size() >= 100000;
  });
  const double counted = peak_of([&] {
    const traces::TraceFile file(path);
    const model::CountConfig config;
    const auto results = model::count(file.view(), std::span(&config, 1));
    return results.front().pixels.mismatched == 0 && results.front().wrong_contributions == 0;
  });
  std::filesystem::remove(path);
  std::cout << "peak " << made << " GB made, " << counted << " GB counted\n";
  EXPECT_GT(made, 0.0);
  EXPECT_LT(made, kMostGigabytes);
  EXPECT_GT(counted, 0.0);
  EXPECT_LT(counted, kMostGigabytes);
}

}  // namespace
}  // namespace wedgesim

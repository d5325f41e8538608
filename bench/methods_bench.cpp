// Run time and error of shadow methods: methods_bench [-r RAYS] SCENE METHOD…
// For each method the medians of several runs, of time in all and by stage and of processor time,
// on one thread and on all, and the RMSE on receivers against rays; then how many times the
// processor time on one thread rays take at its own RMSE, that is the least number of rays that are
// as close. Processor time holds even on a machine that does something else too.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "functional/methods/method.h"
#include "functional/reference/reference.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::bench {
namespace {

using namespace functional;  // NOLINT: the vocabulary of the methods

constexpr int kRounds = 9;

struct Measured {
  Visibility visibility;
  double milliseconds = 0.0;   // median
  double processor = 0.0;      // median, milliseconds
  std::vector<double> stages;  // medians
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

Measured measure(const MethodInput& input, const MethodChoice& choice, int threads, int rounds) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  Measured measured;
  std::vector<double> times;
  std::vector<double> processor;
  std::vector<std::vector<double>> stages;
  for (int i = 0; i < rounds; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t processor_begin = std::clock();
    measured.visibility = render_method(input, choice);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
    times.push_back(time.count());
    processor.push_back(1e3 * static_cast<double>(std::clock() - processor_begin) / CLOCKS_PER_SEC);
    stages.resize(measured.visibility.stages.size());
    for (std::size_t s = 0; s < stages.size(); ++s) {
      stages[s].push_back(1e3 * measured.visibility.stages[s].seconds);
    }
  }
  measured.milliseconds = median(times);
  measured.processor = median(processor);
  for (const auto& stage : stages) measured.stages.push_back(median(stage));
  return measured;
}

double receiver_rmse(const MethodInput& input, const std::vector<float>& values,
                     const std::vector<float>& reference) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t pixel = 0; pixel < reference.size(); ++pixel) {
    if (input.depth.triangle[pixel] == DepthBuffer::kSky) continue;
    if (input.scene.objects[input.depth.surface(pixel).object].casts) continue;
    const double error = static_cast<double>(std::clamp(values[pixel], 0.0F, 1.0F)) -
                         static_cast<double>(reference[pixel]);
    sum += error * error;
    ++count;
  }
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
}

// Rays of the least square number whose RMSE is not above.
void compare_with_rays(const MethodInput& input, const std::vector<float>& reference, double rmse,
                       double processor) {
  for (int side = 1; side <= 32; ++side) {
    const MethodChoice rays =
        choose_method("methods_bench", fmt::format("raytraced-{}", side * side));
    Measured traced = measure(input, rays, 1, 1);
    const double error = receiver_rmse(input, traced.visibility.values, reference);
    if (error > rmse && side < 32) continue;
    fmt::print("    {} rays: RMSE {:.5f}, processor {:.0f} ms: {:.0f} times as long\n", side * side,
               error, traced.processor, traced.processor / processor);
    return;
  }
}

void run(const std::string& name, int rays, const std::vector<std::string>& methods) {
  const Scene scene = load_scene(name, {});
  const Window window = make_window(scene.camera, scene.width, scene.height);
  const DepthBuffer depth = render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  const MethodInput input{scene, window, depth};
  const std::vector<float> reference =
      rays > 0 ? reference_visibility(scene, window, depth, rays, 7) : std::vector<float>();
  const int all = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  for (const std::string& text : methods) {
    const MethodChoice choice = choose_method("methods_bench", text);
    double rmse = 0.0;
    double processor = 0.0;
    for (const int threads : {1, all}) {
      const Measured m = measure(input, choice, threads, kRounds);
      if (threads == 1) processor = m.processor;
      fmt::print("{} {}, {} thread{}: {:.2f} ms, processor {:.2f}", name, text, threads,
                 threads == 1 ? "" : "s", m.milliseconds, m.processor);
      for (std::size_t s = 0; s < m.stages.size(); ++s) {
        fmt::print(", {} {:.2f}", m.visibility.stages[s].name, m.stages[s]);
      }
      const MethodAccesses& accesses = m.visibility.accesses;
      fmt::print("; z reads {}, li writes {}", accesses.z_reads, accesses.li_writes);
      if (rays > 0) {
        rmse = receiver_rmse(input, m.visibility.values, reference);
        fmt::print("; RMSE {:.5f}", rmse);
      }
      fmt::print("\n");
    }
    if (rays > 0) compare_with_rays(input, reference, rmse, processor);
  }
}

}  // namespace
}  // namespace wedgesim::bench

int main(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  int rays = 0;
  if (arguments.size() > 2 && arguments[0] == "-r") {
    rays = std::atoi(arguments[1].c_str());
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  if (arguments.size() < 2) {
    fmt::print(stderr, "methods_bench [-r RAYS] SCENE METHOD...\n");
    return 2;
  }
  wedgesim::bench::run(arguments[0], rays, {arguments.begin() + 1, arguments.end()});
  return 0;
}

// Pixel visits per second of one thread: the plain loop, every kernel that this processor runs, and
// count() as a whole, tile tests and counters included. All run in turn, again and again, and the
// median of each one's processor time counts, so that what else the machine does hits all alike.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "bench/plain_loop.h"
#include "model/count/count.h"
#include "model/count/footprint.h"
#include "model/count/light_image.h"

namespace wedgesim::bench {
namespace {

using namespace model;  // NOLINT: the vocabulary of the counter

constexpr int kRounds = 15;

// The counter's own path, by one kernel.
void draw_by_kernel(const Scene& scene, const ZFrame& frame, const Kernel& kernel,
                    LightImage& image) {
  Footprint footprint;
  for (const Primitive& wedge : scene.wedges) {
    for (int band = 0; band * kBandRows < frame.height(); ++band) {
      footprint.build(wedge, frame, band, kernel);
      image.add(wedge, footprint, frame, kernel, word_one(DatapathKind::exact));
    }
  }
}

// Ends the program if a kernel's words are not the plain loop's.
void check(const Scene& scene, const ZFrame& frame, const Image& plain, const Kernel& kernel) {
  LightImage image(frame);
  draw_by_kernel(scene, frame, kernel, image);
  frame.for_each_block([&](std::uint32_t bx, std::uint32_t by) {
    std::array<std::int64_t, kBlockPixels> penumbra;
    std::array<std::int32_t, kBlockPixels> umbra;
    std::array<std::uint32_t, kBlockPixels> contributions;
    image.sums(frame.block(bx, by), penumbra.data(), umbra.data(), contributions.data());
    for (int bit = 0; bit < kBlockPixels; ++bit) {
      const int x = static_cast<int>(bx) * kBlock + bit % kBlock;
      const int y = static_cast<int>(by) * kBlock + bit / kBlock;
      if (x >= frame.width() || y >= frame.height()) continue;
      const auto pixel = static_cast<std::size_t>(y * frame.width() + x);
      const auto i = static_cast<std::size_t>(bit);
      if (penumbra[i] != plain.penumbra[pixel] || umbra[i] != plain.umbra[pixel]) {
        fmt::print(stderr, "{} differs from the plain loop at {},{}\n", kernel.name, x, y);
        std::exit(1);
      }
    }
  });
}

struct Contestant {
  std::string name;
  std::function<void()> run;
  std::vector<double> seconds;

  double median() const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void race(std::vector<Contestant>& contestants) {
  for (int round = -1; round < kRounds; ++round) {  // the first warms up
    for (Contestant& contestant : contestants) {
      const double start = processor_seconds();
      contestant.run();
      if (round >= 0) contestant.seconds.push_back(processor_seconds() - start);
    }
  }
}

void compare(const std::string& title, const Scene& scene) {
  const ZFrame frame(scene.trace.view());
  Image plain(scene.z.size());
  const std::uint64_t visits = draw_plainly(scene, plain);
  std::vector<Contestant> contestants{{"plain", [&] { draw_plainly(scene, plain); }, {}}};
  LightImage image(frame);
  const auto by_kernel = [&](const Kernel& kernel) {
    check(scene, frame, plain, kernel);
    contestants.push_back({kernel.name, [&] { draw_by_kernel(scene, frame, kernel, image); }, {}});
  };
  by_kernel(scalar_kernel());
  for (const Kernel& kernel : simd_kernels()) by_kernel(kernel);
  const CountConfig config{.z = ZChoice::pass};
  const auto whole = [&](KernelChoice choice) {
    count(scene.trace.view(), {&config, 1}, {.threads = 1, .datapath = {}, .kernel = choice});
  };
  contestants.push_back({"count(), scalar", [&] { whole(KernelChoice::scalar); }, {}});
  contestants.push_back({"count(), SIMD", [&] { whole(KernelChoice::simd); }, {}});
  race(contestants);
  fmt::print("{}, {:.1f} million visits\n", title, 1e-6 * static_cast<double>(visits));
  for (const Contestant& contestant : contestants) {
    fmt::print("  {:<16}{:8.0f} million visits/s{:8.2f} x plain\n", contestant.name,
               1e-6 * static_cast<double>(visits) / contestant.median(),
               contestants.front().median() / contestant.median());
  }
}

}  // namespace
}  // namespace wedgesim::bench

/// Arguments: words that a comparison's title must contain.
int main(int argc, char** argv) {
  using namespace wedgesim::bench;  // NOLINT: its own
  const std::pair<const char*, Light> lights[] = {
      {"linear", Light::linear}, {"rectangle", Light::rectangle}, {"sphere", Light::sphere}};
  const std::pair<const char*, Shape> shapes[] = {
      {"broad wedges", Shape::broad}, {"thin wedges", Shape::thin}, {"noisy depth", Shape::noisy}};
  for (const auto& [light_name, light] : lights) {
    for (const auto& [shape_name, shape] : shapes) {
      const std::string title = fmt::format("{}, {}", light_name, shape_name);
      const bool chosen = std::all_of(argv + 1, argv + argc, [&](const char* word) {
        return title.find(word) != std::string::npos;
      });
      if (chosen) compare(title, Scene(light, shape));
    }
  }
  return 0;
}

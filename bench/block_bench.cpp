// Simulated cycles per second of the timed block, values computed and values replayed, decoupled
// and clocked, beside the bars of docs/testing.md.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "model/block/block.h"

namespace wedgesim::bench {
namespace {

constexpr int kRounds = 9;

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double median_seconds(const std::function<void()>& run) {
  std::vector<double> seconds;
  for (int round = 0; round < kRounds; ++round) {
    const double start = processor_seconds();
    run();
    seconds.push_back(processor_seconds() - start);
  }
  std::nth_element(seconds.begin(), seconds.begin() + kRounds / 2, seconds.end());
  return seconds[kRounds / 2];
}

void bench(const std::string& scene, const std::string& config_name) {
  std::vector<std::string> notes;
  functional::FrameOptions options;
  options.expected_li = false;
  const traces::Trace trace =
      functional::make_frame(functional::load_scene(scene, {}, &notes), options).trace;
  const traces::TraceView view = trace.view();
  const model::BlockConfig config = model::read_block(config_name);
  model::RecordedFrame frame = model::record_frame(view, config);
  const double cycles = static_cast<double>(model::run_block(frame, config).cycles);
  const double values = median_seconds([&] { frame = model::record_frame(view, config); });
  const double replayed = median_seconds([&] { model::run_block(frame, config); });
  model::BlockOptions clocked_options;
  clocked_options.timing = model::units::Timing::clocked;
  const double clocked = median_seconds([&] { model::run_block(frame, config, clocked_options); });
  const auto rate = [cycles](double seconds) { return cycles / seconds / 1e6; };
  fmt::print(
      "{:14} {:14} {:9.0f} cycles  {:6.1f} with values  {:6.1f} replayed  {:6.1f} clocked  "
      "fast / clocked {:.1f}\n",
      scene, config_name, cycles, rate(values + replayed), rate(replayed), rate(clocked),
      clocked / replayed);
}

}  // namespace
}  // namespace wedgesim::bench

int main() {
  fmt::print(
      "million simulated cycles a second of processor time, median of {} rounds; "
      "bars: 10 with values, 50 replayed\n",
      wedgesim::bench::kRounds);
  for (const char* scene : {"plain-columns", "text2002", "bunny"}) {
    for (const char* config : {"paper2-single", "paper2-three", "small"}) {
      wedgesim::bench::bench(scene, config);
    }
  }
}

#include "tests/reports/accuracy/sample.h"

#include <algorithm>
#include <cmath>

#include "reports/accuracy/accuracy_page.h"

namespace wedgesim::reports::accuracy::tests {
namespace {

constexpr int kWidth = 60;
constexpr int kHeight = 40;
constexpr int kSkyRows = 8;

std::vector<functional::MethodChoice> some_choices(std::size_t count) {
  std::vector<functional::MethodChoice> choices;
  for (const functional::Method& method : functional::methods()) {
    if (method.compared.empty()) continue;
    choices.push_back(functional::choose_method("sample", method.compared.front()));
  }
  for (int samples = 1; choices.size() < count; ++samples) {
    choices.push_back(functional::choose_method("sample", "raytraced-" + std::to_string(samples)));
  }
  choices.resize(count);
  return choices;
}

functional::DepthBuffer depth_below_sky() {
  functional::DepthBuffer depth;
  depth.width = kWidth;
  depth.height = kHeight;
  depth.words.assign(kWidth * kHeight, 0);
  depth.triangle.assign(kWidth * kHeight, 0);
  std::fill_n(depth.triangle.begin(), kSkyRows * kWidth, functional::DepthBuffer::kSky);
  return depth;
}

std::vector<float> round_shadow() {
  std::vector<float> values;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double away = std::hypot(x - 0.5 * kWidth, y - 0.6 * kHeight);
      values.push_back(y < kSkyRows ? 1.0F
                                    : static_cast<float>(std::clamp((away - 6.0) / 8.0, 0.0, 1.0)));
    }
  }
  return values;
}

Measured made(const functional::MethodChoice& choice, std::size_t place,
              const std::vector<float>& reference) {
  Measured measured;
  measured.choice = choice;
  const double steps = static_cast<double>(place);
  const bool worse = place % 3 == 2;
  const double error = (worse ? 0.3 : 0.2) * std::pow(0.7, steps);
  Errors& errors = measured.errors[static_cast<std::size_t>(Region::receivers)];
  errors = {.values = 100, .rmse = error, .largest = 2.0 * error};
  measured.timing.all_threads = 1e-3 * std::pow(1.5, steps);
  measured.timing.one_thread = 2.0 * measured.timing.all_threads;
  measured.accesses.bytes = 1'000'000 * (place + 1);
  std::vector<float>& values = measured.visibility.emplace_back(reference);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] += static_cast<float>(i % kWidth < kWidth / 2 ? error : -error);
  }
  return measured;
}

SceneResult made_scene(const std::string& name,
                       const std::vector<functional::MethodChoice>& choices) {
  SceneResult result;
  result.scene.name = name;
  result.scene.description = "A <b>round</b> shadow";
  result.scene.width = kWidth;
  result.scene.height = kHeight;
  result.depth = depth_below_sky();
  result.triangles = 1234;
  result.reference = {round_shadow()};
  for (std::size_t i = 0; i < choices.size(); ++i) {
    result.methods.push_back(made(choices[i], i, result.reference[0]));
  }
  Measured& refused = result.methods.back();
  refused.refused = "<i>not</i> a plane";
  refused.visibility.clear();
  return result;
}

}  // namespace

std::vector<SceneResult> sample_scenes(std::size_t scenes, std::size_t choices) {
  static constexpr const char* kHostile = "a</script><script>window.broken = 1</script>";
  std::vector<SceneResult> results;
  for (std::size_t i = 0; i < scenes; ++i) {
    const std::string name = i < 2 ? "round shadow" : i == 2 ? kHostile : "s" + std::to_string(i);
    results.push_back(made_scene(name, some_choices(choices)));
  }
  return results;
}

void write_sample(const std::filesystem::path& folder, const std::vector<SceneResult>& scenes) {
  std::vector<Pictures> pictures;
  std::vector<SceneResult> so_far;
  for (const SceneResult& scene : scenes) {
    so_far.push_back(scene);
    pictures.push_back(write_pictures(folder, so_far));
  }
  const std::vector<std::string> methods{"hard"};
  const auto artifacts = write_artifacts(folder, show_artifacts(methods, 64));
  write_accuracy(folder, {{}, scenes, pictures, artifacts}, nullptr);
}

}  // namespace wedgesim::reports::accuracy::tests

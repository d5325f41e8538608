#include "reports/accuracy/measure.h"

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "functional/scene/lights.h"
#include "reports/accuracy/peak_memory.h"
#include "reports/accuracy/truth.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kLeastSeconds = 0.2;  // of runs whose median is taken

using functional::MethodChoice;
using functional::MethodInput;
using functional::Scene;
using functional::Visibility;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The scene as its lights are shadowed: one after the other.
std::vector<Scene> lit_by_each(const Scene& scene) {
  std::vector<Scene> lit;
  for (std::size_t i = 0; i < functional::light_count(scene); ++i) {
    lit.push_back(functional::with_light(scene, i));
  }
  return lit;
}

class SceneMeasurement {
 public:
  SceneMeasurement(const SceneResult& result, const std::vector<Scene>& lit,
                   const MeasureOptions& options)
      : result_(result), lit_(lit), options_(options) {
    for (std::size_t i = 0; i < lit.size(); ++i) {
      regions_.emplace_back(lit[i], result.depth, result.reference[i]);
    }
  }

  Measured measure(const MethodChoice& choice) const {
    Measured measured;
    measured.choice = choice;
    try {
      fill_values(measured);
    } catch (const functional::OptionError&) {
      throw;
    } catch (const InputError& error) {
      measured.refused = error.what();
      return measured;
    }
    fill_times(measured);
    return measured;
  }

 private:
  Visibility render(const MethodChoice& choice, std::size_t light) const {
    return functional::render_method({lit_[light], result_.window, result_.depth}, choice);
  }

  void fill_values(Measured& measured) const {
    const std::size_t pixels = result_.depth.words.size();
    std::array<ErrorSum, kRegions.size()> sums;
    for (std::size_t light = 0; light < lit_.size(); ++light) {
      Visibility visibility = render(measured.choice, light);
      for (const Region region : kRegions) {
        sums[static_cast<std::size_t>(region)].add(regions_[light], region, visibility.values,
                                                   result_.reference[light], pixels);
      }
      functional::MethodAccesses& all = measured.accesses;
      const functional::MethodAccesses& own = visibility.accesses;
      all.z_reads += own.z_reads;
      all.li_reads += own.li_reads;
      all.li_writes += own.li_writes;
      all.sums += own.sums;
      all.map_reads += own.map_reads;
      all.map_writes += own.map_writes;
      all.bytes += own.bytes;
      measured.visibility.push_back(std::move(visibility.values));
    }
    std::ranges::transform(sums, measured.errors.begin(), &ErrorSum::errors);
  }

  // Seconds of all lights, once; what each stage took is added to `stages`, by its name.
  double run(const MethodChoice& choice, std::vector<functional::Stage>& stages) const {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Visibility> results;
    for (std::size_t light = 0; light < lit_.size(); ++light) {
      results.push_back(render(choice, light));
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    for (const Visibility& result : results) {
      for (const functional::Stage& stage : result.stages) {
        const auto found = std::ranges::find(stages, stage.name, &functional::Stage::name);
        if (found == stages.end()) {
          stages.push_back(stage);
        } else {
          found->seconds += stage.seconds;
        }
      }
    }
    return seconds.count();
  }

  // Seconds of every run, `repetitions` at least; short ones are repeated for kLeastSeconds.
  std::vector<double> run_often(const MethodChoice& choice,
                                std::vector<std::vector<functional::Stage>>& stages) const {
    std::vector<double> seconds;
    double all = 0.0;
    const auto least = static_cast<std::size_t>(options_.repetitions);
    while (seconds.size() < least || (least > 1 && all < kLeastSeconds)) {
      all += seconds.emplace_back(run(choice, stages.emplace_back()));
    }
    return seconds;
  }

  void fill_times(Measured& measured) const {
    Timing& timing = measured.timing;
    {
      const PeakMemory memory;
      std::vector<functional::Stage> stages;
      run(measured.choice, stages);
      timing.peak_bytes = memory.bytes();
    }
    std::vector<std::vector<functional::Stage>> stages;
    {
      const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      timing.one_thread = median_of(run_often(measured.choice, stages));
    }
    stages.clear();
    timing.all_threads = median_of(run_often(measured.choice, stages));
    for (std::size_t k = 0; k < stages.front().size(); ++k) {
      std::vector<double> times;
      for (const auto& run : stages) times.push_back(run[k].seconds);
      timing.stages.push_back({stages.front()[k].name, median_of(times)});
    }
  }

  const SceneResult& result_;
  const std::vector<Scene>& lit_;
  const MeasureOptions& options_;
  std::vector<Regions> regions_;
};

// Finds wrong options before long work: by a frame of a few pixels.
void check_options(Scene scene, const std::vector<MethodChoice>& choices) {
  scene.width = 4;
  scene.height = 4;
  const functional::Window window = functional::make_window(scene.camera, 4, 4);
  const functional::DepthBuffer depth =
      functional::render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  for (const MethodChoice& choice : choices) {
    try {
      functional::render_method({scene, window, depth}, choice);
    } catch (const functional::OptionError&) {
      throw;
    } catch (const InputError&) {  // of this scene
    }
  }
}

std::vector<MethodChoice> default_choices() {
  std::vector<MethodChoice> choices;
  for (const functional::Method& method : functional::methods()) {
    for (const std::string_view text : method.compared) {
      choices.push_back(functional::choose_method("--method", text));
    }
  }
  return choices;
}

}  // namespace

SceneResult measure(Scene scene, const MeasureOptions& options,
                    const std::function<void(std::string_view choice)>& progress) {
  const auto tell = [&](std::string_view what) {
    if (progress) progress(what);
  };
  SceneResult result;
  result.scene = std::move(scene);
  result.window =
      functional::make_window(result.scene.camera, result.scene.width, result.scene.height);
  result.depth = functional::render_depth(result.window, result.scene.objects,
                                          traces::fb::DepthFormat_float32);
  for (const functional::Object& object : result.scene.objects) {
    if (object.casts) result.triangles += object.mesh.triangles.size();
  }
  const std::vector<MethodChoice> choices =
      options.choices.empty() ? default_choices() : options.choices;
  check_options(result.scene, options.choices);
  tell("reference");
  const std::vector<Scene> lit = lit_by_each(result.scene);
  const auto begin = std::chrono::steady_clock::now();
  for (const Scene& one : lit) {
    result.reference.push_back(
        reference_where_it_matters(one, result.window, result.depth, options.rays));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  result.reference_seconds = seconds.count();
  const SceneMeasurement measurement(result, lit, options);
  for (const MethodChoice& choice : options.choices.empty() ? default_choices() : options.choices) {
    tell(choice.text);
    result.methods.push_back(measurement.measure(choice));
  }
  return result;
}

}  // namespace wedgesim::reports::accuracy

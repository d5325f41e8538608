#include "reports/accuracy/artifacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "functional/raster/depth_buffer.h"
#include "functional/reference/reference.h"
#include "reports/accuracy/accuracy_picture.h"
#include "reports/accuracy/truth.h"

namespace wedgesim::reports::accuracy {
namespace {

using functional::DepthBuffer;

constexpr int kBend = 4;  // pixels

/// A frame of which a crop is looked at.
class Frame {
 public:
  Frame(const functional::Scene& scene, const Crop& crop, int rays)
      : scene_(scene),
        crop_(crop),
        window_(functional::make_window(scene.camera, scene.width, scene.height)),
        depth_(functional::render_depth(window_, scene.objects, traces::fb::DepthFormat_float32)) {
    std::vector<std::uint8_t> within(depth_.words.size());
    for (int y = 0; y < crop.height; ++y) {
      for (int x = 0; x < crop.width; ++x) within[index(x, y)] = 1;
    }
    reference_ = functional::reference_visibility(scene, window_, depth_, rays, kTruthSeed, within);
  }

  Panel reference() const { return cropped(visibility_panel(depth_, {reference_})); }

  CropPicture picture(const functional::MethodChoice& choice) const {
    const std::vector<float> values =
        functional::render_method({scene_, window_, depth_}, choice).values;
    return {cropped(visibility_panel(depth_, {values})),
            cropped(difference_panel(depth_, {values}, {reference_})), errors_of(values)};
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(crop_.y + y) * static_cast<std::size_t>(depth_.width) +
           static_cast<std::size_t>(crop_.x + x);
  }
  Panel cropped(const Panel& panel) const {
    Panel part;
    for (int y = 0; y < crop_.height; ++y) {
      for (int x = 0; x < crop_.width; ++x) part.push_back(panel[index(x, y)]);
    }
    return part;
  }
  bool is_seen(int x, int y) const { return depth_.triangle[index(x, y)] != DepthBuffer::kSky; }
  // Whether three pixels in a row or column are of one object.
  bool of_one(int x, int y, int dx, int dy) const {
    if (x - dx < 0 || y - dy < 0 || x + dx >= crop_.width || y + dy >= crop_.height) return false;
    if (!is_seen(x - dx, y - dy) || !is_seen(x, y) || !is_seen(x + dx, y + dy)) return false;
    const auto object = [&](int i, int j) { return depth_.surface(index(i, j)).object; };
    return object(x - dx, y - dy) == object(x, y) && object(x, y) == object(x + dx, y + dy);
  }

  CropErrors errors_of(const std::vector<float>& values) const {
    const std::size_t channels = values.size() / depth_.words.size();
    const std::vector<double> all = differences(depth_, {values}, {reference_});
    const auto shown = [&](const std::vector<float>& of, int x, int y) {
      return std::clamp(static_cast<double>(of[channels * index(x, y)]), 0.0, 1.0);
    };
    // Largest first difference of neighbours, second difference over kBend pixels.
    const auto step = [&](const std::vector<float>& of, int x, int y, int dx, int dy) {
      return std::fabs(shown(of, x + dx, y + dy) - shown(of, x, y));
    };
    const auto bend = [&](const std::vector<float>& of, int x, int y, int dx, int dy) {
      return std::fabs(shown(of, x - dx, y - dy) + shown(of, x + dx, y + dy) -
                       2.0 * shown(of, x, y));
    };
    CropErrors errors;
    double squares = 0.0;
    double pixels = 0.0;
    for (int y = 0; y < crop_.height; ++y) {
      for (int x = 0; x < crop_.width; ++x) {
        if (!is_seen(x, y)) continue;
        const double error = all[index(x, y)];
        errors.mean += error;
        squares += error * error;
        ++pixels;
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
          if (of_one(x, y, dx, dy)) {
            errors.step = std::max(errors.step, step(values, x, y, dx, dy));
            errors.reference_step = std::max(errors.reference_step, step(reference_, x, y, dx, dy));
          }
          if (of_one(x, y, kBend * dx, kBend * dy)) {
            errors.bend = std::max(errors.bend, bend(values, x, y, kBend * dx, kBend * dy));
            errors.reference_bend =
                std::max(errors.reference_bend, bend(reference_, x, y, kBend * dx, kBend * dy));
          }
        }
      }
    }
    errors.mean /= std::max(pixels, 1.0);
    errors.rmse = std::sqrt(squares / std::max(pixels, 1.0));
    return errors;
  }

  const functional::Scene& scene_;
  Crop crop_;
  functional::Window window_;
  DepthBuffer depth_;
  std::vector<float> reference_;
};

}  // namespace

bool Criterion::holds(const CropErrors& errors) const {
  switch (kind) {
    case Kind::too_dark:
      return errors.mean <= -bar;
    case Kind::too_light:
      return errors.mean >= bar;
    case Kind::wrong:
      return errors.rmse >= bar;
    case Kind::steps:
      return errors.step >= bar && errors.step >= 2.0 * errors.reference_step;
    case Kind::bends:
      return errors.bend >= bar && errors.bend >= 2.0 * errors.reference_bend;
  }
  return false;
}

std::string Criterion::text() const {
  switch (kind) {
    case Kind::too_dark:
      return fmt::format("mean error at most -{:g}", bar);
    case Kind::too_light:
      return fmt::format("mean error at least {:g}", bar);
    case Kind::wrong:
      return fmt::format("RMSE at least {:g}", bar);
    case Kind::steps:
      return fmt::format("largest step between neighbours at least {:g} and twice the reference's",
                         bar);
    case Kind::bends:
      return fmt::format(
          "largest second difference over {} pixels at least {:g} and twice the reference's", kBend,
          bar);
  }
  return {};
}

ShownArtifact show(const Artifact& artifact, int rays) {
  const functional::Scene scene = artifact.make();
  const Frame frame(scene, artifact.crop, rays);
  const functional::MethodChoice choice = functional::choose_method("artifact", artifact.choice);
  ShownArtifact shown{&artifact, choice.method, frame.reference(), frame.picture(choice), {}};
  if (!artifact.remedy.empty()) {
    shown.remedy = frame.picture(functional::choose_method("artifact", artifact.remedy));
  }
  return shown;
}

std::vector<ShownArtifact> show_artifacts(
    std::span<const std::string> methods, int rays,
    const std::function<void(std::string_view name)>& progress) {
  std::vector<ShownArtifact> all;
  for (const Artifact& artifact : artifacts()) {
    const auto choice = functional::choose_method("artifact", artifact.choice);
    if (std::ranges::find(methods, choice.method->name) == methods.end()) continue;
    if (progress) progress(artifact.name);
    all.push_back(show(artifact, rays));
  }
  return all;
}

Json artifacts_json(std::span<const ShownArtifact> shown) {
  Json all = Json::array();
  for (const ShownArtifact& one : shown) {
    const Artifact& artifact = *one.artifact;
    const Crop& crop = artifact.crop;
    Json json{{"name", artifact.name},
              {"method", one.method->name},
              {"choice", artifact.choice},
              {"scene", artifact.scene},
              {"crop", {crop.x, crop.y, crop.width, crop.height}},
              {"paper", artifact.paper},
              {"says", artifact.says},
              {"criterion", artifact.criterion.text()},
              {"mean_error_in_crop", one.wrong.errors.mean},
              {"rmse_in_crop", one.wrong.errors.rmse},
              {"shows", one.shows()},
              {"remedy", nullptr}};
    if (one.remedy) {
      json["remedy"] = {{"choice", artifact.remedy},
                        {"mean_error_in_crop", one.remedy->errors.mean},
                        {"rmse_in_crop", one.remedy->errors.rmse}};
    }
    all.push_back(std::move(json));
  }
  return all;
}

}  // namespace wedgesim::reports::accuracy

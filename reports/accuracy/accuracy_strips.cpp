#include "reports/accuracy/accuracy_strips.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "base/image.h"
#include "reports/accuracy/accuracy_picture.h"
#include "reports/page/html.h"
#include "reports/page/small_picture.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr int kSmallWidth = 240;  // of a picture in the page, pixels, at most

std::string plain(const std::string& text) {
  std::string name;
  for (const char c : text) {
    const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    name += kept ? c : '-';
  }
  return name;
}

Image in_row(const SceneResult& result, const std::vector<Panel>& panels) {
  Sheet sheet(result.depth.width, result.depth.height, static_cast<int>(panels.size()), 1, 1);
  for (const Panel& panel : panels) sheet.add(panel);
  return sheet.take();
}

SmallPicture small_row(const SceneResult& result, const std::vector<Panel>& panels,
                       const std::filesystem::path& scratch) {
  const Image image =
      page::reduced(in_row(result, panels), kSmallWidth * static_cast<int>(panels.size()));
  return {page::png_of(image, scratch), image.width, image.height};
}

}  // namespace

std::vector<std::string> labels_of(const std::vector<SceneResult>& scenes) {
  std::map<std::string, int> times;
  std::vector<std::string> labels;
  for (const SceneResult& result : scenes) {
    const std::string name = plain(result.scene.name);
    const int time = ++times[name];
    labels.push_back(name + (time > 1 ? fmt::format("-{}", time) : std::string()));
  }
  return labels;
}

Pictures write_pictures(const std::filesystem::path& folder,
                        const std::vector<SceneResult>& scenes) {
  const SceneResult& result = scenes.back();
  const std::string label = labels_of(scenes).back();
  const std::filesystem::path scratch = folder / "pictures" / "small.png";
  const Panel reference = visibility_panel(result.depth, result.reference);
  Pictures pictures{small_row(result, {reference}, scratch), {}};
  for (const Measured& measured : result.methods) {
    Strip& strip = pictures.strips.emplace_back();
    if (measured.refused) continue;
    const Panel own = visibility_panel(result.depth, measured.visibility);
    const Panel difference = difference_panel(result.depth, measured.visibility, result.reference);
    strip.file = fmt::format("pictures/{}_{}.png", label, plain(measured.choice.text));
    write_image(folder / strip.file, in_row(result, {own, reference, difference}));
    strip.small = small_row(result, {own, difference}, scratch);
  }
  return pictures;
}

std::string image_html(const SmallPicture& picture, const std::string& words) {
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
                     picture.width, picture.height, page::escape(words), page::base64(picture.png));
}

std::string scale_html() {
  static constexpr std::array kErrors{1.0 / 255.0, 4.0 / 255.0, 16.0 / 255.0, kFullColour};
  static constexpr std::array kNames{"1/255", "4/255", "16/255", ""};
  const auto swatch = [](double error, const std::string& name) {
    const Colour colour = difference_colour(error, saturation_of(error));
    std::string rgb;
    for (const float part : colour) {
      rgb += fmt::format("{}{}", rgb.empty() ? "" : " ", std::lround(255.0F * part));
    }
    return fmt::format("<span><i style=\"background: rgb({})\"></i>{}</span>", rgb, name);
  };
  std::string dark;
  std::string light;
  for (std::size_t i = 0; i < kErrors.size(); ++i) {
    const std::string name =
        kNames[i][0] == '\0' ? fmt::format("{:g} and more", kErrors[i]) : kNames[i];
    dark = swatch(-kErrors[i], name) + dark;
    light += swatch(kErrors[i], name);
  }
  return fmt::format(
      "<p class=\"swatches\">Too dark by {} too light by {} <span><i class=\"sky\"></i>sky</span>"
      "</p>\n",
      dark, light);
}

}  // namespace wedgesim::reports::accuracy

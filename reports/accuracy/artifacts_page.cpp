#include "reports/accuracy/artifacts_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/image.h"
#include "reports/accuracy/accuracy_charts.h"
#include "reports/page/html.h"
#include "reports/page/small_picture.h"

namespace wedgesim::reports::accuracy {
namespace {

using page::escape;

constexpr int kWidth = 200;  // of a panel that is shown, pixels, about

std::vector<Panel> panels_of(const ShownArtifact& shown) {
  std::vector<Panel> panels{shown.reference, shown.wrong.picture, shown.wrong.difference};
  if (shown.remedy) {
    panels.push_back(shown.remedy->picture);
    panels.push_back(shown.remedy->difference);
  }
  return panels;
}

// A pixel's edge at which a crop is visible.
int scale_of(const Crop& crop) { return std::max(1, kWidth / std::max(crop.width, crop.height)); }

SmallPicture small_panel(const Panel& panel, const Crop& crop,
                         const std::filesystem::path& scratch) {
  Sheet sheet(crop.width, crop.height, 1, 1, 1);
  sheet.add(panel);
  const int scale = scale_of(crop);
  return {page::png_of(sheet.take(), scratch), scale * crop.width, scale * crop.height};
}

std::string error_words(const CropErrors& errors) {
  return fmt::format("RMSE {}, mean {:+.4f}", error_text(errors.rmse), errors.mean);
}

std::string panel_html(const SmallPicture& picture, const std::string& name,
                       const std::string& words) {
  return fmt::format("<figure>\n{}\n<figcaption>{}{}</figcaption>\n</figure>\n",
                     image_html(picture, name + "."), page::element("strong", name),
                     words.empty() ? "" : "<br>" + escape(words));
}

std::string artifact_html(const ArtifactPictures& artifact) {
  const ShownArtifact& shown = artifact.shown;
  const Artifact& about = *shown.artifact;
  const std::vector<SmallPicture>& panels = artifact.panels;
  std::string html = fmt::format(
      "<article class=\"part\" id=\"artifact-{0}-{1}\" "
      "aria-labelledby=\"artifact-{0}-{1}-heading\">"
      "\n<h3 id=\"artifact-{0}-{1}-heading\">{0}: {1}</h3>\n",
      escape(shown.method->name), escape(about.name));
  html += fmt::format("<p>{} <span class=\"from\">({}.)</span> {}</p>\n", escape(about.says),
                      escape(about.paper), escape(about.look));
  html += "<div class=\"panels\">\n" + panel_html(panels[0], "reference", "") +
          panel_html(panels[1], std::string(about.choice), "") +
          panel_html(panels[2], "its difference", error_words(shown.wrong.errors));
  if (shown.remedy) {
    html += panel_html(panels[3], std::string(about.remedy), "") +
            panel_html(panels[4], "its difference", error_words(shown.remedy->errors));
  }
  return html + fmt::format(
                    "</div>\n<p class=\"about{}\">{}: {} in the crop. {}.</p>\n</article>\n",
                    shown.shows() ? "" : " notice", shown.shows() ? "It shows" : "It does not show",
                    escape(about.criterion.text()), escape(about.scene));
}

}  // namespace

std::vector<ArtifactPictures> write_artifacts(const std::filesystem::path& folder,
                                              std::vector<ShownArtifact> shown) {
  const std::filesystem::path scratch = folder / "pictures" / "small.png";
  std::vector<ArtifactPictures> all;
  for (ShownArtifact& one : shown) {
    const Crop& crop = one.artifact->crop;
    const std::vector<Panel> panels = panels_of(one);
    Sheet sheet(crop.width, crop.height, static_cast<int>(panels.size()), 1, scale_of(crop));
    ArtifactPictures pictures;
    for (const Panel& panel : panels) {
      sheet.add(panel);
      pictures.panels.push_back(small_panel(panel, crop, scratch));
    }
    write_image(folder / "pictures" /
                    fmt::format("artifact_{}_{}.png", one.method->name, one.artifact->name),
                sheet.take());
    pictures.shown = std::move(one);
    all.push_back(std::move(pictures));
  }
  return all;
}

std::string artifacts_html(std::span<const ArtifactPictures> artifacts) {
  if (artifacts.empty()) return "";
  const auto shows =
      std::ranges::count_if(artifacts, [](const auto& one) { return one.shown.shows(); });
  std::string html = fmt::format(
      "<section id=\"artifacts\" aria-labelledby=\"artifacts-heading\">\n"
      "<h2 id=\"artifacts-heading\">Artifacts</h2>\n"
      "<p>What the papers say their methods get wrong, each where it shows, beside ray tracing and "
      "a remedy: {} of {} show by their criterion.</p>\n",
      shows, artifacts.size());
  html += scale_html();
  for (const ArtifactPictures& artifact : artifacts) html += artifact_html(artifact);
  return html + "</section>\n";
}

}  // namespace wedgesim::reports::accuracy

#include "functional/methods/ssv.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "functional/light/coverage_texture.h"
#include "functional/light/split_word.h"
#include "functional/methods/ssv_kernel.h"
#include "functional/methods/texture_kernel.h"
#include "functional/methods/volume_pass.h"
#include "functional/scene/light_texture.h"

namespace wedgesim::functional {
namespace {

struct SsvOptions {
  int side = 0;  // of the coverage texture; 0: exact clipping
  TextureFilter filter = TextureFilter::nearest;
  CoverageWords words = CoverageWords::bits8;
  bool short_words = false;  // of the V-buffer
};

SsvOptions read_ssv_options(const MethodOptions& options) {
  SsvOptions read;
  read.side = options.choice<int>("texture", {{"none", 0},
                                              {"8", 8},
                                              {"12", 12},
                                              {"16", 16},
                                              {"24", 24},
                                              {"32", 32},
                                              {"48", 48},
                                              {"64", 64}});
  read.filter = options.choice<TextureFilter>(
      "filter", {{"nearest", TextureFilter::nearest}, {"quadlinear", TextureFilter::quadlinear}});
  read.words = options.choice<CoverageWords>(
      "words", {{"8bit", CoverageWords::bits8}, {"float", CoverageWords::float32}});
  if (read.side == 0) options.refuse_without_effect({"filter", "words"}, "texture=8…64 with it");
  read.short_words = options.choice<bool>("vbuffer", {{"float", false}, {"8bit", true}});
  return read;
}

void refuse_what_is_not_treated(const Scene& scene, const SsvOptions& options) {
  if (options.side > 0 && scene.light.shape != LightShape::rectangle) {
    throw InputError(scene.place, "a coverage texture is of a rectangular light", "texture=none");
  }
  if (options.short_words && scene.light.texture) {
    throw InputError(scene.place, "8-bit words hold no colours, and the light has a texture",
                     "vbuffer=float");
  }
}

DrawRow make_kernel(const Light& light, const SsvOptions& options) {
  if (light.shape == LightShape::point) return hard_kernel();
  if (options.side > 0) {
    const auto table = coverage_texture(light.texture, options.side, options.words);
    return options.short_words ? short_texture_kernel(table, options.filter)
                               : texture_kernel(table, options.filter);
  }
  if (options.short_words) return short_coverage_kernel(light.shape);
  if (light.texture) return emission_kernel(Emission(emission_shares(*light.texture)));
  return coverage_kernel(light.shape);
}

// (channel, height, width) to (height, width, channel).
std::vector<float> interleaved(const std::vector<float>& planes, std::size_t channels) {
  std::vector<float> values(planes.size());
  const std::size_t pixels = planes.size() / channels;
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < channels; ++c) values[i * channels + c] = planes[c * pixels + i];
  }
  return values;
}

// The V-buffer's sums of what is added and what is taken, each up to 255, and the umbra.
std::vector<float> merged(const std::vector<float>& planes) {
  std::vector<float> values(planes.size() / 3);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const float umbra = planes[2 * values.size() + i];
    const float added = std::min(255.0F, 64.0F * (planes[i] - 1.0F));
    const float taken = std::min(255.0F, 64.0F * (planes[values.size() + i] - 1.0F));
    values[i] = umbra + (added - taken) / ShortWord::kWhole;
  }
  return values;
}

Visibility render(const MethodInput& input, const MethodOptions& options) {
  const VolumeOptions volumes{
      .volumes = {.z = read_z(options)},
      .cull = options.choice<bool>("cull", {{"tiles", true}, {"none", false}})};
  const SsvOptions own = read_ssv_options(options);
  options.check_all_known();
  refuse_what_is_not_treated(input.scene, own);
  Visibility result;
  VolumePass pass(input, result);
  const Light& light = pass.scene().light;
  const DrawRow kernel = make_kernel(light, own);
  if (own.side > 0 || light.texture) pass.end("tables");
  MethodAccesses& accesses = result.accesses;
  const auto count_lookups = [&](int channels) {
    if (own.side == 0) return;
    accesses.map_reads = pass.shares() * (own.filter == TextureFilter::nearest ? 1 : 16);
    const std::uint64_t word_bytes = own.words == CoverageWords::bits8 ? 1 : sizeof(float);
    accesses.bytes += accesses.map_reads * word_bytes * static_cast<std::uint64_t>(channels);
  };
  if (own.short_words && light.shape != LightShape::point) {
    result.values = merged(pass.draw(light, volumes, kernel, 3));
    accesses.bytes = 4 * accesses.z_reads + accesses.li_reads + accesses.li_writes;
    count_lookups(1);
    return result;
  }
  result.channels = light.texture ? 3 : 1;
  const auto channels = static_cast<std::size_t>(result.channels);
  result.values = interleaved(pass.draw(light, volumes, kernel, result.channels), channels);
  accesses.bytes = 4 * (accesses.z_reads + accesses.li_reads + accesses.li_writes);
  count_lookups(result.channels);
  return result;
}

constexpr std::array<std::string_view, 4> kCompared{
    "ssv", "ssv:texture=32", "ssv:texture=32,filter=quadlinear", "ssv:texture=32,vbuffer=8bit"};
constexpr std::array<std::string_view, 4> kArtifacts{"single-silhouette", "object-overlap",
                                                     "texture-quantization", "v-buffer-overflow"};

}  // namespace

const Method kSsv{.name = "ssv",
                  .summary = "Soft shadow volumes: exact clipping or a 4-D coverage texture",
                  .source = "Paper III, 3 and 4",
                  .options =
                      "texture=none|8|12|16|24|32|48|64, filter=nearest|quadlinear, "
                      "words=8bit|float, vbuffer=float|8bit, z=auto|pass|fail, "
                      "cull=tiles|none",
                  .compared = kCompared,
                  .artifacts = kArtifacts,
                  .takes_textures = true,
                  .render = render};

}  // namespace wedgesim::functional

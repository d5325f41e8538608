#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "base/error.h"
#include "functional/methods/d_buffer.h"
#include "functional/methods/hard.h"
#include "functional/methods/method.h"
#include "functional/methods/occlusion_camera.h"
#include "functional/methods/raytraced.h"
#include "functional/methods/renderer.h"
#include "functional/methods/silhouette_rings.h"
#include "functional/methods/ssv.h"
#include "functional/methods/ssv_optimized.h"
#include "functional/methods/wedges_linear.h"

namespace wedgesim::functional {
namespace {

template <typename Condition>
std::string known_names(const Condition& condition, std::string_view before = "") {
  std::string names;
  for (const Method& method : methods()) {
    if (!condition(method)) continue;
    names += names.empty() ? "" : ", ";
    names += before;
    names += method.name;
  }
  return names;
}

const Method* find_method(std::string_view name) {
  const auto all = methods();
  const auto found = std::ranges::find(all, name, &Method::name);
  return found == all.end() ? nullptr : &*found;
}

// "sampled-64": the digits after the last hyphen, if any.
std::size_t digits_begin(std::string_view name) {
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  const bool number = begin < name.size() && begin > 1 && name[begin - 1] == '-';
  return number ? begin : name.size();
}

}  // namespace

std::span<const Method> methods() {
  static const std::array all{
      // In the order of the papers.
      kHard,         kSampled,  kRaytraced, kWedge2002, kWedgeRestructured, kSsv,
      kSsvOptimized, kCoverage, kLinear,    kDBuffer,   kOcclusionCamera,   kSilhouetteRings,
  };
  return all;
}

MethodChoice choose_method(std::string_view place, std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  std::string_view name = text.substr(0, colon);
  std::map<std::string, std::string, std::less<>> values;
  const Method* method = find_method(name);
  if (method == nullptr) {
    const std::size_t digits = digits_begin(name);
    if (digits < name.size()) {
      values["samples"] = name.substr(digits);
      method = find_method(name.substr(0, digits - 1));
    }
  }
  if (method == nullptr) {
    throw InputError(place, fmt::format("unknown method '{}'", name),
                     "one of " + known_names([](const Method&) { return true; }));
  }
  std::string_view rest = colon < text.size() ? text.substr(colon + 1) : std::string_view();
  bool more = colon < text.size();
  while (more) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view pair = rest.substr(0, comma);
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == pair.size()) {
      throw InputError(place, fmt::format("'{}' in '{}'", pair, text), "KEY=VALUE");
    }
    const auto [entry, added] =
        values.emplace(std::string(pair.substr(0, equals)), std::string(pair.substr(equals + 1)));
    if (!added) {
      throw InputError(place, fmt::format("'{}' in '{}' is given twice", entry->first, text),
                       "each option once");
    }
    more = comma < rest.size();
    if (more) rest.remove_prefix(comma + 1);
  }
  return {method, MethodOptions(fmt::format("{} {}", place, text), std::move(values)),
          std::string(text)};
}

Visibility render_method(const MethodInput& input, const MethodChoice& choice) {
  if (input.scene.light.texture && !choice.method->takes_textures) {
    throw InputError(
        input.scene.place,
        fmt::format("the light has a texture, which method '{}' does not know",
                    choice.method->name),
        "one of " +
            known_names([](const Method& method) { return method.takes_textures; }, "--method "));
  }
  Visibility visibility = choice.method->render(input, choice.options);
  choice.options.check_all_known();
  return visibility;
}

}  // namespace wedgesim::functional

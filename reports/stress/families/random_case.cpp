#include "reports/stress/families/random_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.h"

namespace wedgesim::reports::stress {
namespace {

// As the enumerators of random_scene.cpp say; sizes, distances and depths are exponents of 2.
constexpr std::array<Gene, kSceneGenes> kSceneTable{{
    {"kind", 0, 1, 50},    // coverage, linear
    {"format", 0, 3, 75},  // of the stored depths
    {"z_fail", 0, 1, 20},  // asked for, even where z-pass would do
    {"light", 0, 6, 55},   // 0 a rectangle, 6 a point, else a sphere
    {"light_size", -30, 12, 40},
    {"light_flat", 0, 24, 15},  // how much shorter the rectangle's second side is
    {"light_tilt_x", -6, 6, 20},
    {"light_tilt_z", -6, 6, 20},
    {"light_roll", -7, 7, 40},
    {"scale", -30, 17, 15},
    {"offset", -8, 19, 15},  // of the scene from the origin
    {"offset_way", 0, 7, 50},
    {"axes", 0, 5, 30},   // which way is up
    {"turn", 0, 7, 30},   // off the axes
    {"grid", 0, 10, 30},  // vertices are rounded to so many bits
    {"floor_tilt_x", -8, 8, 30},
    {"floor_tilt_z", -8, 8, 30},
    {"floor_size", -4, 17, 15},
    {"wall", 0, 1, 20},
    {"eye_place", 0, 5, 30},
    {"eye_x", -8, 8, 60},
    {"eye_y", -8, 8, 60},
    {"eye_z", -8, 8, 60},
    {"eye_distance", -4, 20, 25},
    {"view", -12, 8, 35},  // how wide
    {"near", -2, 28, 25},
    {"far", -2, 28, 25},
    {"target_x", -8, 8, 40},
    {"target_z", -8, 8, 40},
    {"close_up", 0, 1, 50},  // to the penumbra of a corner
    {"up", 0, 2, 30},
    {"casters", 0, 1, 35},  // one, two
}};

constexpr std::array<Gene, kCasterGenes> kCasterTable{{
    {"shape", 0, 5, 80},
    {"depth", -30, 30, 35},  // below 0: near the light; above 0: near the
                             // floor
    {"size", -20, 3, 20},    // as seen from the light
    {"thick", -40, 2, 30},
    {"pyramid", 0, 1, 50},  // spreads as it leaves the light: sides point
                            // at its centre
    {"x", -8, 8, 50},
    {"z", -8, 8, 50},
    {"turn", 0, 7, 30},
    {"x0", -8, 8, 15},
    {"y0", -8, 8, 15},
    {"z0", -8, 8, 15},  // how far vertices are moved
    {"x1", -8, 8, 15},
    {"y1", -8, 8, 15},
    {"z1", -8, 8, 15},
    {"x2", -8, 8, 15},
    {"y2", -8, 8, 15},
    {"z2", -8, 8, 15},
    {"x3", -8, 8, 15},
    {"y3", -8, 8, 15},
    {"z3", -8, 8, 15},
    {"move", 0, 5, 25},
    {"move_a", 0, 7, 80},
    {"move_b", 0, 7, 80},
    {"move_by", -60, 60, 60},
    {"then", 0, 5, 15},
    {"then_a", 0, 7, 80},
    {"then_b", 0, 7, 80},
    {"then_by", -60, 60, 60},
}};

constexpr std::array<std::string_view, kMostCasters> kCasterNames{"first.", "second."};

std::vector<std::string> gene_names() {
  std::vector<std::string> names;
  for (const Gene& gene : kSceneTable) names.emplace_back(gene.name);
  for (const std::string_view caster : kCasterNames) {
    for (const Gene& gene : kCasterTable) names.push_back(fmt::format("{}{}", caster, gene.name));
  }
  return names;
}

int between(std::mt19937_64& engine, int low, int high) {
  return low + static_cast<int>(engine() % static_cast<std::uint64_t>(high - low + 1));
}

}  // namespace

std::span<const Gene> gene_table() {
  static const std::vector<std::string> names = gene_names();
  static const std::vector<Gene> table = [] {
    std::vector<Gene> all(kSceneTable.begin(), kSceneTable.end());
    for (std::size_t i = 0; i < kMostCasters; ++i) {
      all.insert(all.end(), kCasterTable.begin(), kCasterTable.end());
    }
    for (std::size_t i = 0; i < all.size(); ++i) all[i].name = names[i];
    return all;
  }();
  return table;
}

Genes draw(std::mt19937_64& engine) {
  Genes genes{};
  for (std::size_t i = 0; i < kGenes; ++i) {
    const Gene& gene = gene_table()[i];
    if (between(engine, 0, 99) < gene.percent) genes[i] = between(engine, gene.low, gene.high);
  }
  return genes;
}

std::vector<Genes> simpler(const Genes& genes) {
  std::vector<Genes> all;
  const auto add = [&](std::size_t i, int value) {
    Genes& one = all.emplace_back(genes);
    one[i] = value;
  };
  for (std::size_t i = 0; i < kGenes; ++i) {
    if (genes[i] != 0) add(i, 0);
  }
  for (std::size_t i = 0; i < kGenes; ++i) {
    const int value = genes[i];
    if (value < 0) add(i, -value <= gene_table()[i].high ? -value : value / 2);
    if (std::abs(value) > 3) add(i, value / 2);
    if (std::abs(value) > 1) add(i, value > 0 ? value - 1 : value + 1);
  }
  return all;
}

std::string text_of(const Genes& genes) {
  std::string text;
  for (std::size_t i = 0; i < kGenes; ++i) {
    if (genes[i] == 0) continue;
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", gene_table()[i].name, genes[i]);
  }
  return text;
}

Genes genes_of(std::string_view text) {
  Genes genes{};
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const auto found = std::ranges::find(gene_table(), word.substr(0, equals), &Gene::name);
    int value = 0;
    const char* const end = word.data() + word.size();
    const auto parsed =
        std::from_chars(word.data() + std::min(equals + 1, word.size()), end, value);
    if (found == gene_table().end() || parsed.ec != std::errc() || parsed.ptr != end) {
      throw InputError("random case", fmt::format("'{}' is no number of it", word), "name=number");
    }
    genes[static_cast<std::size_t>(found - gene_table().begin())] = value;
  }
  return genes;
}

}  // namespace wedgesim::reports::stress

#include "reports/stress/families/random_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "reports/stress/families/random_genes.h"

namespace wedgesim::reports::stress {
namespace {

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
    if (value < found->low || value > found->high) {
      throw InputError("random case", fmt::format("'{}' is out of range", word),
                       fmt::format("a number from {} to {}", found->low, found->high));
    }
    genes[static_cast<std::size_t>(found - gene_table().begin())] = value;
  }
  return genes;
}

}  // namespace wedgesim::reports::stress

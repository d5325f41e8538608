#pragma once

#include <array>
#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// A random frame of 8 x 8 pixels is written as plain integers, so that a failing one can be made
/// simpler number by number and kept. All 0 is a harmless frame: a tetrahedron under a rectangular
/// light, above a floor. Lengths are powers of two of the light's distance from the floor.

/// One number: its name, its range, and how many percent of the random frames it is not 0 in.
struct Gene {
  std::string_view name;
  int low, high, percent;
};

inline constexpr std::size_t kSceneGenes = 32;
inline constexpr std::size_t kCasterGenes = 28;
inline constexpr std::size_t kMostCasters = 2;
inline constexpr std::size_t kGenes = kSceneGenes + kMostCasters * kCasterGenes;

using Genes = std::array<int, kGenes>;

/// What each number is, in their order.
std::span<const Gene> gene_table();

/// A random frame.
Genes draw(std::mt19937_64& engine);

/// Frames that are simpler by one number, the much simpler ones first.
std::vector<Genes> simpler(const Genes& genes);

/// "light=1 first.shape=3": the numbers that are not 0.
std::string text_of(const Genes& genes);
/// The opposite of text_of. \throws InputError naming a word that is no such number, or out of its
/// range
Genes genes_of(std::string_view text);

/// The frame that the numbers describe. It may be one that is refused.
Case case_of(const Genes& genes);

}  // namespace wedgesim::reports::stress

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace wedgesim::model {

/// One visit a wedge, or two stencil passes of umbra polygons before the penumbra pass.
enum class Mode { single_pass, three_pass };
/// Which tiles a penumbra face skips. `both` is zrange, then planes; `sat` is both, then the
/// wedge's vertices against the tile's box.
enum class Cull { none, zmax, zrange, planes, both, sat };
/// Which tiles an umbra polygon skips.
enum class UmbraCull { none, zmax };
/// In which tiles an umbra polygon is written without reading z.
enum class Accept { none, zmin };
/// Which umbra polygons share the visit of their wedge in single-pass: those that face the eye (in
/// z-fail: those that do not), or all (for `coverage` wedges; on `linear` ones the same as eye).
enum class Share { eye, all };
enum class ZChoice { automatic, pass, fail };
/// When the tiles' zmin and zmax are made from the z-buffer; `none`: they are there for nothing.
enum class TileBuild { eager, lazy, none };
/// exact: double precision, contributions rounded to 2^-40. fixed: the hardware's arithmetic
/// (model/datapath). paper255: exact, but words are integers, 255 is lit (Papers I and II).
/// float32: single precision throughout, as in a shader; contributions rounded to 2^-40.
enum class DatapathKind { exact, fixed, paper255, float32 };

/// The words of an option, in the order of its enumerators.
template <typename E>
inline constexpr std::array<std::string_view, 0> kSpellings{};
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<Mode>{"single-pass", "three-pass"};
template <>
inline constexpr std::array<std::string_view, 6> kSpellings<Cull>{"none",   "zmax", "zrange",
                                                                  "planes", "both", "sat"};
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<UmbraCull>{"none", "zmax"};
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<Accept>{"none", "zmin"};
template <>
inline constexpr std::array<std::string_view, 2> kSpellings<Share>{"eye", "all"};
template <>
inline constexpr std::array<std::string_view, 3> kSpellings<ZChoice>{"auto", "pass", "fail"};
template <>
inline constexpr std::array<std::string_view, 3> kSpellings<TileBuild>{"eager", "lazy", "none"};
template <>
inline constexpr std::array<std::string_view, 4> kSpellings<DatapathKind>{"exact", "fixed",
                                                                          "paper255", "float32"};

namespace detail {
/// \throws InputError naming the option and all words it takes
std::size_t parse_spelling(std::span<const std::string_view> spellings, std::string_view option,
                           std::string_view text);
}  // namespace detail

/// The word of a value on the command line and in JSON.
template <typename E>
constexpr std::string_view spelling(E value) {
  return kSpellings<E>[static_cast<std::size_t>(value)];
}

/// The value of a word: parse<Cull>("--cull", "both").
/// \param option  what an error names
/// \throws        InputError naming the option and all words it takes
template <typename E>
E parse(std::string_view option, std::string_view text) {
  return static_cast<E>(detail::parse_spelling(kSpellings<E>, option, text));
}

inline constexpr unsigned kMinTile = 2;    // pixels
inline constexpr unsigned kMaxTile = 256;  // pixels

/// A tile edge in pixels: a power of two, kMinTile to kMaxTile.
/// \throws InputError naming the option
unsigned parse_tile(std::string_view option, std::string_view text);

/// What is counted: one block.
struct CountConfig {
  Mode mode = Mode::single_pass;
  unsigned tile = 8;  // edge in pixels: 2, 4, ... 256
  Cull cull = Cull::both;
  UmbraCull umbra_cull = UmbraCull::zmax;
  Accept accept = Accept::none;
  Share share = Share::eye;
  ZChoice z = ZChoice::automatic;
  TileBuild tile_build = TileBuild::eager;
  bool operator==(const CountConfig&) const = default;
};

/// Does a choice come to z-fail?
/// \param needed  the eye is in a shadow volume, so that z-pass would be wrong
/// \throws InputError if z-pass is asked for where z-fail is needed
bool uses_z_fail(ZChoice choice, bool needed);

/// \throws InputError if the tile edge is not one of those allowed
void check(const CountConfig& config);

}  // namespace wedgesim::model

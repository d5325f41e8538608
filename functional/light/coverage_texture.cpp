#include "functional/light/coverage_texture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <glm/geometric.hpp>
#include <mutex>

#include "base/check.h"
#include "functional/scene/light_texture.h"

namespace wedgesim::functional {
namespace {

constexpr std::size_t kMostCached = std::size_t{512} << 20U;

double cross_2d(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Counter-clockwise about the centre, as the table takes a chord's ends.
Chord ordered(const glm::dvec2& p, const glm::dvec2& q) {
  return cross_2d(p, q) < 0.0 ? Chord{q, p} : Chord{p, q};
}

// Of a chord that turns into one that passes the centre on the other side: whether it goes through
// the centre itself, not beside it.
bool goes_through_centre(const Chord& from, const Chord& to) {
  const double before = cross_2d(from.p, from.q);
  const double after = cross_2d(to.p, to.q);
  return std::lerp(glm::dot(from.p, from.q), glm::dot(to.p, to.q), before / (before - after)) < 0.0;
}

// The two entries about a coordinate, and how near the second is.
struct Between {
  Between(double coordinate, int side) {
    const double at = 0.5 * (std::clamp(coordinate, -1.0, 1.0) + 1.0) * (side - 1);
    first = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(side) - 2);
    second_weight = static_cast<float>(at - static_cast<double>(first));
  }
  float weight(std::size_t i) const { return i == 0 ? 1.0F - second_weight : second_weight; }
  std::size_t nearest() const { return first + (second_weight >= 0.5F ? 1 : 0); }
  std::size_t first = 0;
  float second_weight = 0.0F;
};

// The four entries about an end of a chord.
struct Ends {
  Ends(const glm::dvec2& at, int side) {
    const Between x(at.x, side);
    const Between y(at.y, side);
    for (std::size_t i = 0; i < 4; ++i) {
      entries[i] = (y.first + i / 2) * static_cast<std::size_t>(side) + x.first + i % 2;
      weights[i] = y.weight(i / 2) * x.weight(i % 2);
    }
  }
  std::array<std::size_t, 4> entries{};
  std::array<float, 4> weights{};
};

}  // namespace

CoverageTexture::CoverageTexture(const Emission& emission, int side, CoverageWords words)
    : side_(side), channels_(emission.channels()) {
  CHECK_GE(side, kLeastSide);
  CHECK_LE(side, kMostSide);
  CHECK_EQ(side % 2, 0);
  const auto n = static_cast<std::size_t>(side);
  for (std::size_t i = 0; i < n * n; ++i) {
    places_.push_back(2.0 * glm::dvec2(i % n, i / n) - (side - 1.0));
  }
  if (words == CoverageWords::bits8) {
    fill_words(emission);
  } else {
    fill_floats(emission);
  }
}

template <typename Put>
void CoverageTexture::fill(const Emission& emission, const Put& put) const {
  const std::size_t ends = places_.size();
  std::vector<glm::dvec2> at;
  std::vector<Emission::Colour> round(ends);
  for (std::size_t i = 0; i < ends; ++i) {
    at.push_back(places_[i] / (side_ - 1.0));
    round[i] = emission.round(at[i]);
  }
  tbb::parallel_for(std::size_t{0}, ends, [&](std::size_t i) {
    for (std::size_t j = i + 1; j < ends; ++j) {
      const double cross = cross_2d(places_[i], places_[j]);
      const std::size_t from = cross >= 0.0 ? i : j;
      const std::size_t to = cross >= 0.0 ? j : i;
      const Emission::Colour along = emission.along(at[from], at[to]);
      const double whole = Emission::passes_start(at[from], at[to]) ? 1.0 : 0.0;
      const bool halves = cross == 0.0 && glm::dot(at[i], at[j]) < 0.0;
      Emission::Colour part{};
      Emission::Colour reversed{};
      for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
        part[c] = std::clamp(round[to][c] - round[from][c] + whole - along[c], 0.0, 1.0);
        reversed[c] = halves ? 1.0 - part[c] : part[c];
      }
      put(from * ends + to, part);
      put(to * ends + from, reversed);
    }
  });
}

void CoverageTexture::fill_floats(const Emission& emission) {
  const auto channels = static_cast<std::size_t>(channels_);
  floats_.resize(places_.size() * places_.size() * channels);
  fill(emission, [&](std::size_t entry, const Emission::Colour& part) {
    for (std::size_t c = 0; c < channels; ++c) {
      floats_[entry * channels + c] = static_cast<float>(part[c]);
    }
  });
}

void CoverageTexture::fill_words(const Emission& emission) {
  const auto channels = static_cast<std::size_t>(channels_);
  const std::size_t stride = channels == 1 ? 1 : 4;
  std::vector<std::uint8_t> bytes(places_.size() * places_.size() * stride);
  fill(emission, [&](std::size_t entry, const Emission::Colour& part) {
    for (std::size_t c = 0; c < channels; ++c) {
      bytes[entry * stride + c] = static_cast<std::uint8_t>(std::lround(255.0 * part[c]));
    }
  });
  words_.resize(bytes.size() / 4);
  for (std::size_t i = 0; i < words_.size(); ++i) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k) word |= std::uint32_t{bytes[4 * i + k]} << 8 * k;
    words_[i] = static_cast<std::int32_t>(word);
  }
}

std::size_t CoverageTexture::bytes() const {
  const auto values = places_.size() * places_.size() * static_cast<std::size_t>(channels_);
  return floats_.empty() ? values : values * sizeof(float);
}

float CoverageTexture::value(std::size_t entry, std::size_t channel) const {
  const auto channels = static_cast<std::size_t>(channels_);
  if (!floats_.empty()) return floats_[entry * channels + channel];
  const std::size_t byte = channels == 1 ? entry : 4 * entry + channel;
  const auto word = static_cast<std::uint32_t>(words_[byte / 4]);
  return static_cast<float>(word >> 8 * (byte % 4) & 255U) / 255.0F;
}

// Adds an entry as the chord has it.
void CoverageTexture::add(const Chord& chord, std::size_t from, std::size_t to, float weight,
                          std::array<float, 3>& sum) const {
  // Rounding moves each coordinate by a spacing at most, and so this product by 4 and a little.
  const double spacing = 2.0 / (side_ - 1.0);
  float whole = 0.0F;
  float sign = 1.0F;
  if (cross_2d(chord.p, chord.q) < spacing * (4.0 + 2.0 * spacing)) {
    const Chord entry{places_[from] / (side_ - 1.0), places_[to] / (side_ - 1.0)};
    if (cross_2d(places_[from], places_[to]) < 0.0) {
      sign = -1.0F;
      if (goes_through_centre(chord, entry)) whole = 1.0F;
    }
  }
  const std::size_t number = from * places_.size() + to;
  for (std::size_t c = 0; c < static_cast<std::size_t>(channels_); ++c) {
    sum[c] += weight * (whole + sign * value(number, c));
  }
}

std::array<float, 3> CoverageTexture::nearest(const glm::dvec2& p, const glm::dvec2& q) const {
  const Chord chord = ordered(p, q);
  const auto end = [&](const glm::dvec2& at) {
    return Between(at.y, side_).nearest() * static_cast<std::size_t>(side_) +
           Between(at.x, side_).nearest();
  };
  std::array<float, 3> sum{};
  add(chord, end(chord.p), end(chord.q), 1.0F, sum);
  return sum;
}

std::array<float, 3> CoverageTexture::quadlinear(const glm::dvec2& p, const glm::dvec2& q) const {
  const Chord chord = ordered(p, q);
  const Ends from(chord.p, side_);
  const Ends to(chord.q, side_);
  std::array<float, 3> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const float weight = from.weights[i] * to.weights[j];
      if (weight > 0.0F) add(chord, from.entries[i], to.entries[j], weight, sum);
    }
  }
  return sum;
}

std::shared_ptr<const CoverageTexture> coverage_texture(const std::shared_ptr<const Image>& texture,
                                                        int side, CoverageWords words) {
  struct Entry {
    std::shared_ptr<const Image> texture;
    int side;
    CoverageWords words;
    std::shared_ptr<const CoverageTexture> made;
  };
  static std::mutex mutex;
  static std::deque<Entry> cache;
  const auto same = [&](const Entry& entry) {
    if (entry.side != side || entry.words != words) return false;
    if (entry.texture == texture) return true;
    return entry.texture && texture && entry.texture->width == texture->width &&
           entry.texture->values == texture->values;
  };
  const std::scoped_lock lock(mutex);
  const auto found = std::ranges::find_if(cache, same);
  if (found != cache.end()) return found->made;
  const Emission emission = texture ? Emission(emission_shares(*texture)) : Emission();
  cache.push_back(
      {texture, side, words, std::make_shared<const CoverageTexture>(emission, side, words)});
  std::size_t bytes = 0;
  for (const Entry& entry : cache) bytes += entry.made->bytes();
  while (bytes > kMostCached && cache.size() > 1) {
    bytes -= cache.front().made->bytes();
    cache.pop_front();
  }
  return cache.back().made;
}

}  // namespace wedgesim::functional

#include "model/memory/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "tests/support/expect_input_error.h"

namespace wedgesim::model::memory {
namespace {

constexpr std::array kGrids{Surface::z, Surface::li, Surface::stencil, Surface::tile_depths};

LayoutConfig small() {
  LayoutConfig config;
  config.width = 20;  // 3 blocks
  config.height = 9;  // 2 blocks
  config.tile = 2;    // 10x5 tiles: 2x1 blocks
  config.wedge_bytes = 5000;
  return config;
}

TEST(Layout, SurfacesFollowEachOtherOnPages) {
  LayoutConfig config = small();
  config.base = 0x10000;
  const Layout layout(config);
  EXPECT_EQ(layout.base(Surface::wedges), 0x10000U);
  EXPECT_EQ(layout.base(Surface::z), 0x12000U);  // 5000 bytes are 2 pages, each other surface is 1
  EXPECT_EQ(layout.base(Surface::li), 0x13000U);
  EXPECT_EQ(layout.base(Surface::stencil), 0x14000U);
  EXPECT_EQ(layout.base(Surface::tile_depths), 0x15000U);
  EXPECT_EQ(layout.end(), 0x16000U);
  EXPECT_EQ(layout.bytes(Surface::wedges), 5000U);
  EXPECT_EQ(layout.bytes(Surface::z), 6U * 64 * 4);
  EXPECT_EQ(layout.bytes(Surface::li), 6U * 64 * 2);
  EXPECT_EQ(layout.bytes(Surface::stencil), 6U * 64);
  EXPECT_EQ(layout.bytes(Surface::tile_depths), 2U * 64 * 8);
  EXPECT_EQ(layout.wedge_address(4999), 0x10000U + 4999);
}

TEST(Layout, WordsOfABlockAreContiguousRowByRow) {
  const Layout layout(small());
  const std::uint64_t z = layout.base(Surface::z);
  EXPECT_EQ(layout.address(Surface::z, 0, 0), z);
  EXPECT_EQ(layout.address(Surface::z, 7, 0), z + 7 * 4);
  EXPECT_EQ(layout.address(Surface::z, 0, 1), z + 8 * 4);
  EXPECT_EQ(layout.address(Surface::z, 8, 0), z + 64 * 4);            // the next block
  EXPECT_EQ(layout.address(Surface::z, 1, 8), z + (3 * 64 + 1) * 4);  // the next row of blocks
  EXPECT_EQ(layout.address(Surface::tile_depths, 9, 4),
            layout.base(Surface::tile_depths) + (64 + 4 * 8 + 1) * 8);
}

TEST(Layout, EveryWordHasItsOwnAddressInsideItsSurface) {
  const Layout layout(small());
  for (const Surface surface : kGrids) {
    const bool tiles = surface == Surface::tile_depths;
    std::set<std::uint64_t> seen;
    for (unsigned y = 0; y < (tiles ? 5 : 9); ++y) {
      for (unsigned x = 0; x < (tiles ? 10 : 20); ++x) {
        const std::uint64_t address = layout.address(surface, x, y);
        EXPECT_TRUE(seen.insert(address).second);
        EXPECT_EQ(address % layout.word_bytes(surface), 0U);
      }
    }
    EXPECT_GE(*seen.begin(), layout.base(surface));
    EXPECT_LE(*seen.rbegin() + layout.word_bytes(surface),
              layout.base(surface) + layout.bytes(surface));
  }
}

TEST(Layout, LinesAreThoseOfTheWords) {
  constexpr unsigned kSeed = 1;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int z_bytes : {1, 2, 4, 8}) {
    LayoutConfig config = small();
    config.z_bytes = z_bytes;
    const Layout layout(config);
    for (const Surface surface : kGrids) {
      for (int round = 0; round < 200; ++round) {
        std::uint64_t mask = random() & random();  // sparse, dense, none, all
        if (round % 3 == 0) mask &= random() & random() & random();
        if (round == 1) mask = 0;
        if (round == 2) mask = ~std::uint64_t{0};
        const unsigned bx = static_cast<unsigned>(random() % 2);
        std::set<std::uint64_t> expected;
        for (unsigned bit = 0; bit < 64; ++bit) {
          if ((mask >> bit & 1) == 0) continue;
          const std::uint64_t address = layout.address(surface, bx * 8 + bit % 8, bit / 8);
          expected.insert(address / kLineBytes * kLineBytes);
        }
        const Lines lines = layout.lines(surface, bx, 0, mask);
        EXPECT_TRUE(std::equal(lines.begin(), lines.end(), expected.begin(), expected.end()));
      }
    }
  }
}

TEST(Layout, TheLargestFrameNeedsMoreThan32Bits) {
  LayoutConfig config;
  config.width = config.height = 16384;
  config.tile = 2;
  config.z_bytes = config.li_bytes = config.stencil_bytes = 8;
  const Layout layout(config);
  EXPECT_EQ(layout.address(Surface::z, 16383, 16383), (std::uint64_t{1} << 31) - 8);
  EXPECT_EQ(layout.end(), (std::uint64_t{6} << 30) + (std::uint64_t{1} << 29));
}

TEST(Layout, KeysAreChecked) {
  const auto error = [](auto change) {
    LayoutConfig config;
    change(config);
    return input_error_of([&] { Layout layout(config, "block.toml:3"); });
  };
  EXPECT_EQ(error([](LayoutConfig& c) { c.width = 0; }),
            "block.toml:3: 'width' is 0; expected an integer from 1 to 16384");
  EXPECT_EQ(error([](LayoutConfig& c) { c.height = 16385; }),
            "block.toml:3: 'height' is 16385; expected an integer from 1 to 16384");
  EXPECT_EQ(error([](LayoutConfig& c) { c.tile = 24; }),
            "block.toml:3: 'tile' is 24; expected a power of two from 2 to 256");
  EXPECT_EQ(error([](LayoutConfig& c) { c.z_bytes = 3; }),
            "block.toml:3: 'z_bytes' is 3; expected a power of two from 1 to 8");
  EXPECT_EQ(error([](LayoutConfig& c) { c.li_bytes = 16; }),
            "block.toml:3: 'li_bytes' is 16; expected a power of two from 1 to 8");
  EXPECT_EQ(error([](LayoutConfig& c) { c.stencil_bytes = -1; }),
            "block.toml:3: 'stencil_bytes' is -1; expected a power of two from 1 to 8");
  EXPECT_EQ(error([](LayoutConfig& c) { c.tile_bytes = 0; }),
            "block.toml:3: 'tile_bytes' is 0; expected a power of two from 1 to 8");
  EXPECT_EQ(error([](LayoutConfig& c) { c.base = 64; }),
            "block.toml:3: 'base' is 64; expected a multiple of 4096 up to 281474976710656");
}

TEST(Layout, PlacesOutsideAreRefused) {
  const Layout layout(small());
  EXPECT_THROW(layout.address(Surface::z, 24, 0), CheckError);
  EXPECT_THROW(layout.address(Surface::z, 0, 16), CheckError);
  EXPECT_THROW(layout.lines(Surface::li, 3, 0, 1), CheckError);
  EXPECT_THROW(layout.wedge_address(5000), CheckError);
}

}  // namespace
}  // namespace wedgesim::model::memory

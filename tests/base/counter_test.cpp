#include "base/counter.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wedgesim {
namespace {

struct Reads : Group {
  Counter z_reads{*this, "z_reads", Unit::accesses, "Words read from the z-buffer"};
  Counter tile_visits{*this, "tile_visits", Unit::visits, "Faces that touch a tile"};
};

TEST(Counter, RegistersInTheOrderOfDeclaration) {
  const Reads reads;
  ASSERT_EQ(reads.counters().size(), 2u);
  EXPECT_EQ(reads.counters()[0], &reads.z_reads);
  EXPECT_EQ(reads.counters()[1], &reads.tile_visits);
}

TEST(Counter, DocumentsItself) {
  const Reads reads;
  const Counter& first = *reads.counters().front();
  EXPECT_EQ(first.name(), "z_reads");
  EXPECT_EQ(first.unit(), Unit::accesses);
  EXPECT_EQ(first.description(), "Words read from the z-buffer");
}

TEST(Counter, GrowsBeyond32Bits) {
  Reads reads;
  EXPECT_EQ(reads.z_reads.value(), 0u);
  reads.z_reads += 0xffff'ffffu;
  reads.z_reads += 1;
  EXPECT_EQ(reads.z_reads.value(), 0x1'0000'0000u);
  EXPECT_EQ(reads.tile_visits.value(), 0u);
}

TEST(Group, ResetsEveryCounter) {
  Reads reads;
  reads.z_reads += 5;
  reads.tile_visits = 6;
  reads.reset();
  EXPECT_EQ(reads.z_reads.value(), 0u);
  EXPECT_EQ(reads.tile_visits.value(), 0u);
}

TEST(Unit, HasItsOwnName) {
  const std::vector<std::string> names{"accesses", "pixels", "visits", "words",
                                       "bytes",    "tiles",  "wedges", "cycles"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(name_of(static_cast<Unit>(i)), names[i]);
  }
}

}  // namespace
}  // namespace wedgesim

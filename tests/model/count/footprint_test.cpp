#include "model/count/footprint.h"

#include <gtest/gtest.h>

#include "tests/model/count/synthetic.h"

namespace wedgesim::model {
namespace {

using test::Facing;
using test::SyntheticTrace;

std::vector<test::Point> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0, 0.1}, {x1, y0, 0.1}, {x1, y1, 0.9}, {x0, y1, 0.9}};
}

constexpr std::uint64_t pixel(int column, int row) {
  return std::uint64_t{1} << (8 * row + column);
}

// Of block (0, 0), (1, 0), (0, 1), (1, 1) in this order.
struct Sets {
  std::uint64_t face, umbra, inside, hits;
};

void expect_sets(const Footprint& footprint, const std::array<Sets, 4>& expected) {
  ASSERT_EQ(footprint.blocks().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(footprint.blocks()[i].bx, i % 2);
    EXPECT_EQ(footprint.blocks()[i].by, i / 2);
    EXPECT_EQ(footprint.face(i, 0), expected[i].face);
    EXPECT_EQ(footprint.outline(i), expected[i].face);
    EXPECT_EQ(footprint.umbra(i), expected[i].umbra);
    EXPECT_EQ(footprint.inside(i), expected[i].inside);
    EXPECT_EQ(footprint.hits(i), expected[i].hits);
  }
}

TEST(Footprint, SetsOfAWedgeAcrossFourBlocks) {
  // A face on columns 6-9 of rows 7 and 8, inside from column 8 on, but (9, 8) is too near. Its
  // umbra polygon covers columns 8-11 of row 7 and reaches from depth 0.1 to 0.9; inner is before
  // 0.6. Column 8 is inner, 9 behind that plane, 10 beyond the polygon's end and so inner for one
  // that faces the eye, 11 before its begin and so not.
  SyntheticTrace synthetic(16, 16, 0.5);
  synthetic.set_depth(9, 8, 0.15);
  synthetic.set_depth(9, 7, 0.7);
  synthetic.set_depth(10, 7, 0.95);
  synthetic.set_depth(11, 7, 0.05);
  const std::uint32_t from_8 = synthetic.add_plane(1, 0, 0, -8);
  synthetic.add_face(rectangle(6, 7, 10, 9), Facing::eye, from_8);
  const std::uint32_t wedge =
      synthetic.add_wedge(traces::fb::WedgeKind_coverage, {from_8}, 0.2, 0.9);
  synthetic.add_umbra(rectangle(8, 7, 12, 8), Facing::eye, synthetic.add_plane(0, 0, -1, 0.6),
                      wedge);
  const ZFrame frame(synthetic.trace.view());
  const Primitive primitive = wedge_primitive(synthetic.trace.view(), ZMethod::pass, 0);
  for (const Kernel* kernel : {&scalar_kernel(), &simd_kernel()}) {
    SCOPED_TRACE(kernel->name);
    Footprint footprint;
    footprint.build(primitive, frame, 0, *kernel);
    const std::uint64_t left = pixel(6, 7) | pixel(7, 7);
    const std::uint64_t right = pixel(0, 7) | pixel(1, 7);
    const std::uint64_t quad = right | pixel(2, 7) | pixel(3, 7);
    expect_sets(footprint, {{{left, 0, 0, 0},
                             {right, quad, right, pixel(0, 7) | pixel(2, 7)},
                             {pixel(6, 0) | pixel(7, 0), 0, 0, 0},
                             {pixel(0, 0) | pixel(1, 0), 0, pixel(0, 0), 0}}});
    EXPECT_EQ(footprint.row_begin(0), 0u);
    EXPECT_EQ(footprint.row_begin(1), 2u);
    EXPECT_EQ(footprint.row_begin(2), 4u);
    // Of the pixels inside, (9, 7) alone is not inner: its coverage is subtracted.
    EXPECT_EQ(footprint.negated(1) & right, pixel(1, 7));
    EXPECT_EQ(footprint.negated(3) & pixel(0, 0), 0u);
  }
}

TEST(Footprint, BandsPartTheRows) {
  SyntheticTrace synthetic(8, 300, 0.5);
  const std::uint32_t everywhere = synthetic.add_plane(0, 0, 0, 1);
  synthetic.add_face(rectangle(0, 250, 8, 260), Facing::eye, everywhere);
  synthetic.add_wedge(traces::fb::WedgeKind_coverage, {everywhere}, 0.0, 1.0);
  const ZFrame frame(synthetic.trace.view());
  const Primitive primitive = wedge_primitive(synthetic.trace.view(), ZMethod::pass, 0);
  Footprint footprint;
  footprint.build(primitive, frame, 0, simd_kernel());
  ASSERT_EQ(footprint.blocks().size(), 1u);
  EXPECT_EQ(footprint.blocks()[0].by, 31u);
  EXPECT_EQ(footprint.inside(0), ~std::uint64_t{0} << 16) << "rows 250-255";
  footprint.build(primitive, frame, 1, simd_kernel());
  ASSERT_EQ(footprint.blocks().size(), 1u);
  EXPECT_EQ(footprint.blocks()[0].by, 32u);
  EXPECT_EQ(footprint.inside(0), 0xffffffffU) << "rows 256-259";
}

TEST(Footprint, CapsHitEverywhere) {
  SyntheticTrace synthetic(8, 8, 0.5);
  synthetic.add_umbra(rectangle(2, 3, 4, 4), Facing::eye, 0, traces::kNone,
                      traces::fb::UmbraRole_cap);
  const ZFrame frame(synthetic.trace.view());
  Footprint footprint;
  footprint.build(lone_primitive(synthetic.trace.view(), ZMethod::fail, 0), frame, 0,
                  simd_kernel());
  ASSERT_EQ(footprint.blocks().size(), 1u);
  EXPECT_EQ(footprint.hits(0), pixel(2, 3) | pixel(3, 3));
  EXPECT_EQ(footprint.inside(0), 0u);
}

}  // namespace
}  // namespace wedgesim::model

#include "functional/scene/manifold.h"

#include <gtest/gtest.h>

#include "functional/scene/primitives.h"
#include "functional/scene/weld.h"
#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

Mesh named_box() {
  Mesh box = make_box({2.0, 2.0, 2.0});
  box.name = "crate";
  return box;
}

std::string error_of(const Mesh& mesh) {
  return input_error_of([&] { require_closed(mesh, "scene.toml:7"); });
}

TEST(Manifold, BoxPasses) {
  EXPECT_EQ(error_of(named_box()), "");
  EXPECT_TRUE(is_sound(named_box()));
}

TEST(Manifold, MissingTriangleIsThreeBoundaryEdges) {
  Mesh box = named_box();
  box.triangles.pop_back();  // {4, 6, 7} of the top
  EXPECT_EQ(
      error_of(box),
      "scene.toml:7: mesh 'crate' is not closed: 3 boundary, 0 non-manifold and 0 "
      "inconsistently oriented edges, the first at (0, 2, -1); expected a closed two-manifold");
}

TEST(Manifold, TurnedTriangleIsThreeInconsistentEdges) {
  Mesh box = named_box();
  std::swap(box.triangles.back()[0], box.triangles.back()[1]);
  const ManifoldReport report = examine(box);
  EXPECT_EQ(report.boundary_edges, 0U);
  EXPECT_EQ(report.non_manifold_edges, 0U);
  EXPECT_EQ(report.inconsistent_edges, 3U);
  EXPECT_FALSE(report.closed());
}

TEST(Manifold, FinIsANonManifoldEdge) {
  Mesh box = named_box();
  box.positions.emplace_back(0.0, 5.0, 0.0);
  box.triangles.push_back({4, 5, 8});
  const ManifoldReport report = examine(box);
  EXPECT_EQ(report.boundary_edges, 2U);
  EXPECT_EQ(report.non_manifold_edges, 1U);
  EXPECT_EQ(report.inconsistent_edges, 0U);
}

TEST(Manifold, BoxesThatTouchAtAVertexPass) {
  Mesh boxes = named_box();
  for (std::size_t i = 0; i < 8; ++i) {
    boxes.positions.push_back(boxes.positions[i] + glm::dvec3(2.0));
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const auto t = boxes.triangles[i];
    boxes.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  }
  boxes = welded(boxes);
  EXPECT_EQ(boxes.positions.size(), 15U);
  EXPECT_EQ(error_of(boxes), "");
}

TEST(Manifold, UnweldedBoxIsAllBoundary) {
  Mesh soup;
  for (const auto& t : named_box().triangles) {
    for (const std::uint32_t i : t) {
      soup.positions.push_back(named_box().positions[i]);
    }
    const auto n = static_cast<std::uint32_t>(soup.positions.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  EXPECT_EQ(examine(soup).boundary_edges, 36U);
  EXPECT_TRUE(examine(welded(soup)).closed());
  EXPECT_EQ(welded(soup).positions.size(), 8U);
}

TEST(Manifold, InsideOutIsSaidToBe) {
  Mesh box = named_box();
  for (auto& t : box.triangles) {
    std::swap(t[1], t[2]);
  }
  EXPECT_DOUBLE_EQ(signed_volume(box), -8.0);
  EXPECT_EQ(error_of(box),
            "scene.toml:7: mesh 'crate' is inside out; expected triangles counter-clockwise seen "
            "from outside");
  EXPECT_FALSE(is_sound(box));
}

TEST(Manifold, AMeshWithoutAreaIsRefused) {
  const std::string refused =
      "scene.toml:7: mesh 'wire' has no area; expected a triangle whose corners are not on one "
      "line";
  Mesh wire;
  wire.name = "wire";
  wire.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  for (const double along : {0.0, 1.0, 2.0, 5.0}) {
    wire.positions.emplace_back(0.1F * along, 0.3F * along, 0.7F * along);
  }
  EXPECT_TRUE(examine(wire).closed());
  EXPECT_EQ(error_of(wire), refused);
  wire.positions.assign(4, glm::dvec3(1.0));
  EXPECT_EQ(error_of(wire), refused);
  wire.positions[3] = {1.0, 1.0, 2.0};
  EXPECT_EQ(error_of(wire), refused);
}

TEST(Manifold, AThinSheetHasAnArea) {
  Mesh sheet = make_thin_polygon({{0.0, 0.01}, {100.0, 0.01}, {100.0, 0.0}, {0.0, 0.0}});
  EXPECT_EQ(error_of(sheet), "");
}

TEST(Weld, NegativeZeroIsZeroAndLooseVerticesGo) {
  Mesh mesh;
  mesh.positions = {{0.0, 0.0, 0.0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0.0, -0.0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 3}, {4, 3, 5}};
  const Mesh joined = welded(mesh);
  EXPECT_EQ(joined.positions.size(), 4U);
  EXPECT_EQ(joined.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

}  // namespace
}  // namespace wedgesim::functional

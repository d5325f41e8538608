#include "functional/scene/repair.h"

#include <gtest/gtest.h>

#include "functional/scene/primitives.h"
#include "tests/functional/scene/mesh_facts.h"

namespace wedgesim::functional {
namespace {

using Lines = std::vector<std::string>;

Mesh crate() {
  Mesh box = make_box({2.0, 2.0, 2.0});
  box.name = "crate";
  return box;
}

TEST(Repair, SoundMeshStaysAndNothingIsSaid) {
  Lines notes;
  const Mesh box = repaired(crate(), notes);
  EXPECT_EQ(notes, Lines{});
  EXPECT_DOUBLE_EQ(sound_volume(box), 8.0);
}

TEST(Repair, ClosesAHoleAndSaysSo) {
  Mesh box = crate();
  box.triangles.resize(10);  // no top
  Lines notes;
  const Mesh closed = repaired(box, notes);
  EXPECT_EQ(notes, Lines{"repair of 'crate': closed 1 planar holes with 2 triangles"});
  EXPECT_DOUBLE_EQ(sound_volume(closed), 8.0);
}

TEST(Repair, LeavesAHoleThatIsNotPlanar) {
  Mesh box = crate();
  std::erase_if(box.triangles, [](const auto& t) {  // every face at corner 6
    return t[0] == 6 || t[1] == 6 || t[2] == 6;
  });
  Lines notes;
  EXPECT_FALSE(examine(repaired(box, notes)).closed());
}

TEST(Repair, TurnsATriangleBack) {
  Mesh box = crate();
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(box, notes)), 8.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': turned 1 triangles the way their neighbours run"});
}

TEST(Repair, TheMajorityDecidesTheOrientation) {
  Mesh box = crate();
  std::swap(box.triangles[0][0], box.triangles[0][1]);
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(box, notes)), 8.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': turned 1 triangles the way their neighbours run"});
}

TEST(Repair, TurnsEachComponentOutwards) {
  Mesh boxes = crate();
  for (std::size_t i = 0; i < 8; ++i) {
    boxes.positions.push_back(boxes.positions[i] + glm::dvec3(5.0, 0.0, 0.0));
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const auto t = boxes.triangles[i];
    boxes.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  }
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(boxes, notes)), 16.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': turned 1 components outwards"});
}

TEST(Repair, DropsDuplicatesOfEitherOrientation) {
  Mesh box = crate();
  const auto t = box.triangles[5];
  box.triangles.push_back({t[1], t[2], t[0]});
  box.triangles.push_back({t[1], t[0], t[2]});
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(box, notes)), 8.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': dropped 2 duplicate triangles"});
}

TEST(Repair, KeepsBothSidesOfASheet) {
  Mesh sheet;
  sheet.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 1}};
  Lines notes;
  EXPECT_EQ(repaired(sheet, notes).triangles.size(), 2U);
  EXPECT_EQ(notes, Lines{});
}

TEST(Repair, DropsDegenerateTriangles) {
  Mesh box = crate();
  box.triangles.push_back({0, 0, 1});
  box.triangles.push_back({3, 3, 3});
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(box, notes)), 8.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': dropped 2 degenerate triangles"});
}

TEST(Repair, WeldsWhatIsWithinTheStatedToleranceOnly) {
  const auto torn = [](double gap) {  // the top has vertices of its own, a gap above the sides
    Mesh box = crate();
    for (std::uint32_t i = 4; i < 8; ++i) {
      box.positions.push_back(box.positions[i] + glm::dvec3(0.0, gap, 0.0));
    }
    for (std::size_t i = 10; i < 12; ++i) {
      for (std::uint32_t& index : box.triangles[i]) {
        index += 4;
      }
    }
    return box;
  };
  Lines notes;
  EXPECT_DOUBLE_EQ(sound_volume(repaired(torn(1e-5), notes)), 8.0);
  EXPECT_EQ(notes, Lines{"repair of 'crate': welded 4 vertices to others within 3.46411e-05"});
  Lines more;  // too far: box and lid are closed each for itself
  EXPECT_EQ(repaired(torn(4e-5), more).positions.size(), 12U);
  EXPECT_EQ(more, Lines{"repair of 'crate': closed 2 planar holes with 4 triangles"});
}

TEST(Repair, FillsAConcaveHoleWithTheOrientationOfTheMesh) {
  // An L-shaped prism without its bottom.
  const std::vector<glm::dvec3> outline = {{0, 0, 0},  {2, 0, 0},  {2, 0, -1},
                                           {1, 0, -1}, {1, 0, -2}, {0, 0, -2}};
  Mesh prism;
  for (const double y : {0.0, 1.0}) {
    for (const glm::dvec3& p : outline) {
      prism.positions.emplace_back(p.x, y, p.z);
    }
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    prism.triangles.push_back({i, j, j + 6});
    prism.triangles.push_back({i, j + 6, i + 6});
  }
  Lines notes;
  EXPECT_NEAR(sound_volume(repaired(prism, notes)), 3.0, 1e-12);
  EXPECT_EQ(notes, Lines{"repair of '': closed 2 planar holes with 8 triangles"});
}

}  // namespace
}  // namespace wedgesim::functional

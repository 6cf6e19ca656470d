#include "soms/query/contains_parts.h"

#include "soms/base/error.h"

#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <vector>

namespace soms {
namespace {

using test::box_body;

/// A box in a box, and a third without its first face; a loose triangle at the end.
Mesh house() {
  Mesh mesh = box_body({0, 0, 0}, {10, 10, 10});
  mesh.parts = {{.name = "house", .count = 12}};
  const auto add = [&](Mesh part, const char* name) {
    part.parts = {{.name = name, .count = static_cast<std::uint32_t>(part.triangles.size())}};
    append(mesh, part);
  };
  add(box_body({1, 1, 1}, {3, 3, 3}), "room");
  Mesh open = box_body({5, 5, 5}, {9, 9, 9});
  open.triangles.pop_back();
  open.faces.clear();
  add(open, "crate");
  Mesh loose = test::soup_body({{{20, 0, 0}, {21, 0, 0}, {20, 1, 0}}});
  mesh.triangles.push_back({static_cast<std::uint32_t>(mesh.vertices.size()),
                            static_cast<std::uint32_t>(mesh.vertices.size() + 1),
                            static_cast<std::uint32_t>(mesh.vertices.size() + 2)});
  mesh.vertices.insert(mesh.vertices.end(), loose.vertices.begin(), loose.vertices.end());
  mesh.faces.clear();
  return mesh;
}

using Sides = std::vector<PartSide>;

TEST(ContainsParts, NamesPartsThatHoldThePoint) {
  const DividedBody body{Body(house())};
  EXPECT_EQ(contains(body, Vec3{2, 2, 2}).parts, (Sides{{0}, {1}}));
  EXPECT_EQ(contains(body, Vec3{4, 4, 4}).parts, (Sides{{0}}));
  EXPECT_EQ(contains(body, Vec3{3, 2, 2}).parts, (Sides{{0}, {1, Side::on}}));
  EXPECT_EQ(contains(body, Vec3{11, 2, 2}).parts, Sides{});
  EXPECT_EQ(contains(body, Vec3{1e9, 2, 2}).parts, Sides{});
}

TEST(ContainsParts, NamesOpenPartsAndIsNeverInsideOfThem) {
  const DividedBody body{Body(house())};
  ASSERT_EQ(body.parts().size(), 4U);
  EXPECT_EQ(body.open_parts(), 2U);
  EXPECT_EQ(body.parts()[0], (DividedPart{.named = 0, .first = 0, .triangles = 12}));
  EXPECT_TRUE(body.parts()[1].closed);
  EXPECT_EQ(
      body.parts()[2],
      (DividedPart{.named = 2, .first = 24, .triangles = 11, .closed = false, .odd_edges = 3}));
  EXPECT_EQ(body.parts()[3].named, Part::kNoParent);
  EXPECT_FALSE(body.parts()[3].closed);
  EXPECT_EQ(contains(body, Vec3{6, 6, 6}).parts, (Sides{{0}}));
  EXPECT_EQ(contains(body, Vec3{20, 0, 0}).parts, (Sides{{3, Side::on}}));
}

TEST(ContainsParts, TellsConnectedPartsApart) {
  const DividedBody body(Body(house()), Partition::connected);
  ASSERT_EQ(body.parts().size(), 4U);
  EXPECT_EQ(body.parts()[1].named, Part::kNoParent);
  EXPECT_EQ(body.parts()[1].first, 12U);
  EXPECT_EQ(body.part_of(13), 1U);
  EXPECT_EQ(contains(body, Vec3{2, 2, 2}).parts, (Sides{{0}, {1}}));
}

TEST(ContainsParts, AnswersBatchesAsSinglePoints) {
  const Pose pose = Pose::about_z(0.4, {3, 2, 1});
  const DividedBody body(Body(house(), pose));
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) {
    points.push_back(pose.apply({i % 12 - 0.5, i / 12 % 12 - 0.5, i / 144 + 0.5}));
  }
  const ContainsPartsBatch batch = contains(body, points);
  EXPECT_EQ(contains(body, points, {.threads = 3}), batch);
  EXPECT_GT(batch.parts.size(), 500U);
  for (std::size_t i = 0; i < points.size(); i += 37) {
    EXPECT_EQ(contains(body, points[i]), batch.at(i));
  }
}

TEST(ContainsParts, OfNothingAndAfterTheDeadline) {
  EXPECT_EQ(contains(DividedBody{Body{}}, std::vector<Vec3>(2)).offsets,
            (std::vector<std::uint64_t>{0, 0, 0}));
  EXPECT_EQ(DividedBody{Body{}}.parts().size(), 0U);
  const ContainsParts late = contains(DividedBody{Body(house())}, Vec3{2, 2, 2},
                                      {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(late.coverage, Coverage::cut);
  EXPECT_TRUE(late.parts.empty());
}

TEST(ContainsParts, RefusesPoints) {
  try {
    static_cast<void>(
        contains(DividedBody{Body(house())}, Vec3{0, 0, std::numeric_limits<double>::infinity()}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_finite);
  }
}

TEST(ContainsParts, TakePartsThatCloseEachOtherForOne) {
  Mesh mesh = house();
  Mesh halves =
      test::cut_by(box_body({30, 0, 0}, {32, 2, 2}), {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0}, 2);
  append(mesh, halves);
  const DividedBody body{Body(mesh)};
  const ContainsParts found = contains(body, Vec3{31, 1, 1});
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].side, Side::inside);
  const DividedPart& part = body.parts()[found.parts[0].part];
  EXPECT_TRUE(part.closed);
  EXPECT_EQ(part.triangles, 12U);
  ASSERT_EQ(part.joined.size(), 1U);
  EXPECT_EQ(mesh.parts[part.named].name, "p0");
  EXPECT_EQ(mesh.parts[part.joined[0]].name, "p1");
  EXPECT_EQ(body.open_parts(), 2U) << "the crate and the loose triangle";
  EXPECT_EQ(contains(body, Vec3{31, 1, 2}).parts, (Sides{{found.parts[0].part, Side::on}}));
}

}  // namespace
}  // namespace soms

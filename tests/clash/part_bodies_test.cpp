#include "soms/clash/part_bodies.h"

#include "soms/base/error.h"
#include "soms/clash/clash.h"
#include "soms/geometry/parts_of.h"
#include "soms/io/read_mesh.h"

#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::joined;

/// Two boxes, the first cut in two runs by the second, and a triangle of no part.
Mesh house_around_a_pipe() {
  Mesh mesh = joined(box_body({0, 0, 0}, {1, 1, 1}), box_body({2, 0, 0}, {3, 1, 1}));
  std::vector<std::array<std::uint32_t, 3>> turned(mesh.triangles.begin() + 4,
                                                   mesh.triangles.end());
  turned.insert(turned.end(), mesh.triangles.begin(), mesh.triangles.begin() + 4);
  mesh.triangles = turned;
  mesh.triangles.push_back({0, 1, 2});
  mesh.parts = {{.name = "house", .first = 0, .count = 8},
                {.name = "pipe", .first = 8, .count = 12},
                {.name = "house", .first = 20, .count = 4, .continues = 0}};
  check(mesh);
  return mesh;
}

TEST(PartBodies, HaveTheTrianglesOfTheMesh) {
  const Mesh mesh = house_around_a_pipe();
  const std::vector<PartBody> parts = part_bodies(mesh);
  ASSERT_EQ(parts.size(), 3U);
  std::size_t triangles = 0;
  for (const PartBody& part : parts) {
    ASSERT_EQ(part.triangles.size(), part.body.shape.mesh().triangles.size());
    for (std::size_t i = 0; i < part.triangles.size(); ++i) {
      EXPECT_EQ(part.body.shape.mesh().triangle(static_cast<TriangleId>(i)),
                mesh.triangle(part.triangles[i]));
      EXPECT_EQ(part_of(mesh, part.triangles[i]), part.part);
    }
    triangles += part.triangles.size();
  }
  EXPECT_EQ(triangles, mesh.triangles.size());
}

TEST(PartBodies, OfSeveralRunsAreOne) {
  const std::vector<PartBody> parts = part_bodies(house_around_a_pipe());
  EXPECT_EQ(parts[0].part, 0U);
  EXPECT_EQ(parts[0].triangles.size(), 12U);
  EXPECT_TRUE(parts[0].closed);
  EXPECT_EQ(parts[0].body.name, "house");
  EXPECT_EQ(parts[1].part, 1U);
  EXPECT_EQ(parts[2].part, Part::kNoParent);
  EXPECT_EQ(parts[2].triangles.size(), 1U);
}

TEST(PartBodies, SayWhereTheyAreOpen) {
  Mesh mesh = box_body({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const std::vector<PartBody> parts = part_bodies(mesh);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_FALSE(parts[0].closed);
  EXPECT_EQ(parts[0].odd_edges, 3U);
  EXPECT_EQ(parts[0].places.size(), 3U);
}

TEST(PartBodies, OfAnEmptyMeshAreNone) {
  EXPECT_TRUE(part_bodies(Mesh()).empty());
}

TEST(PartBodies, AreTheSameForAnyNumberOfThreads) {
  const Mesh mesh = read_mesh(test::data("clash/structure.obj").string());
  const std::vector<PartBody> one = part_bodies(mesh);
  EXPECT_EQ(one.size(), 166U);
  EXPECT_EQ(one, part_bodies(mesh, {}, {.threads = 3}));
}

TEST(PartBodies, EndWhenAStopIsRequested) {
  StopSource stop;
  stop.request_stop();
  EXPECT_THROW(
      static_cast<void>(part_bodies(house_around_a_pipe(), {}, {.stop = stop.get_token()})), Error);
}

/// A box in two halves, another in two that leave a face open, and a whole one.
Mesh boxes_in_halves() {
  const Mesh box = test::box_body({0, 0, 0}, {1, 1, 1});
  Mesh mesh = test::cut_by(box, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0}, 2);
  Mesh open = test::box_body({5, 0, 0}, {6, 1, 1});
  open.triangles.resize(10);
  open.faces.clear();
  append(mesh, test::cut_by(open, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, 2));
  append(mesh,
         test::cut_by(test::box_body({9, 0, 0}, {10, 1, 1}), std::vector<std::uint32_t>(12, 0), 1));
  return mesh;
}

TEST(PartBodies, OfPartsThatCloseEachOtherAreOne) {
  const std::vector<PartBody> parts = part_bodies(boxes_in_halves());
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[0].part, 0U);
  EXPECT_EQ(parts[0].joined, (std::vector<std::uint32_t>{1}));
  EXPECT_TRUE(parts[0].closed);
  EXPECT_EQ(parts[0].odd_edges, 0U);
  EXPECT_EQ(parts[0].body.shape.mesh().triangles.size(), 12U);
  EXPECT_TRUE(std::is_sorted(parts[0].triangles.begin(), parts[0].triangles.end()));
  for (const std::size_t open : {1U, 2U}) {
    EXPECT_EQ(parts[open].part, open + 1);
    EXPECT_TRUE(parts[open].joined.empty());
    EXPECT_FALSE(parts[open].closed);
  }
  EXPECT_EQ(parts[3].part, 4U);
  EXPECT_TRUE(parts[3].closed);
}

TEST(PartBodies, OfOpenPartsAreOneOnRequest) {
  const std::vector<PartBody> parts = part_bodies(boxes_in_halves(), {}, {}, OpenParts::joined);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].part, 2U);
  EXPECT_EQ(parts[1].joined, (std::vector<std::uint32_t>{3}));
  EXPECT_FALSE(parts[1].closed);
  EXPECT_EQ(parts[1].odd_edges, 4U);
  EXPECT_EQ(parts[1].body.shape.mesh().triangles.size(), 10U);
}

TEST(PartBodies, ThatCouldBeClosedInSeveralWaysAreOpen) {
  Mesh twice =
      test::cut_by(test::box_body({0, 0, 0}, {1, 1, 1}), {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0}, 2);
  append(twice, twice);
  for (const OpenParts open : {OpenParts::alone, OpenParts::joined}) {
    const std::vector<PartBody> parts = part_bodies(twice, {}, {}, open);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_FALSE(parts[0].closed) << "parity would call the inside of both outside";
    // So nobody knows what is in it, and nothing there is clear.
    const ClashList list =
        clashes(parts, part_bodies(test::box_body({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5})), {}, {});
    ASSERT_EQ(list.clashes.size(), 1U);
    EXPECT_EQ(list.clashes[0].kind, ClashKind::undecided);
  }
}

}  // namespace
}  // namespace soms

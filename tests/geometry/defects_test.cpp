#include "soms/geometry/defects.h"

#include "tests/support/truth/truth.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace soms {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TEST(Defects, FindsNoneInAClosedMesh) {
  const Defects defects = find_defects(tetrahedron());
  EXPECT_EQ(defects, Defects{});
  EXPECT_TRUE(defects.closed());
  Defects of_nothing;
  of_nothing.by_index.none = true;
  EXPECT_EQ(find_defects({}), of_nothing);
}

TEST(Defects, TellNoMeshClosedThatHasNoArea) {
  EXPECT_FALSE(find_defects({}).closed());
  Mesh mesh = tetrahedron();
  mesh.triangles.insert(mesh.triangles.end(), {{0, 0, 1}, {2, 2, 2}});
  mesh.parts = {{"whole", Part::kNoParent, 0, 4}, {"flat", Part::kNoParent, 4, 2}};
  Defects defects = find_defects(mesh);
  EXPECT_TRUE(defects.closed());
  EXPECT_TRUE(defects.parts.at(0).closed());
  EXPECT_FALSE(defects.parts.at(1).closed());
  EXPECT_TRUE(defects.parts.at(1).none);
  mesh.parts.clear();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4);
  defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 0U);
  EXPECT_FALSE(defects.closed());
  EXPECT_FALSE(defects.by_index.closed());
}

TEST(Defects, JoinsVerticesByPositionWhateverTheSignOfZero) {
  Mesh mesh;
  for (TriangleId i = 0; i < 4; ++i) {
    const Triangle t = tetrahedron().triangle(i);
    for (const Vec3& p : {t.a, t.b, t.c}) {
      mesh.vertices.push_back(i % 2 == 0 || p.x != 0 ? p : Vec3{-0.0, p.y, p.z});
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Defects defects = find_defects(mesh);
  EXPECT_TRUE(defects.closed());
  EXPECT_EQ(defects.repeated_vertices, 8U);
  EXPECT_EQ(defects.by_index, (EdgeCounts{12, 0, 0}));
}

TEST(Defects, CountsOpenEdgesOfAHole) {
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.open_edges, 3U);
  EXPECT_FALSE(defects.closed());
}

TEST(Defects, CountsEdgesRunTwiceInOneDirection) {
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.flipped_edges, 3U);
  EXPECT_EQ(defects.open_edges, 0U);
  EXPECT_FALSE(defects.closed());
}

TEST(Defects, CountsEdgesOfMoreThanTwoTriangles) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({0.5, -1, 0});
  mesh.triangles.push_back({0, 1, 4});
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.non_manifold_edges, 1U);
  EXPECT_EQ(defects.open_edges, 2U);
  EXPECT_FALSE(defects.closed());
}

TEST(Defects, CountsDuplicatesInAnyOrderOfCorners) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({1, 0, 0});
  mesh.triangles.push_back({3, 2, 4});
  mesh.triangles.push_back({1, 2, 3});
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.duplicate, 2U);
  EXPECT_EQ(defects.doubled, 1U);  // (3, 2, 1) turns against (1, 2, 3)
  EXPECT_EQ(defects.places.duplicate, (std::vector<TriangleCopy>{{4, 2}, {5, 2}}));
  EXPECT_EQ(defects.places.doubled, (std::vector<TriangleCopy>{{4, 2}}));
  EXPECT_EQ(defects.non_manifold_edges, 3U);
}

TEST(Defects, NamesWhereTheyAre) {
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[1][0], mesh.triangles[1][1]);
  mesh.parts = {{"base", Part::kNoParent, 0, 1}, {"rest", Part::kNoParent, 1, 3}};
  mesh.vertices.push_back({7, 7, 7});
  const Defects defects = find_defects(mesh);
  // Triangle 1 is (1, 0, 3): its edges run as those of 0, 3 and 2.
  EXPECT_EQ(defects.places.flipped_edges,
            (std::vector<EdgePlace>{{0, 2, 1, 2}, {1, 1, 3, 2}, {1, 2, 2, 2}}));
  EXPECT_EQ(defects.places.unused_vertices, (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(defects.parts, (std::vector<EdgeCounts>{{3, 0, 0}, {3, 0, 2}}));
}

TEST(Defects, CountsDegenerateTrianglesExactlyAndLeavesTheirEdgesOut) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({0.5, 0.5, 0});
  mesh.vertices.push_back({1.0 / 3, 2.0 / 3, 0});
  mesh.vertices.push_back({0.1, 0.1, 0.1});
  mesh.vertices.push_back({0.2, 0.2, 0.2});
  mesh.vertices.push_back({0.3, 0.3, 0.3});
  mesh.triangles.push_back({1, 4, 2});
  mesh.triangles.push_back({3, 3, 3});
  mesh.triangles.push_back({0, 3, 0});
  mesh.triangles.push_back({6, 7, 8});
  const Defects defects = find_defects(mesh);
  EXPECT_EQ(defects.degenerate, 4U);
  EXPECT_EQ(defects.repeated_corner, 2U);
  EXPECT_EQ(defects.places.repeated_corner, (std::vector<TriangleId>{5, 6}));
  EXPECT_EQ(defects.places.collinear, (std::vector<TriangleId>{4, 7}));
  EXPECT_EQ(defects.unused_vertices, 1U);
  EXPECT_TRUE(defects.closed());
  // The doubles nearest 1/3 and 2/3 do not add up to 1, so this one has area.
  mesh.triangles.push_back({1, 5, 2});
  EXPECT_EQ(find_defects(mesh).degenerate, 4U);
}

TEST(Defects, TellsClosedMeshesOfTheTruthSet) {
  int closed = 0;
  for (const auto& [name, expected] : test::truth_closed()) {
    const Mesh& mesh = *test::truth_mesh(name);
    EXPECT_EQ(find_defects(mesh).closed(), expected) << name;
    closed += expected ? 1 : 0;
  }
  EXPECT_EQ(closed, 23);
}

}  // namespace
}  // namespace soms

#include "soms/geometry/defects.h"

#include "tests/support/truth.h"

#include <gtest/gtest.h>

#include <utility>

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
  EXPECT_EQ(find_defects({}), Defects{});
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
  EXPECT_EQ(find_defects(mesh), Defects{});
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
  EXPECT_EQ(defects.non_manifold_edges, 3U);
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
  EXPECT_EQ(defects.unused_vertices, 1U);
  EXPECT_TRUE(defects.closed());
  // The doubles nearest 1/3 and 2/3 do not add up to 1, so this one has area.
  mesh.triangles.push_back({1, 5, 2});
  EXPECT_EQ(find_defects(mesh).degenerate, 4U);
}

// The set calls meshes of segments and points open; without a proper triangle nothing is open.
TEST(Defects, TellsClosedMeshesOfTheTruthSet) {
  int closed = 0;
  for (const auto& [name, expected] : test::truth_closed()) {
    const Mesh& mesh = *test::truth_mesh(name);
    const Defects defects = find_defects(mesh);
    EXPECT_EQ(defects.closed(), expected || defects.degenerate == mesh.triangles.size()) << name;
    closed += expected ? 1 : 0;
  }
  EXPECT_EQ(closed, 23);
}

}  // namespace
}  // namespace soms

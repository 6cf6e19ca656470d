#include "soms/geometry/parts_of.h"

#include "soms/base/error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace soms {
namespace {

/// Seven triangles: a street of the first five, in it a house of 1 to 3 and a nameless part of 4.
Mesh street() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(7, {0, 1, 2});
  mesh.parts = {{.name = "street", .first = 0, .count = 5},
                {.name = "house", .parent = 0, .first = 1, .count = 3},
                {.name = "", .parent = 0, .first = 4, .count = 1}};
  return mesh;
}

TEST(PartsOf, AreThoseOfPartOf) {
  const Mesh mesh = street();
  const PartsOf parts(mesh);
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    EXPECT_EQ(parts(i), part_of(mesh, i)) << i;
  }
  EXPECT_EQ(parts(2), 1U);
  EXPECT_EQ(parts(6), Part::kNoParent);
}

TEST(PartsOf, OfAnObjectOfSeveralRunsAreItsFirstRun) {
  Mesh mesh = street();
  mesh.parts.push_back(
      {.name = "house", .parent = Part::kNoParent, .first = 5, .count = 2, .continues = 1});
  check(mesh);
  const PartsOf parts(mesh);
  for (const TriangleId i : {1U, 2U, 3U, 5U, 6U}) {
    EXPECT_EQ(parts(i), 1U) << i;
    EXPECT_EQ(part_of(mesh, i), 1U) << i;
  }
  EXPECT_EQ(part_runs(mesh).back(), (PartRun{5, 3})) << "a run is named by itself";

  Mesh twice = mesh;
  append(twice, mesh);
  check(twice);
  EXPECT_EQ(PartsOf(twice)(12), 5U) << "runs that are appended continue their own object";
}

TEST(PartsOf, ContinueNothingButAFirstRun) {
  Mesh mesh = street();
  mesh.parts[1].continues = 7;
  EXPECT_THROW(check(mesh), Error);
  mesh.parts[1].continues = 1;
  EXPECT_THROW(check(mesh), Error);
  mesh.parts[1].continues = 2;
  check(mesh);
  mesh.parts[2].continues = 0;
  EXPECT_THROW(check(mesh), Error);
}

TEST(PartsOf, OfAMeshWithoutPartsAreNone) {
  Mesh mesh = street();
  mesh.parts.clear();
  EXPECT_EQ(PartsOf(mesh)(3), Part::kNoParent);
  EXPECT_EQ(PartsOf()(0), Part::kNoParent);
}

TEST(PartsOf, OutlivesItsMeshAndComparesByValue) {
  PartsOf parts;
  {
    const Mesh mesh = street();
    parts = PartsOf(mesh);
    EXPECT_EQ(parts, PartsOf(mesh));
  }
  EXPECT_EQ(parts(4), 2U);
  EXPECT_NE(parts, PartsOf());
}

TEST(PartPath, NamesWhatEnclosesAPartFromTheOutermostOn) {
  const Mesh mesh = street();
  EXPECT_EQ(part_path(mesh, 0), std::vector<std::string>{"street"});
  EXPECT_EQ(part_path(mesh, 1), (std::vector<std::string>{"street", "house"}));
  EXPECT_EQ(part_path(mesh, 2), (std::vector<std::string>{"street", ""}));
}

TEST(PartPath, EndsWherePartsEncloseEachOther) {
  Mesh mesh = street();
  mesh.parts[0].parent = 1;
  EXPECT_LE(part_path(mesh, 1).size(), mesh.parts.size());
}

}  // namespace
}  // namespace soms

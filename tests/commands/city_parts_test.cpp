#include "apps/model/models.h"
#include "apps/world/part_names.h"
#include "apps/world/world.h"
#include "tests/commands/run.h"

namespace soms::command {
namespace {

/// Seven triangles: a street of the first five, in it a house of 1 to 3 and a nameless part of 4.
Mesh nested() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(7, {0, 1, 2});
  mesh.parts = {{.name = "street", .first = 0, .count = 5},
                {.name = "house", .parent = 0, .first = 1, .count = 3},
                {.name = "", .parent = 0, .first = 4, .count = 1}};
  return mesh;
}

TEST(CityParts, AreThoseOfPartName) {
  World world;
  add_to_city(world, Body(Shape(nested()), Pose{}, "street"), {});
  add_to_city(world, Body(Shape(nested()), Pose{}, "other"), {});
  const CityParts parts(world);
  for (EnvironmentId body = 0; body < 2; ++body) {
    for (TriangleId i = 0; i < 7; ++i) {
      EXPECT_EQ(parts.name(body, i), part_name(world, body, i)) << body << " " << i;
    }
  }
  EXPECT_EQ(parts.name(0, 2), "house");
  EXPECT_EQ(parts.name(1, 6), "other");
}

TEST(PartPathLabel, KeepsItsEndWhereItIsLong) {
  Mesh mesh = nested();
  mesh.parts.push_back({.name = "door", .parent = 2, .first = 4, .count = 1});
  EXPECT_EQ(part_path_label(mesh, 3), "street/.../door");
  EXPECT_EQ(part_path_label(mesh, 3, 15), "street/.../door");
  EXPECT_EQ(part_path_label(mesh, 3, 5), ".../door");
  EXPECT_EQ(part_path_label(mesh, Part::kNoParent), "");
}

}  // namespace
}  // namespace soms::command

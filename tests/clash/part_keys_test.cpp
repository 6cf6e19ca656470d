#include "soms/clash/part_keys.h"

#include "soms/io/read_mesh.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace soms {
namespace {

std::vector<std::uint64_t> keys_of(const Mesh& mesh) {
  const std::vector<PartBody> parts = part_bodies(mesh);
  std::vector<MeshPart> named;
  for (const PartBody& part : parts) {
    named.push_back({mesh, &part});
  }
  return part_keys(named);
}

/// A mesh of boxes, one a part, with a corner at each of `places`.
Mesh boxes(const std::vector<std::string>& names, const std::vector<double>& places) {
  Mesh mesh;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double x = places[k];
    mesh = test::joined(mesh, test::box_body({x, 0, 0}, {x + 1, 1, 1}));
    mesh.parts.push_back(
        {.name = names[k], .first = static_cast<std::uint32_t>(12 * k), .count = 12});
  }
  return mesh;
}

TEST(PartKeys, AreAllDifferent) {
  const std::vector<std::uint64_t> keys =
      keys_of(read_mesh(test::data("clash/structure.obj").string()));
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), 166U);
}

TEST(PartKeys, SurviveAnotherOrderOfPartsAndTriangles) {
  Mesh mesh = boxes({"wall", "pipe", "pipe", ""}, {0, 10, 20, 30});
  const std::vector<std::uint64_t> keys = keys_of(mesh);
  Mesh turned = boxes({"", "pipe", "wall", "pipe"}, {30, 20, 0, 10});
  std::reverse(turned.triangles.begin(), turned.triangles.begin() + 12);
  for (auto& t : turned.triangles) {
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  const std::vector<std::uint64_t> again = keys_of(turned);
  EXPECT_EQ(again, (std::vector{keys[3], keys[2], keys[0], keys[1]}));
}

TEST(PartKeys, OfPartsNamedAloneSurviveAMove) {
  const std::vector<std::uint64_t> keys = keys_of(boxes({"wall", "pipe", "pipe"}, {0, 10, 20}));
  const std::vector<std::uint64_t> moved = keys_of(boxes({"wall", "pipe", "pipe"}, {1, 11, 20}));
  EXPECT_EQ(moved[0], keys[0]);
  EXPECT_NE(moved[1], keys[1]);
  EXPECT_EQ(moved[2], keys[2]);
}

TEST(PartKeys, AreMadeOfIdsWhereThereAreSome) {
  Mesh mesh = boxes({"wall", "wall"}, {0, 10});
  mesh.parts[0].id = "2O2Fr$t4X7Zf8NOew3FLOH";
  mesh.parts[1].id = "0d2Fr$t4X7Zf8NOew3FLOH";
  const std::vector<std::uint64_t> keys = keys_of(mesh);
  mesh.parts[0].name = "WALL";
  std::swap(mesh.vertices[0], mesh.vertices[1]);
  EXPECT_EQ(keys_of(mesh), keys);
}

TEST(PartKeys, OfPartsThatAreAlikeDiffer) {
  const std::vector<std::uint64_t> keys = keys_of(boxes({"pipe", "pipe"}, {5, 5}));
  EXPECT_NE(keys[0], keys[1]);
}

TEST(PartKeys, TakeMinusZeroForZero) {
  Mesh mesh = boxes({"pipe", "pipe"}, {0, 10});
  const std::vector<std::uint64_t> keys = keys_of(mesh);
  for (Vec3& v : mesh.vertices) {
    v.y = v.y == 0 ? -0.0 : v.y;
  }
  EXPECT_EQ(keys_of(mesh), keys);
}

TEST(ClashKey, IsTheSameInEitherOrder) {
  EXPECT_EQ(clash_key(3, 8), clash_key(8, 3));
  EXPECT_NE(clash_key(3, 8), clash_key(3, 9));
}

}  // namespace
}  // namespace soms

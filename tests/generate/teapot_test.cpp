#include "soms/generate/teapot.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "tests/generate/closed.h"
#include "tests/support/support.h"

#include <algorithm>
#include <set>
#include <string>

namespace soms {
namespace {

std::string teapot_error(std::uint32_t subdivisions) {
  try {
    static_cast<void>(generate_teapot(subdivisions));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return {};
}

TEST(Teapot, HasTheTrianglesOfItsCellsButThoseWithoutArea) {
  for (std::uint32_t n = 2; n <= 12; ++n) {
    const Mesh teapot = generate_teapot(n);
    EXPECT_EQ(teapot.triangles.size(), teapot_triangles(n));
    EXPECT_EQ(test::flat_triangles(teapot), 0U) << n;
    EXPECT_NO_THROW(check(teapot));
  }
  // The two teapots that go around as PLY files have these counts.
  EXPECT_EQ(generate_teapot(6).triangles.size(), 2256U);
  EXPECT_EQ(generate_teapot(6).vertices.size(), 1177U);
  EXPECT_EQ(generate_teapot().triangles.size(), 6320U);
  EXPECT_EQ(generate_teapot().vertices.size(), 3241U);
}

TEST(Teapot, StandsOnTheGroundWithItsSpoutTowardsX) {
  const Box box = bounds(generate_teapot());
  EXPECT_EQ(box.lower, (Vec3{-3, -2, 0}));
  EXPECT_EQ(box.upper.y, 2);
  EXPECT_EQ(box.upper.z, 3.15);
  EXPECT_NEAR(box.upper.x, 3.43, 0.01);
}

TEST(Teapot, IsMirroredInTheMiddle) {
  const Mesh teapot = generate_teapot(5);
  std::set<std::array<double, 3>> points;
  for (const Vec3& v : teapot.vertices) {
    points.insert({v.x, v.y, v.z});
  }
  EXPECT_EQ(points.size(), teapot.vertices.size());
  for (const Vec3& v : teapot.vertices) {
    EXPECT_EQ(points.count({v.x, -v.y, v.z}), 1U);
  }
}

TEST(Teapot, HasPartsThatFaceOutward) {
  const Mesh teapot = generate_teapot(8);
  std::uint32_t next = 0;
  for (const Part& part : teapot.parts) {
    EXPECT_EQ(part.first, next);
    next += part.count;
    EXPECT_GT(test::volume6(test::part_mesh(teapot, part)), 0) << part.name;
  }
  EXPECT_EQ(next, teapot.triangles.size());
  EXPECT_EQ(teapot.parts.size(), 6U);
}

/// Sides of triangles without a neighbor.
std::size_t open_edges(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides.emplace(t[i], t[(i + 1) % 3]);
    }
  }
  return static_cast<std::size_t>(std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
    return sides.count({side.second, side.first}) == 0;
  }));
}

TEST(Teapot, IsOpenOnlyWhereLidHandleAndSpoutEnd) {
  const std::uint32_t n = 10;
  // The lid's edge and the rim's, both ends of the handle and of the spout.
  EXPECT_EQ(open_edges(generate_teapot(n)), 2 * 4 * n + 2 * 2 * n + 2 * 2 * n);
}

TEST(Teapot, IsTheOneThatGoesAroundAsAFile) {
  SOMS_NEEDS_OUTSIDE_DATA("1 model");
  const Mesh file = read_mesh(*test::outside_data("ply/teapot.ply"));
  for (const Vec3& v : generate_teapot(10).vertices) {
    const Vec3 turned{-v.y, v.z, -v.x};  // y up, spout toward -z
    const bool found = std::any_of(file.vertices.begin(), file.vertices.end(), [&](const Vec3& w) {
      return dot(w - turned, w - turned) < 1e-10;  // the file has six digits
    });
    ASSERT_TRUE(found) << turned.x << ' ' << turned.y << ' ' << turned.z;
  }
}

TEST(Teapot, NamesTheSubdivisionsThatItTakes) {
  EXPECT_EQ(teapot_error(1), "teapot of 1 subdivisions; take 2 to 256");
  EXPECT_EQ(teapot_error(257), "teapot of 257 subdivisions; take 2 to 256");
}

TEST(Teapot, IsTheSameBitsEverywhere) {
  EXPECT_EQ(corner_hash(generate_teapot(6)), 16131169353988102694ULL);
  EXPECT_EQ(corner_hash(generate_teapot(10)), 12898341939878007818ULL);
}

}  // namespace
}  // namespace soms

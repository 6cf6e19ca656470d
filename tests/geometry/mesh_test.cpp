#include "soms/geometry/mesh.h"

#include "soms/base/error.h"
#include "soms/base/hash.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace soms {
namespace {

Mesh two_triangles() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}, {99, 99, 99}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.source = "two.ply";
  return mesh;
}

/// The error of `check` after `change`, as text and kind.
void expect_refused(const std::function<void(Mesh&)>& change, ErrorKind kind,
                    const std::string& words) {
  Mesh mesh = two_triangles();
  change(mesh);
  try {
    check(mesh);
    ADD_FAILURE() << "accepted: " << words;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Mesh, CheckAcceptsAMeshWithUnusedVertices) {
  EXPECT_NO_THROW(check(two_triangles()));
  EXPECT_NO_THROW(check(Mesh{}));
  Mesh mesh = two_triangles();
  mesh.vertices[4].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(check(mesh));
}

TEST(Mesh, CheckNamesTheFirstTriangleAtFault) {
  const double infinity = std::numeric_limits<double>::infinity();
  expect_refused([](Mesh& m) { m.triangles[1][2] = 5; }, ErrorKind::bad_file,
                 "two.ply, triangle 1: vertex 5, but vertices are 0 to 4");
  expect_refused([](Mesh& m) { m.vertices[3].y = std::nan(""); }, ErrorKind::not_finite,
                 "triangle 1: y");
  expect_refused([=](Mesh& m) { m.vertices[0].z = -infinity; }, ErrorKind::not_finite,
                 "triangle 0: z");
  expect_refused([](Mesh& m) { m.vertices[2].x = -std::nextafter(0x1p300, 0x1p301); },
                 ErrorKind::out_of_range, "triangle 0: x of a corner exceeds 2^300");
}

TEST(Mesh, CheckAcceptsTheLargestCoordinate) {
  Mesh mesh = two_triangles();
  mesh.vertices[0] = {0x1p300, -0x1p300, 5e-324};
  EXPECT_NO_THROW(check(mesh));
}

TEST(Mesh, CheckRefusesPartsAndFacesThatDoNotFit) {
  expect_refused([](Mesh& m) { m.faces = {0}; }, ErrorKind::bad_file, "face map");
  expect_refused(
      [](Mesh& m) {
        m.parts = {{"roof", Part::kNoParent, 1, 2}};
      },
      ErrorKind::bad_file, "roof");
  expect_refused([](Mesh& m) { m.parts = {{"roof", 1, 0, 2}}; }, ErrorKind::bad_file, "roof");
  expect_refused(
      [](Mesh& m) {
        m.parts = {{"roof", Part::kNoParent, 0xffffffffU, 1}};
      },
      ErrorKind::bad_file, "roof");
}

TEST(Mesh, BoundsLeaveUnusedVerticesOut) {
  EXPECT_EQ(bounds(two_triangles()), (Box{{0, 0, 0}, {1, 2, 3}}));
  EXPECT_TRUE(bounds(Mesh{}).empty());
}

TEST(Mesh, PartOfIsTheInnermost) {
  Mesh mesh = two_triangles();
  EXPECT_EQ(part_of(mesh, 0), Part::kNoParent);
  mesh.parts = {{"car", Part::kNoParent, 0, 2}, {"wheel", 0, 1, 1}};
  EXPECT_EQ(part_of(mesh, 0), 0U);
  EXPECT_EQ(part_of(mesh, 1), 1U);
  EXPECT_EQ(part_of(mesh, 2), Part::kNoParent);
}

TEST(Mesh, AppendKeepsBothNumberings) {
  Mesh mesh = two_triangles();
  Mesh other = two_triangles();
  other.source = "other.ply";
  other.parts = {{"a", Part::kNoParent, 0, 2}, {"b", 0, 1, 1}};
  other.faces = {7, 7};
  append(mesh, other);
  EXPECT_NO_THROW(check(mesh));
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.triangle(2), other.triangle(0));
  EXPECT_EQ(mesh.triangle(3), other.triangle(1));
  EXPECT_EQ(mesh.faces, (std::vector<std::uint32_t>{0, 1, 7, 7}));
  ASSERT_EQ(mesh.parts.size(), 3U);
  EXPECT_EQ(mesh.parts[0], (Part{"two.ply", Part::kNoParent, 0, 2}));
  EXPECT_EQ(mesh.parts[1], (Part{"a", Part::kNoParent, 2, 2}));
  EXPECT_EQ(mesh.parts[2], (Part{"b", 1, 3, 1}));
}

TEST(Mesh, AppendToItselfDoublesIt) {
  Mesh mesh = two_triangles();
  const Mesh once = mesh;
  append(mesh, mesh);
  Mesh expected = once;
  append(expected, once);
  EXPECT_EQ(mesh.triangles, expected.triangles);
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.parts, expected.parts);
}

TEST(Mesh, AppendToAnEmptyMeshNamesOnePart) {
  Mesh mesh;
  append(mesh, two_triangles());
  EXPECT_EQ(mesh.triangles, two_triangles().triangles);
  ASSERT_EQ(mesh.parts.size(), 1U);
  EXPECT_EQ(mesh.parts[0].name, "two.ply");
  EXPECT_TRUE(mesh.faces.empty());
}

TEST(Mesh, TransformedTurnsWithoutRounding) {
  const Mesh mesh = two_triangles();
  EXPECT_EQ(transformed(mesh, 1, UpAxis::y).vertices[3], (Vec3{0, -3, 2}));
  EXPECT_EQ(transformed(mesh, 1, UpAxis::x).vertices[3], (Vec3{-2, -3, 0}));
  EXPECT_EQ(transformed(mesh, 1, UpAxis::z).vertices, mesh.vertices);
  EXPECT_EQ(transformed(mesh, 1, UpAxis::unknown).vertices, mesh.vertices);
  EXPECT_EQ(transformed(mesh, 1, UpAxis::y).up, UpAxis::z);
  EXPECT_EQ(transformed(mesh, 1, UpAxis::unknown).up, UpAxis::unknown);
}

TEST(Mesh, TransformedScalesVerticesAndUnit) {
  Mesh mesh = two_triangles();
  mesh.unit = 1;
  const Mesh scaled = transformed(mesh, 1000, UpAxis::unknown);
  EXPECT_EQ(scaled.vertices[3], (Vec3{0, 2000, 3000}));
  EXPECT_EQ(scaled.unit, 0.001);
  for (const double scale : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(static_cast<void>(transformed(mesh, scale, UpAxis::z)), Error);
  }
}

TEST(Mesh, TransformedKnowsNoUnitThatNoDoubleHolds) {
  Mesh mesh = two_triangles();
  mesh.unit = 1;
  EXPECT_EQ(transformed(mesh, 1e-320, UpAxis::unknown).unit, 0);
  EXPECT_EQ(transformed(mesh, 0x1p-1000, UpAxis::unknown).unit, 0x1p1000);
  mesh.unit = 1e-300;
  EXPECT_EQ(transformed(mesh, 1e300, UpAxis::unknown).unit, 0);
}

TEST(Mesh, CornerHashRunsOverCornersInOrder) {
  Fnv1a hash;
  for (const double x : {0., 0., 0., 1., 0., 0., 1., 2., 0., 0., 0., 0., 1., 2., 0., 0., 2., 3.}) {
    hash.add(x);
  }
  EXPECT_EQ(corner_hash(two_triangles()), hash.value());
  EXPECT_EQ(corner_hash(Mesh{}), 0xcbf29ce484222325ULL);
}

}  // namespace
}  // namespace soms

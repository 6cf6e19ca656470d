#include "soms/base/error.h"
#include "soms/io/write_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stop_token>
#include <string>
#include <vector>

namespace soms::test {
namespace {

std::string as_three_ds(const Mesh& mesh, const Limits& limits = {}) {
  std::ostringstream out;
  write_mesh(out, "out", mesh, MeshFormat::three_ds, limits);
  return out.str();
}

Mesh read_three_ds_back(const Mesh& mesh) {
  return read_text(as_three_ds(mesh), "out.3ds");
}

/// Not inline: g++ 12 vectorizes double to float to double of two neighbors into nothing.
[[gnu::noinline]] double narrow(double x) {
  return static_cast<float>(x);
}

Vec3 narrow(const Vec3& v) {
  return {narrow(v.x), narrow(v.y), narrow(v.z)};
}

void expect_same_corners(const Mesh& back, const Mesh& mesh) {
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle one = back.triangle(i);
    const Triangle two = mesh.triangle(i);
    ASSERT_EQ(one.a, narrow(two.a)) << i;
    ASSERT_EQ(one.b, narrow(two.b)) << i;
    ASSERT_EQ(one.c, narrow(two.c)) << i;
  }
}

/// `triangles` that draw on `vertices` points, each point apart from the others.
Mesh scattered(Rng& rng, std::size_t vertices, std::size_t triangles) {
  Mesh mesh;
  for (std::size_t i = 0; i < vertices; ++i) {
    mesh.vertices.push_back({static_cast<double>(i), rng.uniform(-1, 1), 0.1});
  }
  const auto vertex = [&] { return static_cast<std::uint32_t>(rng.below(vertices)); };
  for (std::size_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({vertex(), vertex(), vertex()});
  }
  return mesh;
}

Mesh with_parts(std::vector<Part> parts, std::size_t triangles) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(triangles, {0, 1, 2});
  mesh.parts = std::move(parts);
  return mesh;
}

std::vector<std::string> names_of(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const Part& part : mesh.parts) {
    names.push_back(part.name);
  }
  return names;
}

TEST(ThreeDsWriter, WritesExactlyThis) {
  const auto chunk = [](std::uint64_t name, const std::string& body) {
    return bytes_of(name, 2) + bytes_of(body.size() + 6, 4) + body;
  };
  Mesh mesh = with_parts({{"roof", Part::kNoParent, 0, 1}}, 1);
  mesh.vertices[1] = {0.5, -0.0, 7};
  std::string vertices = bytes_of(3, 2);
  for (const float x : {0.0F, 0.0F, 0.0F, 0.5F, -0.0F, 7.0F, 0.0F, 1.0F, 0.0F}) {
    vertices += bytes_of(x);
  }
  const std::string faces =
      bytes_of(1, 2) + bytes_of(0, 2) + bytes_of(1, 2) + bytes_of(2, 2) + bytes_of(7, 2);
  const std::string object =
      std::string("roof") + '\0' + chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  const std::string editor =
      chunk(0x3d3e, bytes_of(3, 4)) + chunk(0x0100, bytes_of(1.0F)) + chunk(0x4000, object);
  EXPECT_EQ(as_three_ds(mesh),
            chunk(0x4d4d, chunk(0x0002, bytes_of(3, 4)) + chunk(0x3d3d, editor)));
}

TEST(ThreeDsWriter, IsReadBackWithTheSameTrianglesAsFloats) {
  for_each_case("io/three-ds", 100, [](Rng& rng) {
    const Mesh mesh = scattered(rng, 1 + rng.below(60), 1 + rng.below(90));
    expect_same_corners(read_three_ds_back(mesh), mesh);
    EXPECT_EQ(as_three_ds(mesh), as_three_ds(mesh));
  });
}

TEST(ThreeDsWriter, KeepsTheNumbersOfVerticesThatAreAllUsed) {
  Mesh mesh;
  mesh.vertices = {{3, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  mesh.triangles = {{3, 1, 2}, {2, 0, 3}};
  const Mesh back = read_three_ds_back(mesh);
  EXPECT_EQ(back.vertices, mesh.vertices);
  EXPECT_EQ(back.triangles, mesh.triangles);
}

TEST(ThreeDsWriter, LeavesOutVerticesThatNoTriangleUses) {
  Mesh mesh = with_parts({}, 2);
  mesh.vertices.insert(mesh.vertices.begin(), Vec3{1e300, 0, 0});
  mesh.triangles.assign(2, {1, 2, 3});
  const Mesh back = read_three_ds_back(mesh);
  EXPECT_EQ(back.vertices.size(), 3U);
  expect_same_corners(back, mesh);
}

TEST(ThreeDsWriter, SplitsAtTheMostFacesInOrder) {
  for (const std::size_t count : {65'534U, 65'535U, 65'536U, 131'070U, 131'071U}) {
    Mesh mesh = with_parts({}, count);
    for (std::size_t i = 0; i < count; ++i) {
      mesh.triangles[i] = {static_cast<std::uint32_t>(i % 3), 1, static_cast<std::uint32_t>(i % 2)};
    }
    const Mesh back = read_three_ds_back(mesh);
    expect_same_corners(back, mesh);
    ASSERT_EQ(back.parts.size(), (count + 65'534) / 65'535);
    EXPECT_EQ(back.parts[0].count, std::min<std::size_t>(count, 65'535));
  }
}

TEST(ThreeDsWriter, SplitsAtTheMostVerticesInOrder) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    mesh.vertices.push_back({static_cast<double>(i), 1, 2});
  }
  for (std::uint32_t i = 0; 3 * i + 2 < 100'000; ++i) {
    mesh.triangles.push_back({3 * i + 2, 3 * i, 3 * i + 1});
  }
  const Mesh back = read_three_ds_back(mesh);
  expect_same_corners(back, mesh);
  ASSERT_EQ(back.parts.size(), 2U);
  EXPECT_EQ(back.parts[0].count, 65'535U / 3);
  EXPECT_EQ(back.vertices.size(), mesh.triangles.size() * 3);

  // 65,534 vertices, of which the next triangle adds one, and the one after that another.
  mesh.triangles.clear();
  for (std::uint32_t i = 0; i < 65'534; i += 2) {
    mesh.triangles.push_back({i, i + 1, 0});
  }
  mesh.triangles.push_back({70'000, 70'000, 1});
  mesh.triangles.push_back({70'000, 2, 1});
  mesh.triangles.push_back({70'001, 2, 1});
  const Mesh full = read_three_ds_back(mesh);
  expect_same_corners(full, mesh);
  ASSERT_EQ(full.parts.size(), 2U);
  EXPECT_EQ(full.parts[1].count, 1U);
  EXPECT_EQ(full.vertices.size(), 65'535U + 3);
}

TEST(ThreeDsWriter, SplitsLargeMeshesOfManySharedVertices) {
  Rng rng(3);
  const Mesh mesh = scattered(rng, 90'000, 200'000);
  const Mesh back = read_three_ds_back(mesh);
  expect_same_corners(back, mesh);
  EXPECT_GT(back.parts.size(), 4U);
}

TEST(ThreeDsWriter, MakesAnObjectOfEachRunOfAPart) {
  const Mesh back = read_three_ds_back(with_parts({{"car", Part::kNoParent, 1, 4},
                                                   {"wheel", 0, 2, 2},
                                                   {"empty", Part::kNoParent, 3, 0},
                                                   {"", Part::kNoParent, 0, 1}},
                                                  6));
  const std::vector<Part> expected = {{"object", Part::kNoParent, 0, 1},
                                      {"car", Part::kNoParent, 1, 1},
                                      {"wheel", Part::kNoParent, 2, 2},
                                      {"car_2", Part::kNoParent, 4, 1},
                                      {"object_2", Part::kNoParent, 5, 1}};
  EXPECT_EQ(back.parts, expected);
}

TEST(ThreeDsWriter, CutsNamesAndKeepsThemApart) {
  const Mesh back = read_three_ds_back(with_parts({{"tower block 1", Part::kNoParent, 0, 1},
                                                   {"tower block 2", Part::kNoParent, 1, 1},
                                                   {"tower bl_3", Part::kNoParent, 2, 1},
                                                   {"tower block 3", Part::kNoParent, 3, 1},
                                                   {"a\tb\xc3\xa4~", Part::kNoParent, 4, 1},
                                                   {std::string("x\0y", 3), Part::kNoParent, 5, 1}},
                                                  6));
  const std::vector<std::string> expected = {"tower bloc", "tower bl_2", "tower bl_3",
                                             "tower bl_4", "a_b__~",     "x_y"};
  EXPECT_EQ(names_of(back), expected);
}

TEST(ThreeDsWriter, FindsDifferentNamesForManyPartsOfOneName) {
  constexpr std::uint32_t kParts = 3000;
  std::vector<Part> parts;
  for (std::uint32_t i = 0; i < kParts; ++i) {
    parts.push_back({"long building", Part::kNoParent, i, 1});
  }
  const std::vector<std::string> names = names_of(read_three_ds_back(with_parts(parts, kParts)));
  ASSERT_EQ(names.size(), kParts);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), kParts);
  EXPECT_EQ(names[1], "long bui_2");
  EXPECT_EQ(names[9], "long bu_10");
  EXPECT_EQ(names[kParts - 1], "long _3000");
}

TEST(ThreeDsWriter, WritesNoObjectForAMeshWithoutTriangles) {
  const Mesh mesh = with_parts({}, 0);
  EXPECT_TRUE(read_text(as_three_ds(mesh), "out.3ds", {.allow_empty = true}).triangles.empty());
}

TEST(ThreeDsWriter, RefusesWhatAFloatCannotHold) {
  Mesh mesh = with_parts({}, 1);
  mesh.vertices[2].y = -1e39;
  expect_refused([&] { static_cast<void>(as_three_ds(mesh)); }, ErrorKind::out_of_range,
                 "out: vertex 2 has a coordinate that a float cannot hold; write PLY");
  mesh.vertices[2].y = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { static_cast<void>(as_three_ds(mesh)); }, ErrorKind::not_finite,
                 "triangle 0: y of a corner is not a finite number");
  mesh.vertices[2].y = std::numeric_limits<float>::max();
  expect_same_corners(read_three_ds_back(mesh), mesh);
  mesh.vertices[2].y = 1e-320;  // too small for a float: rounds to zero
  EXPECT_EQ(read_three_ds_back(mesh).vertices[2].y, 0);
}

TEST(ThreeDsWriter, StopsWhenRequestedAndTellsProgress) {
  Rng rng(5);
  const Mesh mesh = scattered(rng, 1000, 140'000);
  std::stop_source stop;
  std::vector<double> shares;
  const auto progress = [&](double share) {
    shares.push_back(share);
    if (share > 0 && share < 1) {
      stop.request_stop();
    }
  };
  expect_refused(
      [&] {
        static_cast<void>(as_three_ds(mesh, {.stop = stop.get_token(), .progress = progress}));
      },
      ErrorKind::cancelled, "stopped");
  EXPECT_GT(shares.back(), 0);
  EXPECT_LT(shares.back(), 1);
}

}  // namespace
}  // namespace soms::test

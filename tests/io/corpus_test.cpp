// Whole folders of files: one mesh in every encoding, hard geometry, and the models of others.
#include "soms/base/error.h"
#include "soms/geometry/mesh.h"
#include "soms/io/read_mesh.h"

#include "tests/io/files.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace soms::test {
namespace {

using Corners = std::array<double, 9>;

Corners corners_of(const Triangle& t) {
  return {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
}

/// The same triangle beginning at its least corner.
Corners turned(const Corners& t) {
  Corners least = t;
  for (const std::size_t shift : {std::size_t{3}, std::size_t{6}}) {
    Corners other{};
    for (std::size_t i = 0; i < 9; ++i) {
      other[i] = t[(i + shift) % 9];
    }
    least = std::min(least, other);
  }
  return least;
}

/// The corners of a file in the frame of expected.csv, by the names of FORMATS.csv: turned to z up,
/// in meters. Its coordinates are multiples of 1/64, which transforms may miss by 1e-6.
Corners in_frame(const std::string& frame, Corners t) {
  for (std::size_t i = 0; i < 9; i += 3) {
    const Vec3 p{t[i], t[i + 1], t[i + 2]};
    if (frame == "yup") {
      t[i + 1] = -p.z;
      t[i + 2] = p.y;
    } else if (frame == "xup") {
      t[i] = -p.y;
      t[i + 1] = -p.z;
      t[i + 2] = p.x;
    }
  }
  if (frame == "unit0.01" || frame == "world") {
    for (double& c : t) {
      const double meters = frame == "world" ? c : c * 0.01;
      c = std::round(64 * meters) / 64;
      EXPECT_NEAR(c, meters, 1e-6);
    }
  }
  return t;
}

std::vector<Corners> expected_triangles() {
  std::vector<Corners> triangles;
  for (const std::vector<std::string>& row : read_csv(test::data("formats/expected.csv"))) {
    Corners corners{};
    for (std::size_t i = 0; i < 9; ++i) {
      corners[i] = std::stod(row.at(i));
    }
    triangles.push_back(turned(corners));
  }
  return triangles;
}

TEST(Corpus, OneMeshInEveryEncodingIsReadToTheSameTriangles) {
  const std::vector<Corners> expected = expected_triangles();
  ASSERT_EQ(expected.size(), 114U);
  std::map<std::string, int> tried;
  for (const auto& row : rows_of("formats/FORMATS.csv", 4)) {
    if (!is_read(row[0])) {
      continue;
    }
    SCOPED_TRACE(row[0]);
    ++tried[row[0].substr(row[0].size() - 3)];
    const Mesh mesh = read_mesh(test::data("formats/" + row[0]));
    std::vector<Corners> found;
    for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
      found.push_back(turned(in_frame(row[2], corners_of(mesh.triangle(i)))));
    }
    std::vector<Corners> wanted = expected;
    if (row[3] != "same") {
      std::sort(found.begin(), found.end());
      std::sort(wanted.begin(), wanted.end());
    }
    EXPECT_EQ(found, wanted);
  }
  EXPECT_EQ(tried, (std::map<std::string, int>{{"ply", 30},
                                               {"obj", 13},
                                               {"stl", 10},
                                               {"off", 9},
                                               {"3ds", 4},
                                               {"dae", 12},
                                               {"glb", 7},
                                               {"ltf", 10},
                                               {"son", 2},
                                               {"3dm", 1},
                                               {"mpt", 1},
                                               {"onl", 1}}));
}

TEST(Corpus, HardGeometryIsReadWhole) {
  int tried = 0;
  for (const auto& row : rows_of("nasty/EXPECTED.csv", 3)) {
    SCOPED_TRACE(row[0]);
    ++tried;
    const auto read = [&] {
      return read_mesh(test::data("nasty/" + row[0]), {.allow_empty = true});
    };
    if (row[0] == "sphere_huge_1e200.ply") {
      expect_refused([&] { static_cast<void>(read()); }, ErrorKind::out_of_range, "byte 242");
      continue;
    }
    const Mesh mesh = read();
    EXPECT_EQ(std::to_string(mesh.vertices.size()), row[1]);
    EXPECT_EQ(std::to_string(mesh.triangles.size()), row[2]);
    EXPECT_NO_THROW(check(mesh));
  }
  EXPECT_EQ(tried, 47);
}

TEST(Corpus, ModelsOfOthersHaveTheirCountsAndBounds) {
  SOMS_NEEDS_OUTSIDE_DATA("90 models of COUNTS.csv");
  int tried = 0;
  for (const auto& row : read_csv(*outside_data("COUNTS.csv"))) {
    if (!is_read(row[0])) {
      continue;
    }
    SCOPED_TRACE(row[0]);
    ++tried;
    const Mesh mesh = read_mesh(*outside_data(row[0]), {.allow_empty = true});
    EXPECT_EQ(std::to_string(mesh.triangles.size()), row[1]);
    // Vertices that no triangle uses count too, as stored in the file.
    EXPECT_EQ(std::to_string(mesh.vertices.size()), row[2]);
    const Box box = bounds(mesh);
    for (std::size_t axis = 0; axis < 3 && !mesh.triangles.empty(); ++axis) {
      // COUNTS.csv holds nine digits, and what a program made of transforms in float.
      const double lower = std::stod(row[3 + axis]);
      const double upper = std::stod(row[6 + axis]);
      const double rounded = row[0].ends_with(".glb") ? 1e-6 * (upper - lower) : 0;
      EXPECT_LE(std::abs(box.lower[axis] - lower), rounded + 1e-8 * std::abs(lower));
      EXPECT_LE(std::abs(box.upper[axis] - upper), rounded + 1e-8 * std::abs(upper));
    }
    EXPECT_NO_THROW(check(mesh));
  }
  EXPECT_EQ(tried, 90);
}

}  // namespace
}  // namespace soms::test

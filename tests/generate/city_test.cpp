#include "soms/generate/city.h"

#include "soms/base/error.h"

#include "tests/generate/closed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace soms {
namespace {

CityOptions options(std::uint64_t triangles, double size = 4000, std::uint64_t seed = 1) {
  return {triangles, size, seed};
}

CityOptions paved(std::uint64_t triangles, std::uint64_t seed = 1) {
  return {triangles, city_size(triangles), seed, CityStreets::paved};
}

const Part& part_named(const Mesh& mesh, const std::string& name) {
  for (const Part& part : mesh.parts) {
    if (part.name == name) {
      return part;
    }
  }
  throw std::out_of_range(name);
}

std::string refusal(const CityOptions& bad) {
  try {
    (void)generate_city(bad);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return "accepted";
}

TEST(City, HasExactlyTheCountRequestedFor) {
  for (std::uint64_t n = 1000; n < 1040; ++n) {
    EXPECT_EQ(generate_city(options(n)).mesh.triangles.size(), n);
  }
  for (const std::uint64_t n : {5'672U, 5'673U, 9'999U, 31'337U, 100'000U, 100'003U, 1'000'000U}) {
    EXPECT_EQ(generate_city(options(n)).mesh.triangles.size(), n);
  }
  for (const double size : {200.0, 333.3, 1000.0, 20'000.0}) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      EXPECT_EQ(generate_city(options(1000, size, seed)).mesh.triangles.size(), 1000U);
      EXPECT_EQ(generate_city(options(7001, size, seed)).mesh.triangles.size(), 7001U);
    }
  }
}

TEST(City, IsTheSameBitsEverywhereAndDiffersBySeed) {
  EXPECT_EQ(corner_hash(generate_city(options(5672)).mesh), 7359828011409262935ULL);
  EXPECT_EQ(corner_hash(generate_city(options(100'000)).mesh), 8104844945862641158ULL);
  EXPECT_EQ(generate_city(options(5672)).mesh, generate_city(options(5672)).mesh);
  EXPECT_NE(corner_hash(generate_city(options(5672)).mesh),
            corner_hash(generate_city(options(5672, 4000, 2)).mesh));
}

TEST(City, IsSoundAndItsPartsCoverAllTriangles) {
  for (const std::uint64_t n : {1'000U, 5'672U, 100'000U}) {
    const Mesh mesh = generate_city(options(n)).mesh;
    EXPECT_NO_THROW(check(mesh));
    std::uint32_t next = 0;
    std::vector<std::uint32_t> below(mesh.parts.size(), 0);
    std::set<std::string> names;
    for (const Part& part : mesh.parts) {
      EXPECT_TRUE(names.insert(part.name).second) << part.name;
      EXPECT_GT(part.count, 0U) << part.name;
      if (part.parent == Part::kNoParent) {
        EXPECT_EQ(part.first, next) << part.name;
        next += part.count;
      } else {
        below[part.parent] += part.count;
      }
    }
    EXPECT_EQ(next, n);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
      EXPECT_TRUE(below[i] == 0 || below[i] == mesh.parts[i].count) << mesh.parts[i].name;
    }
    for (const char* name : {"terrain", "roads", "buildings", "furniture"}) {
      EXPECT_NO_THROW((void)part_named(mesh, name));
    }
  }
}

TEST(City, HasNoTriangleWithoutAreaAndSizesOverSixDecades) {
  const Mesh mesh = generate_city(options(1'000'000)).mesh;
  EXPECT_EQ(test::flat_triangles(mesh), 0U);
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  std::size_t small = 0;
  std::size_t large = 0;
  for (TriangleId i = 0; i < mesh.triangles.size(); ++i) {
    const double area = test::area(mesh.triangle(i));
    least = std::min(least, area);
    most = std::max(most, area);
    small += area < 0.1 ? 1U : 0U;
    large += area > 10 ? 1U : 0U;
  }
  EXPECT_GT(least, 1e-4);
  EXPECT_LT(least, 2e-3);
  EXPECT_GT(most, 1000);
  // Neither end of the scale is an exception.
  EXPECT_GT(small, 200'000U);
  EXPECT_GT(large, 200'000U);
}

TEST(City, FillsItsSquare) {
  for (const double size : {200.0, 4000.0}) {
    const City city = generate_city(options(10'000, size));
    const Box box = bounds(test::part_mesh(city.mesh, part_named(city.mesh, "roads")));
    EXPECT_NEAR(box.lower.x, -size / 2, 1e-9);
    EXPECT_NEAR(box.lower.y, -size / 2, 1e-9);
    EXPECT_NEAR(box.upper.x, size / 2, 1e-9);
    EXPECT_NEAR(box.upper.y, size / 2, 1e-9);
    EXPECT_NEAR(city.street_lines.front(), -size / 2 + city.street_width / 2, 1e-9);
    EXPECT_NEAR(city.street_lines.back(), size / 2 - city.street_width / 2, 1e-9);
  }
}

/// Barycentric height of a triangle over a point inside it.
Vec3 inside(const Triangle& t, double u, double v) {
  return (1 - u - v) * t.a + u * t.b + v * t.c;
}

TEST(City, GroundIsTheHeightOfRoadsAndTerrain) {
  for (const std::uint64_t n : {5'672U, 1'000'000U}) {
    const City city = generate_city(options(n));
    Rng rng(n);
    for (const char* name : {"roads", "terrain"}) {
      const Part& part = part_named(city.mesh, name);
      for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
        const double u = rng.unit();
        const double v = rng.uniform(0, 1 - u);
        const Vec3 p = inside(city.mesh.triangle(i), u, v);
        ASSERT_NEAR(city.ground(p.x, p.y), p.z, 1e-9) << name << ' ' << i;
      }
    }
  }
}

TEST(City, StreetsAreAtMostFivePercentSteepAndBlocksNoHigherThanTheirKerbs) {
  const City city = generate_city(options(1'000'000));
  const Part& roads = part_named(city.mesh, "roads");
  for (std::uint32_t i = roads.first; i < roads.first + roads.count; ++i) {
    const Triangle t = city.mesh.triangle(i);
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    EXPECT_LE(std::hypot(normal.x, normal.y), 0.05 * std::abs(normal.z));
    EXPECT_GT(normal.z, 0);
  }
  const double half = city.street_width / 2;
  for (std::size_t i = 0; i + 1 < city.street_lines.size(); ++i) {
    const double x = 0.5 * (city.street_lines[i] + city.street_lines[i + 1]);
    const double y = 0.5 * (city.street_lines[3] + city.street_lines[4]);
    const double west = city.ground(city.street_lines[i] + half, y);
    const double east = city.ground(city.street_lines[i + 1] - half, y);
    EXPECT_LT(city.ground(x, y), 0.5 * (west + east) - 0.1);
  }
}

TEST(City, LaneStaysFreeOfBuildingsAndFurniture) {
  const City city = generate_city(options(1'000'000));
  const auto between_lines = [&](double c) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double line : city.street_lines) {
      nearest = std::min(nearest, std::abs(c - line));
    }
    return nearest;
  };
  for (const char* name : {"buildings", "furniture"}) {
    const Part& part = part_named(city.mesh, name);
    for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
      const Triangle t = city.mesh.triangle(i);
      for (const Vec3& v : {t.a, t.b, t.c}) {
        ASSERT_GT(std::min(between_lines(v.x), between_lines(v.y)), 4.7) << name << ' ' << i;
      }
    }
  }
}

TEST(City, ItsSquareGrowsWithItsTriangles) {
  EXPECT_EQ(city_size(1), 200);
  EXPECT_EQ(city_size(5'672), 200);
  EXPECT_EQ(city_size(20'000), 245);
  EXPECT_EQ(city_size(1'000'000), 1732);
  EXPECT_EQ(city_size(100'000'000), 17'321);
}

// A picture of one is a street between houses, not specks on a plain.
TEST(PavedCity, IsBuiltUp) {
  for (const std::uint64_t n : {3'000U, 20'000U, 100'000U}) {
    const City city = generate_city(paved(n));
    const Mesh& mesh = city.mesh;
    double roofs = 0;
    const Part& buildings = part_named(mesh, "buildings");
    for (std::uint32_t i = buildings.first; i < buildings.first + buildings.count; ++i) {
      const Triangle t = mesh.triangle(i);
      const Vec3 up = cross(t.b - t.a, t.c - t.a);
      roofs += std::max(0.0, 0.5 * up.z);
    }
    const double square = city.options.size * city.options.size;
    EXPECT_GT(roofs, 0.12 * square) << n;
    EXPECT_LT(square / static_cast<double>(n), 14) << n;
  }
}

TEST(PavedCity, HasItsCountNoFlatTriangleAndTheSameBits) {
  for (const std::uint64_t n : {1'000U, 1'001U, 3'000U, 5'672U, 20'000U, 20'001U, 250'000U}) {
    for (std::uint64_t seed = 1; seed < 4; ++seed) {
      const Mesh mesh = generate_city(paved(n, seed)).mesh;
      EXPECT_EQ(mesh.triangles.size(), n);
      EXPECT_NO_THROW(check(mesh));
      EXPECT_EQ(test::flat_triangles(mesh), 0U) << n;
    }
  }
  EXPECT_EQ(corner_hash(generate_city(paved(20'000)).mesh), 10552463780522818429ULL);
}

TEST(PavedCity, ItsSidewalksAndVehiclesAreClosed) {
  const Mesh mesh = generate_city(paved(20'000)).mesh;
  const auto closed = [&](const Part& part) {
    const Mesh one = test::part_mesh(mesh, part);
    return test::faulty_edges(one) == 0 && test::volume6(one) > 0;
  };
  EXPECT_TRUE(closed(part_named(mesh, "sidewalks")));
  std::size_t vehicles = 0;
  for (const Part& part : mesh.parts) {
    if (part.name.find("parked") == 0) {
      EXPECT_TRUE(closed(part)) << part.name;
      EXPECT_GT(part.count, 300U) << part.name;
      ++vehicles;
    }
  }
  EXPECT_GT(vehicles, 15U);
}

// What drives at the clearance of movers, 0.3 m, meets neither.
TEST(PavedCity, MarksLieOnTheStreetAndSidewalksAreAKerbHigher) {
  const City city = generate_city(paved(20'000));
  const Part& marks = part_named(city.mesh, "lane marks");
  for (std::uint32_t i = marks.first; i < marks.first + marks.count; ++i) {
    const Triangle t = city.mesh.triangle(i);
    for (const Vec3& p : {t.a, t.b, t.c}) {
      ASSERT_NEAR(p.z - city.ground(p.x, p.y), 0.01, 1e-9);
    }
  }
  const Part& walks = part_named(city.mesh, "sidewalks");
  for (std::uint32_t i = walks.first; i < walks.first + walks.count; ++i) {
    const Triangle t = city.mesh.triangle(i);
    const Vec3 p = inside(t, 0.3, 0.3);
    if (cross(t.b - t.a, t.c - t.a).z > 1e-9) {
      ASSERT_NEAR(p.z, city.ground(p.x, p.y), 1e-9) << i;
    }
  }
  const double middle = city.street_lines[1];
  EXPECT_NEAR(city.ground(middle + 8, 60) - city.ground(middle + 2, 60), 0.12, 1e-9);
}

TEST(PavedCity, HasNoPavementThatItCannotPay) {
  const Mesh small = generate_city({1'000, 4000, 1, CityStreets::paved}).mesh;
  EXPECT_THROW((void)part_named(small, "sidewalks"), std::out_of_range);
  EXPECT_THROW((void)part_named(small, "lane marks"), std::out_of_range);
  const Mesh bare = generate_city({20'000, 245, 1, CityStreets::bare}).mesh;
  EXPECT_THROW((void)part_named(bare, "sidewalks"), std::out_of_range);
}

TEST(City, NamesWhatIsOutOfRange) {
  EXPECT_EQ(refusal(options(3)), "city of 3 triangles; the least is 1000");
  EXPECT_EQ(refusal(options(999)), "city of 999 triangles; the least is 1000");
  EXPECT_EQ(refusal(options(std::uint64_t{1} << 31)),
            "city of 2147483648 triangles; the most is 100000000");
  for (const double size : {0.0, -1.0, 199.0, 1e6, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(refusal(options(1000, size)).find("200 to 100,000"), std::string::npos) << size;
  }
}

}  // namespace
}  // namespace soms

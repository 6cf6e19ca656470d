#include "soms/generate/statue.h"

#include "soms/base/error.h"

#include "tests/generate/closed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::faulty_edges;
using test::flat_triangles;
using test::volume6;

std::string statue_error(std::uint64_t triangles) {
  try {
    static_cast<void>(generate_statue(triangles));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    return error.what();
  }
  return {};
}

TEST(Statue, HasExactCountAndIsClosedForEveryEvenCount) {
  for (std::uint64_t n = 8; n <= 400; n += 2) {
    const Mesh statue = generate_statue(n);
    EXPECT_EQ(statue.triangles.size(), n);
    EXPECT_EQ(statue.vertices.size(), n / 2 + 2) << "no holes through it";
    EXPECT_EQ(faulty_edges(statue), 0U) << n;
    EXPECT_EQ(flat_triangles(statue), 0U) << n;
    EXPECT_GT(volume6(statue), 0) << n;
  }
  for (const std::uint64_t n : {948U, 1416U, 20'000U, 300'000U}) {
    const Mesh statue = generate_statue(n);
    EXPECT_EQ(statue.triangles.size(), n);
    EXPECT_EQ(flat_triangles(statue), 0U) << n;
    EXPECT_NO_THROW(check(statue));
  }
  EXPECT_EQ(faulty_edges(generate_statue(20'000)), 0U);
}

TEST(Statue, IsOneHighAndStandsOnTheGround) {
  for (const std::uint64_t n : {8U, 948U, 10'000U}) {
    const Box box = bounds(generate_statue(n));
    EXPECT_EQ(box.lower.z, 0);
    EXPECT_EQ(box.upper.z, 1);
    EXPECT_LT(box.extent().x, 0.85);
    EXPECT_LT(box.extent().y, 0.55);
  }
}

TEST(Statue, HasTrianglesOfUnlikeSizeThatAllGetSmaller) {
  const auto areas = [](std::uint64_t n) {
    const Mesh statue = generate_statue(n);
    std::vector<double> sizes;
    for (TriangleId i = 0; i < n; ++i) {
      sizes.push_back(test::area(statue.triangle(i)));
    }
    std::sort(sizes.begin(), sizes.end());
    return sizes;
  };
  const std::vector<double> few = areas(948);
  EXPECT_GT(few[900], 8 * few[47]) << "95 % and 5 %";
  const std::vector<double> many = areas(94'800);
  EXPECT_LT(many.back(), few.back() / 30);
  EXPECT_LT(many[47'400], few[474] / 70);
}

TEST(Statue, NamesTheLeastAndTheNearestCounts) {
  EXPECT_EQ(statue_error(6), "statue of 6 triangles; the least is 8");
  EXPECT_NE(statue_error(949).find("948 or 950"), std::string::npos);
  EXPECT_NE(statue_error(std::uint64_t{1} << 31).find("the most is"), std::string::npos);
}

TEST(Statue, IsTheSameBitsEverywhere) {
  EXPECT_EQ(corner_hash(generate_statue(948)), 9805234115812847458ULL);
  EXPECT_EQ(corner_hash(generate_statue(1416)), 5444586111585454737ULL);
}

}  // namespace
}  // namespace soms

// Faults of soms itself where products or squares of small lengths underflow: one test a fault. An
// id is never used again.
#include "soms/base/random.h"
#include "soms/query/body.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"
#include "tests/support/truth/query_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

Vec3 point_of_r125(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

// A mesh without extent keeps the unit of usual bodies. Beside it a body of 2^-74 was seen in that
// unit, in which squares of gaps are below the least float: a lower bound was rounded up.
TEST(Regression, R124ATinyBodyBesideAPointHasItsNearestTriangle) {
  for (int exponent = -76; exponent <= -68; ++exponent) {
    const double size = std::ldexp(1.0, exponent);
    test::for_each_case("r125/" + std::to_string(exponent), 50, [&](Rng& rng) {
      std::vector<Triangle> triangles;
      for (std::uint64_t i = 0, count = 1 + rng.below(30); i < count; ++i) {
        const Vec3 at = point_of_r125(rng, size);
        triangles.push_back({at + point_of_r125(rng, size / 10), at + point_of_r125(rng, size / 10),
                             at + point_of_r125(rng, size / 10)});
      }
      const Vec3 point = point_of_r125(rng, 2 * size);
      const Body tiny(test::soup_body(triangles));
      ASSERT_EQ(test::first_fault(tiny, Body(test::soup_body({{point, point, point}}))), "");
    });
  }
}

}  // namespace
}  // namespace soms

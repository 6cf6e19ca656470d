#include "soms/query/signed_closest.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/query/print.h"
#include "soms/query/reference/closest.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <chrono>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace soms {
namespace {

/// The box [-1, 1]^3 within one of twice the size: a shell with a void.
Mesh shell() {
  return test::joined(test::box_body({-2, -2, -2}, {2, 2, 2}),
                      test::box_body({-1, -1, -1}, {1, 1, 1}));
}

TEST(SignedClosest, IsBelowZeroInsideAndZeroOnTheSurface) {
  const ClosedBody body{Body(shell())};
  for (const auto& [x, side, signed_distance] : {std::tuple{3.0, Side::outside, 1.0},
                                                 {2.0, Side::on, 0.0},
                                                 {1.75, Side::inside, -0.25},
                                                 {1.0, Side::on, 0.0},
                                                 {0.75, Side::outside, 0.25}}) {
    const SignedClosest answer = closest(body, {x, 0.125, 0.25});
    EXPECT_EQ(answer.side, side) << x;
    EXPECT_EQ(answer.distance(), (Bracket{signed_distance, signed_distance})) << x;
  }
}

TEST(SignedClosest, AgreesWithItsPartsAndItsTwin) {
  const ClosedBody body{Body(generate_knot(400)), {.threads = 1}};
  std::vector<Vec3> points;
  const std::span<const Vec3> vertices = body.body().shape.mesh().vertices;
  test::for_each_case("query/signed-closest", 60, [&](Rng& rng) {
    const Vec3 off{rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1), rng.uniform(-0.1, 0.1)};
    points.push_back(vertices[rng.below(vertices.size())] + off);
  });
  points.push_back(vertices[0]);
  const SignedClosestBatch batch = closest(body, points, {}, {.threads = 2});
  const ClosestBatch distances = closest(body.body(), points);
  const ContainsBatch sides = contains(body, points);
  ASSERT_EQ(batch.size(), points.size());
  int inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SignedClosest single = closest(body, points[i]);
    EXPECT_EQ(batch.at(i), single) << i;
    EXPECT_EQ(single.side, sides.side[i]) << i;
    const Bracket d = single.distance();
    const Bracket size = d.upper <= 0 ? Bracket{-d.upper, -d.lower} : d;
    EXPECT_EQ(size, distances.at(i).distance) << i;
    EXPECT_EQ(d.upper < 0, single.side == Side::inside) << i;
    Cost both = distances.costs[i];
    both += sides.costs[i];
    EXPECT_EQ(single.closest.cost, both) << i;
    const SignedClosest twin = reference::closest_by_brute_force(body, points[i]);
    EXPECT_EQ(twin.side, single.side) << i;
    EXPECT_EQ(twin.distance(), d) << i;
    EXPECT_EQ(twin.closest.triangle, single.closest.triangle) << i;
    inside += single.side == Side::inside ? 1 : 0;
  }
  EXPECT_GT(inside, 3);
  EXPECT_EQ(batch.side.back(), Side::on);
}

TEST(SignedClosest, KnowsTheSideOfPointsThatAreFarther) {
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  const ClosedBody body{Body(test::box_body({-8, -8, -8}, {8, 8, 8}))};
  const SignedClosest deep = closest(body, {0, 0, 0}, {.at_most = 1});
  EXPECT_TRUE(deep.closest.farther);
  EXPECT_EQ(deep.distance(), (Bracket{-kEndless, -1}));
  EXPECT_EQ(closest(body, {20, 0, 0}, {.at_most = 1}).distance(), (Bracket{1, kEndless}));
  EXPECT_EQ(closest(ClosedBody{Body(Mesh{})}, {0, 0, 0}).distance(), (Bracket{kEndless, kEndless}));
}

TEST(SignedClosest, HoldsBothSignsWhereTimeRanOut) {
  const ClosedBody body{Body(test::box_body({-1, -1, -1}, {1, 1, 1}))};
  const SignedClosest cut =
      closest(body, {0, 0, 0}, {}, {.deadline = std::chrono::steady_clock::time_point()});
  EXPECT_EQ(cut.side, Side::undecided);
  EXPECT_EQ(cut.closest.coverage, Coverage::cut);
  EXPECT_EQ(cut.distance().lower, -cut.distance().upper);
}

TEST(SignedClosest, NamesThePointAtFault) {
  const ClosedBody body{Body(test::box_body({-1, -1, -1}, {1, 1, 1}))};
  const std::vector<Vec3> points{{0, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}};
  try {
    static_cast<void>(closest(body, points));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_finite);
    EXPECT_EQ(error.place().rfind("point 1", 0), 0U) << error.place();
  }
}

TEST(SignedClosest, IsAValueThatPrints) {
  const ClosedBody body{Body(test::box_body({-1, -1, -1}, {1, 1, 1}))};
  std::ostringstream text;
  text << closest(body, {0, 0, 0});
  EXPECT_NE(text.str().find("side: inside"), std::string::npos) << text.str();
}

}  // namespace
}  // namespace soms

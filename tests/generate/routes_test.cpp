#include "soms/generate/routes.h"

#include "soms/generate/shapes.h"
#include "soms/query/reference/overlap.h"

#include "tests/generate/closed.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace soms {
namespace {

constexpr double kPi = 3.141592653589793;

void expect_rigid(const Pose& pose) {
  EXPECT_NO_THROW(check(pose));
}

Vec3 forward(const Pose& pose) {
  return {pose.m[0], pose.m[4], pose.m[8]};
}

/// Times from `begin` to before `end`.
std::vector<double> times(double begin, double end, double step) {
  std::vector<double> all;
  for (int i = 0; begin + i * step < end; ++i) {
    all.push_back(begin + i * step);
  }
  return all;
}

double distance(const Vec3& a, const Vec3& b) {
  return std::sqrt(dot(b - a, b - a));
}

TEST(Route, GoesRoundAtConstantSpeed) {
  const Route square{{{0, 0, 1}, {10, 0, 1}, {10, 10, 1}, {0, 10, 1}}, true, 5, 2};
  EXPECT_EQ(square.length(), 40);
  EXPECT_EQ(square.at(0).shift(), (Vec3{5, 0, 1}));
  EXPECT_EQ(square.at(5).shift(), (Vec3{10, 5, 1}));
  EXPECT_EQ(square.at(20).shift(), (Vec3{5, 0, 1}));
  EXPECT_EQ(square.at(-5).shift(), (Vec3{0, 5, 1}));
  EXPECT_NEAR(forward(square.at(5)).y, 1, 1e-15);
  EXPECT_NEAR(forward(square.at(17)).y, -1, 1e-15);
}

TEST(Route, OpenRouteIsDrivenToAndFro) {
  const Route line{{{0, 0, 0}, {10, 0, 0}}, false, 0, 1};
  EXPECT_EQ(line.at(4).shift(), (Vec3{4, 0, 0}));
  EXPECT_EQ(forward(line.at(4)).x, 1);
  EXPECT_EQ(line.at(14).shift(), (Vec3{6, 0, 0}));
  EXPECT_EQ(forward(line.at(14)).x, -1);
  EXPECT_EQ(line.at(24).shift(), (Vec3{4, 0, 0}));
}

TEST(Route, StandsStillWithoutLength) {
  EXPECT_EQ(Route{}.at(3), Pose{});
  const Route point{{{1, 2, 3}}, false, 4, 5};
  EXPECT_EQ(point.at(7), Pose::translation(1, 2, 3));
  const Route twice{{{1, 2, 3}, {1, 2, 3}}, true, 4, 5};
  EXPECT_EQ(twice.at(7), Pose::translation(1, 2, 3));
  const Route upward{{{0, 0, 0}, {0, 0, 9}}, false, 0, 1};
  EXPECT_EQ(upward.at(3), Pose::translation(0, 0, 3));
}

TEST(Route, AxlesStayOnTheRouteAndSmoothTheTurn) {
  const Route corner{{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, false, 0, 1, 2};
  double last = 0;
  for (const double t : times(1, 19, 0.05)) {
    const Pose pose = corner.at(t);
    expect_rigid(pose);
    const double yaw = std::atan2(pose.m[4], pose.m[0]);
    EXPECT_LT(std::abs(yaw - last), 0.15) << t;
    last = yaw;
  }
  EXPECT_NEAR(last, kPi / 2, 1e-12);
}

TEST(Route, MarksChangeNoPose) {
  const City city = generate_city({5672});
  Route measured = street_route(city, 3, 12, 0.12);
  Route plain = measured;
  plain.marks.clear();
  for (const double t : times(0, 100, 7.3)) {
    EXPECT_EQ(measured.at(t), plain.at(t));
  }
  EXPECT_EQ(measured.length(), plain.length());
}

TEST(Route, IsFoundFromAnyLine) {
  const City city = generate_city({5672});
  test::for_each_case("routes/line", 20, [&](Rng& rng) {
    Route route = street_route(city, rng.below(100), rng.below(2) ? 1.4 : 13, 0.12);
    route.closed = rng.below(2) == 0;
    route.base = rng.below(2) == 0 ? 0 : route.base;
    route.measure();
    std::size_t line = rng.below(3) == 0 ? ~std::size_t{0} : rng.below(300);
    double seconds = rng.uniform(-100, 1000);
    for (int k = 0; k < 200; ++k) {
      ASSERT_EQ(route.at(seconds, line), route.at(seconds));
      ASSERT_LT(line, route.marks.size());
      seconds += k % 50 == 0 ? rng.uniform(-100, 100) : 0.1;
    }
  });
}

/// Least height of any vertex of a mover above the ground over the first `seconds` of its route.
double least_clearance(const City& city, const Mesh& mover, const Route& route, double seconds) {
  double least = std::numeric_limits<double>::infinity();
  for (const double t : times(0, seconds, 0.23)) {
    const Pose pose = route.at(t);
    for (const Vec3& v : mover.vertices) {
      const Vec3 p = pose.apply(v);
      least = std::min(least, p.z - city.ground(p.x, p.y));
    }
  }
  return least;
}

TEST(StreetRoute, CarAndPersonKeepClearOfTheGround) {
  const Mesh car = generate_mover(MoverKind::car);
  const Mesh person = generate_mover(MoverKind::person);
  for (const std::uint64_t n : {5'672U, 200'000U}) {
    const City city = generate_city({n});
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const double driven = least_clearance(city, car, street_route(city, seed, 14, 0.12), 60);
      EXPECT_GT(driven, 0.06) << n << ' ' << seed;
      EXPECT_LT(driven, 0.13) << n << ' ' << seed;
      const double walked = least_clearance(city, person, street_route(city, seed, 1.4, 0.1), 60);
      EXPECT_GT(walked, 0.05) << n << ' ' << seed;
    }
  }
}

TEST(StreetRoute, CarNeverTouchesRoadsOrTerrainByBruteForce) {
  const City city = generate_city({5672});
  const Mesh car = generate_mover(MoverKind::car);
  Mesh ground;
  ground.vertices = city.mesh.vertices;
  // Terrain and roads come first.
  ground.triangles.assign(
      city.mesh.triangles.begin(),
      city.mesh.triangles.begin() + city.mesh.parts[0].count + city.mesh.parts[1].count);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Route route = street_route(city, seed, 14, 0.12);
    for (const double t : times(0, 120, 2.7)) {
      ASSERT_FALSE(reference::overlap(car, route.at(t), ground, {}).any) << seed << ' ' << t;
    }
  }
}

TEST(StreetRoute, StaysInItsLaneAndTurnsSmoothly) {
  const City city = generate_city({200'000});
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const double speed : {1.3, 13.0}) {
      const Route route = street_route(city, seed, speed, 0.12);
      EXPECT_TRUE(route.closed);
      Pose last = route.at(-0.02);
      for (const double t : times(0, 40, 0.02)) {
        const Pose pose = route.at(t);
        const Vec3 p = pose.shift();
        ASSERT_NEAR(distance(p, last.shift()), 0.02 * speed, 0.012 * speed) << seed << ' ' << t;
        // A turn of 5 m radius at this speed, and some room.
        ASSERT_GT(dot(forward(pose), forward(last)), 1 - 0.02) << seed << ' ' << t;
        double nearest = std::numeric_limits<double>::infinity();
        for (const double line : city.street_lines) {
          nearest = std::min({nearest, std::abs(p.x - line), std::abs(p.y - line)});
        }
        ASSERT_LT(nearest, city.street_width / 2) << seed << ' ' << t;
        last = pose;
      }
      expect_rigid(last);
    }
  }
}

TEST(StreetRoute, IsDeterministicAndSpreadsItsMovers) {
  const City city = generate_city({200'000});
  EXPECT_EQ(street_route(city, 9, 12, 0.1).at(3.5), street_route(city, 9, 12, 0.1).at(3.5));
  std::size_t near = 0;
  for (std::uint64_t a = 0; a < 60; ++a) {
    for (std::uint64_t b = 0; b < a; ++b) {
      near += distance(street_route(city, a, 12, 0.1).at(0).shift(),
                       street_route(city, b, 12, 0.1).at(0).shift()) < 50
                  ? 1U
                  : 0U;
    }
  }
  EXPECT_LT(near, 20U);  // of 1,770 pairs
}

TEST(FlightRoute, StaysBetweenItsHeightsAboveTheStreets) {
  const City city = generate_city({200'000});
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Route route = flight_route(city, seed, 9, 5, 40);
    EXPECT_TRUE(route.closed);
    for (const double t : times(0, 60, 0.5)) {
      const Pose pose = route.at(t);
      expect_rigid(pose);
      const Vec3 p = pose.shift();
      const double height = p.z - city.ground(p.x, p.y);
      EXPECT_GT(height, 3) << seed << ' ' << t;
      EXPECT_LT(height, 43) << seed << ' ' << t;
    }
  }
}

TEST(StraightRoute, StartsWhereRequestedAndStaysInTheBox) {
  Box scene;
  scene.grow(Vec3{-50, -20, 0});
  scene.grow(Vec3{100, 80, 30});
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Route route = straight_route(scene, {10, 5, 2}, seed, 8);
    EXPECT_NEAR(distance(route.at(0).shift(), {10, 5, 2}), 0, 1e-9);
    for (const double t : times(0, 80, 1.7)) {
      const Pose pose = route.at(t);
      expect_rigid(pose);
      const Vec3 p = pose.shift();
      EXPECT_GT(p.x, -50 - 1e-9);
      EXPECT_LT(p.x, 100 + 1e-9);
      EXPECT_GT(p.y, -20 - 1e-9);
      EXPECT_LT(p.y, 80 + 1e-9);
      EXPECT_NEAR(p.z, 2, 1e-9);
    }
    EXPECT_GT(route.length(), 50);
  }
}

TEST(StraightRoute, StandsStillInAnEmptyScene) {
  const Route route = straight_route({}, {1, 2, 3}, 1, 8);
  EXPECT_EQ(route.at(5), Pose::translation(1, 2, 3));
}

}  // namespace
}  // namespace soms

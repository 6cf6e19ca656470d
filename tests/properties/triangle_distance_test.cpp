// What must hold of least distances of triangles whatever the triangles are.
#include "soms/geometry/triangle_distance.h"

#include "soms/geometry/detail/distance_ends.h"
#include "soms/geometry/detail/pair_distance.h"
#include "soms/geometry/triangle_overlap.h"

#include "tests/properties/near_touch.h"
#include "tests/properties/property.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

namespace soms {
namespace {

using detail::PairDistance;
using Pair = std::pair<Triangle, Triangle>;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Small whole numbers, thirds and ulps beside them: where features tie, and nearly tie.
rc::Gen<double> coordinate() {
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(-6, 7), rc::gen::inRange(0, 8), rc::gen::inRange(-2, 3)),
      [](const std::tuple<int, int, int>& parts) {
        const auto [whole, kind, ulps] = parts;
        double x = kind == 0 ? whole / 3.0 : whole;
        for (int i = 0; kind == 1 && i < std::abs(ulps); ++i) {
          x = std::nextafter(x, ulps > 0 ? kUnbounded : -kUnbounded);
        }
        return x;
      });
}

rc::Gen<Vec3> vertex() {
  return rc::gen::map(rc::gen::tuple(coordinate(), coordinate(), coordinate()), [](const auto& t) {
    return Vec3{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
}

rc::Gen<Triangle> triangle() {
  return rc::gen::map(rc::gen::tuple(vertex(), vertex(), vertex()), [](const auto& t) {
    return Triangle{std::get<0>(t), std::get<1>(t), std::get<2>(t)};
  });
}

/// Any two, or two that nearly touch.
rc::Gen<Pair> pairs() {
  const auto loose = rc::gen::pair(triangle(), triangle());
  const auto near = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(), [](std::uint64_t seed) {
    Rng rng(seed);
    return test::nearly_touching(rng);
  });
  return rc::gen::weightedOneOf<Pair>({{2, loose}, {1, near}});
}

std::string text(const Triangle& t) {
  std::string out;
  for (const Vec3& v : {t.a, t.b, t.c}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<char, 32> digits{};
      std::snprintf(digits.data(), digits.size(), "%a ", v[axis]);
      out += digits.data();
    }
  }
  return out;
}

template <class Property>
void check_pairs(const std::string& name, Property property) {
  test::check_property(name, [&] {
    const Pair pair = *pairs();
    RC_LOG() << text(pair.first) << "\n" << text(pair.second) << "\n";
    property(pair.first, pair.second);
  });
}

Triangle scaled(const Triangle& t, double s) {
  return {t.a * s, t.b * s, t.c * s};
}

TEST(TriangleDistanceProperty, HasNoOrder) {
  check_pairs("no order", [](const Triangle& a, const Triangle& b) {
    const Bracket d = triangle_distance(a, b).distance;
    RC_ASSERT(triangle_distance(b, a).distance == d);
    RC_ASSERT(triangle_distance({a.b, a.c, a.a}, {b.c, b.b, b.a}).distance == d);
    RC_ASSERT(triangle_distance({a.a, a.c, a.b}, {b.b, b.a, b.c}).distance == d);
  });
}

TEST(TriangleDistanceProperty, ScalesByPowersOfTwo) {
  check_pairs("powers of two", [](const Triangle& a, const Triangle& b) {
    const Bracket d = triangle_distance(a, b).distance;
    const double factor = std::ldexp(1.0, *rc::gen::inRange(-900, 290));
    RC_PRE(scaled(scaled(a, factor), 1 / factor) == a &&
           scaled(scaled(b, factor), 1 / factor) == b);
    const Bracket found = triangle_distance(scaled(a, factor), scaled(b, factor)).distance;
    RC_ASSERT(found == (Bracket{d.lower * factor, d.upper * factor}));
  });
}

TEST(TriangleDistanceProperty, IsZeroWhereTheyOverlap) {
  check_pairs("zero", [](const Triangle& a, const Triangle& b) {
    const TriangleDistance d = triangle_distance(a, b);
    RC_ASSERT((d.distance.upper == 0) == triangles_overlap(a, b));
    RC_ASSERT(d.distance.upper > 0 || d.point_a == d.point_b);
  });
}

TEST(TriangleDistanceProperty, AgreesWithClearance) {
  check_pairs("clearance", [](const Triangle& a, const Triangle& b) {
    const Bracket d = triangle_distance(a, b).distance;
    RC_ASSERT(triangles_within(a, b, d.upper));
    RC_ASSERT(triangles_within(a, b, d.lower) == (d.lower == d.upper));
    RC_ASSERT(d.lower == 0 || !triangles_within(a, b, std::nextafter(d.lower, 0)));
  });
}

TEST(TriangleDistanceProperty, ComparesAsItMeasures) {
  check_pairs("comparison", [](const Triangle& a, const Triangle& b) {
    const Pair other = *pairs();
    PairDistance here(a, b);
    PairDistance there(other.first, other.second);
    const std::strong_ordering order = here.compare(there);
    RC_ASSERT((there.compare(here) == (0 <=> order)));
    const Bracket d = triangle_distance(a, b).distance;
    const Bracket e = triangle_distance(other.first, other.second).distance;
    if (d != e) {
      RC_ASSERT((order < 0) == (d.lower < e.lower || d.upper < e.upper));
      RC_ASSERT((order != 0));
    } else if (d.lower == d.upper) {
      RC_ASSERT((order == 0));
    }
    PairDistance exchanged({b.b, b.a, b.c}, {a.c, a.a, a.b});
    RC_ASSERT((here.compare(exchanged) == 0));
  });
}

TEST(TriangleDistanceProperty, BoundsHoldTheDistance) {
  check_pairs("bounds", [](const Triangle& a, const Triangle& b) {
    const PairDistance pair(a, b);
    const Bracket d = triangle_distance(a, b).distance;
    RC_ASSERT(pair.bounds().lower >= 0);
    RC_ASSERT(pair.bounds().lower <= d.lower);
    RC_ASSERT(pair.bounds().upper >= d.upper);
  });
}

// The distance of two points of theirs is at least the triangles'.
TEST(TriangleDistanceProperty, IsTheLeastOfAllPoints) {
  check_pairs("points", [](const Triangle& a, const Triangle& b) {
    const Bracket d = triangle_distance(a, b).distance;
    const auto some = [](const Triangle& t) {
      const double s = *rc::gen::inRange(0, 9) / 8.0;
      const double r = *rc::gen::inRange(0, 9) / 8.0 * (1 - s);
      return t.a + (t.b - t.a) * s + (t.c - t.a) * r;
    };
    const Vec3 between = some(a) - some(b);
    RC_ASSERT(std::sqrt(dot(between, between)) >= d.lower - 1e-13);
    // A bound in extended precision that is the distance itself as a rule.
    RC_ASSERT(d.upper == 0 || test::distance_bound(a, b) >= d.lower * (1 - 1e-12) - 1e-17);
  });
}

/// How far the lower and the upper bound are on the wrong side of the distance, in roundings of the
/// largest difference of coordinates: above 0 a bound is wrong.
std::array<double, 2> excess(const Triangle& a, const Triangle& b) {
  const Bracket d = triangle_distance(a, b).distance;
  const PairDistance pair(a, b);
  const double unit = 0x1p-53 * detail::AboutCorner<double>(a, b).reach;
  return {(pair.bounds().lower - d.upper) / unit, (d.lower - pair.bounds().upper) / unit};
}

// Climbs on the excess, from many starts.
TEST(TriangleDistanceProperty, BoundsWithstandASearch) {
  std::array<double, 2> most{-kUnbounded, -kUnbounded};
  test::for_each_case("triangle-distance/search", 24, [&](Rng& rng) {
    const std::size_t goal = rng.below(2);
    const double apart = std::ldexp(1.0, static_cast<int>(rng.below(12)) - 6);
    const double flat = std::ldexp(1.0, -static_cast<int>(rng.below(30)));
    std::array<Vec3, 6> corners;
    for (std::size_t i = 0; i < 6; ++i) {
      corners[i] = {rng.uniform(-1, 1), rng.uniform(-1, 1),
                    flat * rng.uniform(-1, 1) + (i < 3 ? 0 : apart)};
    }
    const auto value = [&](const std::array<Vec3, 6>& c) {
      return excess({c[0], c[1], c[2]}, {c[3], c[4], c[5]})[goal];
    };
    double best = value(corners);
    for (int step = 0; step < 1500; ++step) {
      std::array<Vec3, 6> next = corners;
      double& x = next[rng.below(6)][rng.below(3)];
      x += x * std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(52)));
      if (const double here = value(next); here >= best) {
        best = here;
        corners = next;
      }
    }
    EXPECT_LE(best, 0);
    most[goal] = std::max(most[goal], best);
  });
  // Not because the bounds are far off.
  EXPECT_GT(most[0], -2 * detail::kLowerUnits);
  EXPECT_GT(most[1], -detail::kUpperUnits);
}

}  // namespace
}  // namespace soms

#include "soms/geometry/orientation.h"

#include "soms/geometry/detail/exact/orientation_exact.h"

#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace soms {
namespace {

using Quad = std::array<Vec3, 4>;

constexpr std::array kPlanes{Projection::xy, Projection::yz, Projection::zx};

Sign opposite(Sign s) {
  return static_cast<Sign>(-static_cast<int>(s));
}

/// A number of random sign, bits and scale between 2^lower and 2^upper, sometimes zero.
double any_number(Rng& rng, int lower, int upper) {
  const int exponent =
      lower + static_cast<int>(rng.below(static_cast<std::uint64_t>(upper - lower)));
  const double sign = rng.below(2) == 0 ? 1 : -1;
  return rng.below(12) == 0 ? 0 : std::ldexp(sign * (1 + rng.unit()), exponent);
}

Quad any_scale(Rng& rng) {
  static constexpr std::array<std::array<int, 2>, 7> kScales{
      {{-1074, 300}, {-1074, -1000}, {-400, -250}, {-142, 201}, {-20, 20}, {-3, 1}, {280, 300}}};
  const auto [lower, upper] = kScales[rng.below(kScales.size())];
  Quad q;
  for (Vec3& p : q) {
    p = {any_number(rng, lower, upper), any_number(rng, lower, upper),
         any_number(rng, lower, upper)};
  }
  return q;
}

/// Moves `x` by up to two neighboring doubles.
double nudge(Rng& rng, double x) {
  for (std::uint64_t n = rng.below(3); n > 0; --n) {
    x = std::nextafter(x, rng.below(2) == 0 ? 1e300 : -1e300);
  }
  return x;
}

/// A point near the plane of three others, at all scales, near to or far from the origin.
Quad near_coplanar(Rng& rng) {
  const double scale = std::ldexp(1.0, static_cast<int>(rng.below(1300)) - 1010);
  const double far = rng.below(2) == 0 ? 0 : std::ldexp(scale, static_cast<int>(rng.below(40)));
  Quad q;
  for (Vec3& p : q) {
    p = {far + scale * rng.uniform(-1, 1), far + scale * rng.uniform(-1, 1),
         far + scale * rng.uniform(-1, 1)};
  }
  const double s = rng.uniform(-1, 2);
  const double t = rng.below(3) == 0 ? 0 : rng.uniform(-1, 2);
  const Vec3 d = q[0] + s * (q[1] - q[0]) + t * (q[2] - q[0]);
  q[3] = {nudge(rng, d.x), nudge(rng, d.y), nudge(rng, d.z)};
  return q;
}

/// Small integers: exact zeros are frequent.
Quad lattice(Rng& rng) {
  const double unit = std::ldexp(1.0, static_cast<int>(rng.below(1200)) - 950);
  Quad q;
  for (Vec3& p : q) {
    p = {unit * (static_cast<double>(rng.below(7)) - 3), unit * static_cast<double>(rng.below(4)),
         unit * static_cast<double>(rng.below(5))};
  }
  return q;
}

Sign sign_of(const detail::ScaledNumber& number) {
  return number.fraction > 0 ? Sign::positive : number.fraction < 0 ? Sign::negative : Sign::zero;
}

void expect_consistent(const Quad& q) {
  const auto& [a, b, c, d] = q;
  const Sign sign = orientation(a, b, c, d);
  EXPECT_EQ(sign, detail::orientation_wide(a, b, c, d));
  EXPECT_EQ(sign, detail::orientation_exact(a, b, c, d));
  EXPECT_EQ(sign, sign_of(detail::determinant(a, b, c, d)));
  const auto grid = detail::orientation_grid(a, b, c, d);
  EXPECT_EQ(grid.value_or(sign), sign);
  EXPECT_EQ(sign, orientation(b, c, a, d));
  EXPECT_EQ(sign, orientation(b, a, d, c));
  EXPECT_EQ(opposite(sign), orientation(b, a, c, d));
  EXPECT_EQ(opposite(sign), orientation(a, b, d, c));
  for (const Projection plane : kPlanes) {
    const Sign turn = orientation2d(a, b, c, plane);
    EXPECT_EQ(turn, detail::orientation2d_exact(a, b, c, plane));
    EXPECT_EQ(turn, sign_of(detail::determinant2d(a, b, c, plane)));
    EXPECT_EQ(turn, orientation2d(b, c, a, plane));
    EXPECT_EQ(opposite(turn), orientation2d(b, a, c, plane));
  }
}

TEST(Orientation, IsPositiveForPointAboveCounterClockwiseTriangle) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::positive);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), Sign::negative);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), Sign::zero);
}

TEST(Orientation, TakesPlanarTurnsInCyclicCoordinatePlanes) {
  const Vec3 o{0, 0, 0};
  EXPECT_EQ(orientation2d(o, {1, 0, 9}, {0, 1, -9}, Projection::xy), Sign::positive);
  EXPECT_EQ(orientation2d(o, {9, 1, 0}, {-9, 0, 1}, Projection::yz), Sign::positive);
  EXPECT_EQ(orientation2d(o, {0, 9, 1}, {1, -9, 0}, Projection::zx), Sign::positive);
  EXPECT_EQ(orientation2d(o, {0, 1, 0}, {1, 0, 0}, Projection::xy), Sign::negative);
  EXPECT_EQ(orientation2d(o, {1, 1, 0}, {3, 3, 1}, Projection::xy), Sign::zero);
}

// The plain double determinant answers `positive` here; the exact sign is `negative`.
TEST(Orientation, CorrectsWrongSignOfPlainDeterminant) {
  const auto lift = [](double x, double y) { return Vec3{x, y, x + y}; };
  const Vec3 a = lift(2.0, 3.2);
  const Vec3 b = lift(1.2, 0.1);
  const Vec3 c = lift(3.0, 6.0);
  const Vec3 d = lift(4.1, 2.4);
  EXPECT_GT(dot(cross(b - a, c - a), d - a), 0);
  EXPECT_EQ(orientation(a, b, c, d), Sign::negative);
}

TEST(Orientation, SeesOneUlpOffThePlaneFarFromTheOrigin) {
  const double far = 1e8;
  const Vec3 a{far, far, far};
  const Vec3 b{far + 1, far, far};
  const Vec3 c{far, far + 1, far};
  const double up = std::nextafter(far, 2 * far);
  EXPECT_EQ(orientation(a, b, c, {far + 0.25, far + 0.25, up}), Sign::positive);
  EXPECT_EQ(orientation(a, b, c, {far + 0.25, far + 0.25, far}), Sign::zero);
}

TEST(Orientation, DecidesWhereProductsUnderflow) {
  const double least = std::numeric_limits<double>::denorm_min();
  const Vec3 o{0, 0, 0};
  EXPECT_EQ(orientation(o, {least, 0, 0}, {0, least, 0}, {0, 0, least}), Sign::positive);
  EXPECT_EQ(orientation(o, {0, least, 0}, {least, 0, 0}, {0, 0, 0x1p300}), Sign::negative);
  EXPECT_EQ(orientation(o, {0x1p300, 0, 0}, {0, 0x1p300, 0}, {0x1p300, 0x1p300, least}),
            Sign::positive);
  EXPECT_EQ(orientation2d(o, {least, 0, 0}, {least, least, 0}, Projection::xy), Sign::positive);
  EXPECT_EQ(orientation2d({1, 1, 0}, {2, 2, 0}, {3, 3, least}, Projection::xy), Sign::zero);
}

// Both components of the normal are rounded by nearly half the least double there is, against each
// other, and then multiplied by coordinates that are as large as they may be.
TEST(Orientation, DecidesWhereTheNormalUnderflowsAndThePointIsFar) {
  const double c = 0x1p-537;
  const Vec3 far{-0x1p299, 1.3 * 0x1p299, 0};
  EXPECT_EQ(orientation({0, 0, 0}, {-1.4 * c, 1.6 * c, 0}, {0, 0, c}, far), Sign::positive);
  EXPECT_EQ(orientation({0, 0, 0}, {-1.4 * c, 1.6 * c, 0}, {0, 0, c}, -far), Sign::negative);
}

TEST(Orientation, DecidesAtTheLargestCoordinates) {
  const double m = 0x1p300;
  EXPECT_EQ(orientation({-m, -m, -m}, {m, -m, -m}, {-m, m, -m}, {m, m, m}), Sign::positive);
  const double below = std::nextafter(m, 0);
  EXPECT_EQ(orientation({-m, -m, m}, {m, -m, -m}, {-m, m, -m}, {m, m, -3 * m / 4}), Sign::positive);
  EXPECT_EQ(orientation({m, 0, 0}, {0, m, 0}, {0, 0, m}, {0, 0, below}), Sign::negative);
}

TEST(Orientation, WideSumHoldsAllFiniteDoubles) {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  const Vec3 a{-most, -most, -most};
  EXPECT_EQ(
      detail::orientation_wide(a, {most, -most, -most}, {-most, most, -most}, {most, most, least}),
      Sign::positive);
  EXPECT_EQ(detail::orientation_wide(a, {most, -most, -most}, {-most, most, -most},
                                     {least, least, -most}),
            Sign::zero);
}

TEST(Orientation, AgreesWithExactTwinsAtAllScales) {
  test::for_each_case("orientation/any-scale", 5000,
                      [](Rng& rng) { expect_consistent(any_scale(rng)); });
}

TEST(Orientation, AgreesWithExactTwinsNearCoplanar) {
  test::for_each_case("orientation/near-coplanar", 5000,
                      [](Rng& rng) { expect_consistent(near_coplanar(rng)); });
}

TEST(Orientation, AgreesWithExactTwinsOnLattices) {
  int zeros = 0;
  test::for_each_case("orientation/lattice", 5000, [&](Rng& rng) {
    const Quad q = lattice(rng);
    expect_consistent(q);
    zeros += orientation(q[0], q[1], q[2], q[3]) == Sign::zero ? 1 : 0;
  });
  EXPECT_GT(zeros, 100);
}

// Integers small enough that the determinant is exact in 64 bits: a twin of another kind.
TEST(Orientation, AgreesWithIntegerDeterminant) {
  test::for_each_case("orientation/integers", 5000, [](Rng& rng) {
    std::array<std::array<std::int64_t, 3>, 4> n{};
    Quad q;
    const int range = rng.below(2) == 0 ? 3 : 1 << 18;
    const int scale = rng.below(2) == 0 ? -300 : -1000;  // on a grid, and below all grids
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        n[i][k] =
            static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(range))) - range / 2;
        q[i][k] = std::ldexp(static_cast<double>(n[i][k]), scale);
      }
    }
    const auto at = [&](std::size_t i, std::size_t k) { return n[i][k] - n[0][k]; };
    const std::int64_t det = at(3, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) +
                             at(3, 1) * (at(1, 2) * at(2, 0) - at(1, 0) * at(2, 2)) +
                             at(3, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
    const Sign expected = det > 0 ? Sign::positive : det < 0 ? Sign::negative : Sign::zero;
    EXPECT_EQ(orientation(q[0], q[1], q[2], q[3]), expected);
    EXPECT_EQ(detail::orientation_wide(q[0], q[1], q[2], q[3]), expected);
    const detail::ScaledNumber number = detail::determinant(q[0], q[1], q[2], q[3]);
    const double value = std::ldexp(number.fraction, number.exponent - 3 * scale);
    EXPECT_LE(std::abs(value - static_cast<double>(det)),
              0x1p-50 * std::abs(static_cast<double>(det)));
  });
}

}  // namespace
}  // namespace soms

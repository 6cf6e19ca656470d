// Boxes leave no cell out, and where cuts are short they need few visits.
#include "soms/geometry/detail/parts/cell_boxes.h"

#include "soms/base/random.h"
#include "soms/geometry/detail/parts/plane_cells.h"

#include "tests/support/slow_build.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace soms {
namespace {

using detail::CellPlane;
using detail::PlaneCut;
using detail::PlanePoint;
using detail::SeenTriangle;

/// Points of a lattice in a plane.
struct Lattice {
  Vec3 origin;
  Vec3 first{1, 0, 0};
  Vec3 second{0, 1, 0};
  double unit = 1;

  [[nodiscard]] Vec3 at(double i, double j) const {
    return (origin + i * first + j * second) * unit;
  }
};

/// Whole numbers, so that all its points are exact.
Lattice any_lattice(Rng& rng) {
  const auto vector = [&] {
    const auto entry = [&] { return static_cast<double>(rng.below(9)) - 4; };
    return Vec3{entry(), entry(), entry()};
  };
  Lattice lattice{vector() * std::ldexp(1.0, static_cast<int>(rng.below(30))), vector(), vector(),
                  std::ldexp(1.0, static_cast<int>(rng.below(200)) - 100)};
  lattice.first.x += 9;  // so that the two are not parallel
  lattice.second.y += 9;
  return lattice;
}

/// A triangle and others in its plane.
struct Covered {
  CellPlane plane;
  std::vector<SeenTriangle> others;
  std::vector<PlaneCut> cuts;

  explicit Covered(const Triangle& t) : plane(*CellPlane::of(t, CellPlane::View::steep)) {}

  void add(const Triangle& s) {
    SeenTriangle seen = plane.seen(s);
    seen.append_cuts(cuts);
    if (!seen.flat()) {
      others.push_back(std::move(seen));
    }
  }

  [[nodiscard]] std::vector<bool> covering(const PlanePoint& p) const {
    std::vector<bool> covering;
    for (const SeenTriangle& other : others) {
      covering.push_back(other.covers(p));
    }
    return covering;
  }
};

/// Of each visited cell, which triangles cover it.
using Coverings = std::set<std::vector<bool>>;

Coverings coverings_of_cells(const Covered& covered) {
  Coverings found;
  covered.plane.for_each_cell(covered.cuts, [&](const PlanePoint& p) {
    found.insert(covered.covering(p));
    return true;
  });
  return found;
}

Coverings coverings_in_boxes(const Covered& covered) {
  Coverings found;
  covered.plane.for_each_cell_in_boxes(covered.cuts, [&](const PlanePoint& p) {
    found.insert(covered.covering(p));
    return true;
  });
  return found;
}

std::uint64_t visits_in_boxes(const Covered& covered) {
  std::uint64_t visits = 0;
  covered.plane.for_each_cell_in_boxes(covered.cuts, [&](const PlanePoint&) {
    ++visits;
    return true;
  });
  return visits;
}

constexpr int kSide = 48;

Covered covered_lattice(const Lattice& lattice) {
  return Covered({lattice.at(0, 0), lattice.at(kSide, 0), lattice.at(0, kSide)});
}

/// Short or long, some beside the large one.
Triangle any_triangle(const Lattice& lattice, Rng& rng, std::uint64_t size) {
  const auto i = static_cast<double>(rng.below(kSide)) - 4;
  const auto j = static_cast<double>(rng.below(kSide)) - 4;
  const auto step = [&] { return static_cast<double>(rng.below(size)); };
  return {lattice.at(i, j), lattice.at(i + step(), j + step()), lattice.at(i + step(), j + step())};
}

TEST(CellBoxes, VisitEveryCell) {
  test::for_each_case("geometry/cell-boxes", test::some_of(60), [](Rng& rng) {
    const Lattice lattice = any_lattice(rng);
    Covered covered = covered_lattice(lattice);
    const std::uint64_t size = rng.below(3) == 0 ? kSide : 8;
    for (std::uint64_t count = 8 + rng.below(12); count > 0; --count) {
      covered.add(any_triangle(lattice, rng, size));
    }
    ASSERT_EQ(coverings_in_boxes(covered), coverings_of_cells(covered));
  });
}

// Slivers that have a corner in common, and nearly the same place.
TEST(CellBoxes, VisitEveryCellOfAFan) {
  for (const bool narrow : {false, true}) {
    const Lattice lattice;
    Covered covered = covered_lattice(lattice);
    for (int i = 1; i < 24; ++i) {
      const auto [p, q] =
          narrow ? std::pair(i * 0x1p-30, (i + 1) * 0x1p-30) : std::pair<double, double>(i, i + 1);
      covered.add({lattice.at(5, 5), lattice.at(29 - p, p), lattice.at(29 - q, q)});
    }
    EXPECT_EQ(coverings_in_boxes(covered), coverings_of_cells(covered));
    EXPECT_LT(visits_in_boxes(covered), 24U * 24U);
  }
}

// A cell for each square, and few more around them.
TEST(CellBoxes, VisitAFewTimesAsManyCellsAsThereAreSquares) {
  for (const int n : {10, 20, test::kSlowBuild ? 20 : 60}) {
    Lattice lattice;
    lattice.unit = 1.0 / (2 * n);
    Covered covered({lattice.at(-1, -1), lattice.at(4 * n, -1), lattice.at(-1, 4 * n)});
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double u = 2 * i + 0.01 * ((7 * j) % 11);
        const double v = 2 * j + 0.01 * ((5 * i) % 11);
        covered.add({lattice.at(u, v), lattice.at(u + 1, v), lattice.at(u + 1, v + 1)});
      }
    }
    const auto squares = static_cast<std::uint64_t>(n * n);
    const std::uint64_t visits = visits_in_boxes(covered);
    EXPECT_GT(visits, squares);
    EXPECT_LT(visits, 8 * squares);
  }
}

TEST(CellBoxes, EndWithTheVisitThatSaysSo) {
  const Lattice lattice;
  Covered covered = covered_lattice(lattice);
  for (int i = 0; i < 12; ++i) {
    covered.add({lattice.at(2 * i, 1), lattice.at(2 * i + 1, 1), lattice.at(2 * i, 2)});
  }
  int visits = 0;
  EXPECT_FALSE(covered.plane.for_each_cell_in_boxes(
      covered.cuts, [&](const PlanePoint&) { return ++visits < 5; }));
  EXPECT_EQ(visits, 5);
}

}  // namespace
}  // namespace soms

// Rays, segments, points in closed bodies and winding numbers at every size that doubles have, with
// triangles of very different sizes in one mesh: what brute force says.
#include "soms/query/contains.h"
#include "soms/query/print.h"
#include "soms/query/ray.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/ray.h"
#include "soms/query/reference/winding.h"
#include "soms/query/winding.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/needs_instruction_set.h"
#include "tests/support/scales.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace soms {
namespace {

using test::any_way;
using test::point_of_small;
using test::Scales;

class RayScales : public test::NeedsInstructionSet {};

/// Calls `check` for each pair of scales.
void for_all_scales(const std::string& tag, const std::function<void(Rng&, const Scales&)>& check) {
  std::size_t number = 0;
  test::for_each_case(tag, static_cast<int>(test::count_of_scales()), [&](Rng& rng) {
    const Scales scales = test::scales_of(number++);
    SCOPED_TRACE("body of 2^" + std::to_string(scales.body) + ", triangles of 2^" +
                 std::to_string(scales.triangle));
    check(rng, scales);
  });
}

Shape shape_of(Rng& rng, Mesh mesh) {
  return Shape(std::move(mesh), {.build = test::awkward_options(rng),
                                 .layout = rng.below(3) == 0 ? Layout::compact : Layout::wide});
}

/// A length of about that of a small triangle, of the body, or any between.
double any_reach(Rng& rng, const Scales& scales) {
  const std::uint64_t kind = rng.below(4);
  const double exponent = kind == 0   ? scales.body - 2
                          : kind == 1 ? rng.uniform(scales.triangle, scales.body - 2)
                                      : scales.triangle + rng.uniform(-3, 3);
  return std::exp2(std::min(exponent, scales.body - 2.0));
}

Ray ray_at(Rng& rng, const Body& body, const Scales& scales) {
  const MeshView& mesh = body.shape.mesh();
  const Vec3 to = point_of_small(rng, mesh, body.pose);
  const Vec3 from = rng.below(4) == 0 ? point_of_small(rng, mesh, body.pose)
                                      : to + any_way(rng, any_reach(rng, scales));
  Ray ray{from, to - from};
  if (rng.below(3) == 0) {
    const Vec3& d = ray.direction;
    const double most = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const int exponent = most == 0 ? 0 : std::ilogb(most);
    const int grown = static_cast<int>(rng.below(1300)) - 1000;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ray.direction[axis] = std::ldexp(ray.direction[axis], grown - exponent);
    }
  }
  if (ray.direction == Vec3{}) {
    ray.direction[rng.below(3)] =
        rng.below(2) == 0 ? 1 : std::ldexp(1.0, std::max(scales.triangle, -1074));
  }
  constexpr std::array<double, 4> kLengths{0, 0.5, 1, 2};
  const std::uint64_t length = rng.below(8);
  if (length < kLengths.size()) {
    ray.length = kLengths[length];
  }
  return ray;
}

/// How often rays hit and missed.
using HitsAndMisses = std::array<std::size_t, 2>;

template <class Line>
void expect_lines(const Body& body, const std::vector<Line>& lines, HitsAndMisses& counts) {
  const ClosestHitBatch closest = closest_hit(body, lines);
  const AnyHitBatch any = any_hit(body, lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    SCOPED_TRACE(i);
    ClosestHit twin = reference::closest_hit_by_brute_force(body, lines[i]);
    twin.cost = closest.costs[i];
    ASSERT_EQ(closest.at(i), twin);
    ASSERT_EQ(closest_hit(body, lines[i]), twin);
    ASSERT_EQ(any.hit[i] != 0, twin.triangle.has_value());
    ASSERT_EQ(any_hit(body, lines[i]).hit, twin.triangle.has_value());
    const AllHits all = all_hits(body, std::span(&lines[i], 1));
    AllHits all_twin = reference::all_hits_by_brute_force(body, lines[i]);
    all_twin.cost = all.cost;
    all_twin.costs = all.costs;
    ASSERT_EQ(all, all_twin);
    ++counts[twin.triangle ? 0 : 1];
  }
}

TEST_F(RayScales, RaysAndSegmentsAnswerAsBruteForce) {
  HitsAndMisses counts = {};
  for_all_scales("ray-scales/rays", [&](Rng& rng, const Scales& scales) {
    const Body body(shape_of(rng, test::uneven_mesh(rng, scales)), test::pose_at(rng, scales));
    std::vector<Ray> rays;
    std::vector<Ray> segments;
    for (int i = 0; i < 6; ++i) {
      rays.push_back(ray_at(rng, body, scales));
      const Vec3 from = ray_at(rng, body, scales).origin;
      segments.push_back(Ray::between(from, point_of_small(rng, body.shape.mesh(), body.pose)));
    }
    ASSERT_NO_FATAL_FAILURE(expect_lines(body, rays, counts));
    ASSERT_NO_FATAL_FAILURE(expect_lines(body, segments, counts));
  });
  EXPECT_GT(counts[0], 15'000U);
  EXPECT_GT(counts[1], 5'000U);
  RecordProperty("hits", static_cast<int>(counts[0]));
  RecordProperty("misses", static_cast<int>(counts[1]));
}

/// Points of small triangles, beside them by about their size, a step beside them, or in line with
/// a corner.
std::vector<Vec3> points_at(Rng& rng, const Body& body, const Scales& scales, int count) {
  const MeshView& mesh = body.shape.mesh();
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    Vec3 p = point_of_small(rng, mesh, body.pose);
    const std::size_t axis = rng.below(3);
    switch (rng.below(6)) {
      case 0:
        break;
      case 1:
        p[axis] = std::nextafter(p[axis], rng.below(2) == 0 ? 1e300 : -1e300);
        break;
      case 2:
        p[axis] = point_of_small(rng, mesh, body.pose)[axis];
        break;
      case 3:
        p = (p + point_of_small(rng, mesh, body.pose)) * 0.5;
        break;
      default:
        p += any_way(rng, any_reach(rng, scales));
    }
    points.push_back(p);
  }
  return points;
}

TEST_F(RayScales, PointsAreOnTheSidesThatBruteForceFinds) {
  std::array<std::size_t, 4> sides = {};
  for_all_scales("ray-scales/points", [&](Rng& rng, const Scales& scales) {
    const Body body(shape_of(rng, test::uneven_solids(rng, scales)), test::pose_at(rng, scales));
    const std::vector<Vec3> points = points_at(rng, body, scales, 24);
    const ContainsBatch batch = contains(body, points);
    ASSERT_EQ(batch.side, reference::contains_by_brute_force(body, points));
    for (const Side side : batch.side) {
      ++sides[static_cast<std::size_t>(side)];
    }
  });
  EXPECT_GT(sides[static_cast<std::size_t>(Side::outside)], 10'000U);
  EXPECT_GT(sides[static_cast<std::size_t>(Side::inside)], 3'000U);
  EXPECT_GT(sides[static_cast<std::size_t>(Side::on)], 3'000U);
  EXPECT_EQ(sides[static_cast<std::size_t>(Side::undecided)], 0U);
  RecordProperty("points", static_cast<int>(sides[0] + sides[1] + sides[2]));
}

TEST_F(RayScales, WindingNumbersHoldWhatBruteForceFinds) {
  std::size_t narrow = 0;
  std::size_t all = 0;
  for_all_scales("ray-scales/winding", [&](Rng& rng, const Scales& scales) {
    Mesh mesh =
        rng.below(2) == 0 ? test::uneven_mesh(rng, scales) : test::uneven_solids(rng, scales);
    for (std::uint64_t k = rng.below(4); k > 0 && mesh.triangles.size() > 1; --k) {
      mesh.triangles.erase(mesh.triangles.begin() +
                           static_cast<std::ptrdiff_t>(rng.below(mesh.triangles.size())));
    }
    const Body body(shape_of(rng, std::move(mesh)), test::pose_at(rng, scales));
    const std::vector<Vec3> points = points_at(rng, body, scales, 24);
    const WindingBatch batch = winding(WindingIndex(body), points);
    const std::vector<Bracket> twin = reference::winding_by_brute_force(body, points);
    const std::vector<Side> on = reference::contains_by_brute_force(body, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Bracket number = batch.at(i).number;
      ASSERT_LE(number.lower, number.upper);
      ASSERT_LE(number.lower, twin[i].upper);
      ASSERT_GE(number.upper, twin[i].lower);
      ASSERT_EQ(batch.side[i] == Side::on, on[i] == Side::on);
      narrow += number.upper - number.lower <= 1e-8 ? 1U : 0U;
      ++all;
    }
  });
  EXPECT_GT(narrow, all / 2);
  RecordProperty("numbers", static_cast<int>(all));
  RecordProperty("narrow", static_cast<int>(narrow));
}

}  // namespace
}  // namespace soms

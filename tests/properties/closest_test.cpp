// Queries of points against their twins, and relations that hold between their answers.
#include "soms/query/closest.h"

#include "soms/base/random.h"
#include "soms/geometry/point_distance.h"
#include "soms/geometry/triangle_distance.h"
#include "soms/query/distance.h"
#include "soms/query/print.h"

#include "tests/properties/meshes.h"
#include "tests/properties/near_touch.h"
#include "tests/properties/property.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/shortest_segment.h"
#include "tests/support/support.h"
#include "tests/support/truth/closest_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace soms {
namespace {

using test::check_property;
using test::first_fault_of_point;
using test::lattice_corners;
using test::lattice_mesh;
using test::mapped;

Vec3 point_in(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

/// A point on, at or beside a mesh: corners, middles of edges, and those an ulp off.
Vec3 point_at(const Mesh& mesh, Rng& rng) {
  const Triangle t = mesh.triangle(static_cast<TriangleId>(rng.below(mesh.triangles.size())));
  Vec3 p = rng.below(2) == 0 ? t.a : (t.a + t.b) * 0.5;
  if (rng.below(3) == 0) {
    p = (p + t.c) * 0.5;
  }
  if (rng.below(2) == 0) {
    double& x = p[rng.below(3)];
    x = std::nextafter(x, rng.below(2) == 0 ? -1e300 : 1e300);
  }
  return p;
}

/// A mesh with at least one triangle, on a lattice.
Mesh mesh_on_lattice(double unit) {
  Mesh mesh = lattice_mesh(*lattice_corners(), unit);
  return mesh.triangles.empty() ? lattice_mesh({0, 1, 9}, unit) : mesh;
}

Vec3 lattice_point(double unit) {
  const auto steps = rc::gen::inRange<int>(-24, 24);
  return Vec3{static_cast<double>(*steps), static_cast<double>(*steps),
              static_cast<double>(*steps)} *
         (unit / 2);
}

TEST(ClosestProperty, LatticesAnswerAsBruteForce) {
  check_property("closest/lattice", [] {
    const double unit = *rc::gen::element(0x1p-20, 1.0, 0x1p200);
    const Body body(lattice_mesh(*lattice_corners(), unit));
    RC_ASSERT(first_fault_of_point(body, lattice_point(unit)) == "");
  });
}

TEST(ClosestProperty, EveryKindOfBodyAnswersAsBruteForce) {
  check_property("closest/kinds", [](std::uint64_t seed) {
    const int kind = *rc::gen::inRange(0, test::kBodyKinds);
    Rng rng(seed);
    const Mesh mesh = test::meshes_of_kind(kind, rng).a;
    const double reach = test::is_tiny(kind) ? 0x1p-70 : *rc::gen::element(0.5, 4.0, 1e3, 1e9);
    const Pose pose = rng.below(2) == 0 ? Pose{} : test::any_pose(rng, reach);
    const Body body(Shape(mesh, {.build = test::awkward_options(rng),
                                 .layout = rng.below(2) == 0 ? Layout::wide : Layout::compact}),
                    pose);
    RC_ASSERT(first_fault_of_point(body, point_in(rng, reach)) == "");
    if (!mesh.triangles.empty()) {
      RC_ASSERT(first_fault_of_point(body, pose.apply(point_at(mesh, rng))) == "");
      RC_ASSERT(first_fault_of_point(Body(mesh), point_at(mesh, rng)) == "");
    }
  });
}

// Poses off orthonormal by what is allowed, points beside them and far away.
TEST(ClosestProperty, PosesThatAreOffAnswerAsBruteForce) {
  check_property("closest/poses", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = test::meshes_of_kind(0, rng).a;
    Pose pose = test::awkward_rotation(rng);
    const double reach = *rc::gen::element(0.5, 3.0, 100.0, 1e8, 1e17);
    Vec3 point = point_in(rng, reach);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double shared = *rc::gen::element(0.0, 1e7);
      pose.m[4 * axis + 3] = shared;
      point[axis] += shared;
    }
    RC_ASSERT(first_fault_of_point(Body(mesh, pose), point) == "");
  });
}

// Corners of triangles that others nearly touch are points that are nearly on them.
TEST(ClosestProperty, PointsThatNearlyTouchAnswerAsBruteForce) {
  test::for_each_case("closest/near-touch", 200, [](Rng& rng) {
    std::vector<Triangle> first;
    std::vector<Vec3> points;
    for (int i = 0; i < 3; ++i) {
      const auto [s, t] = test::nearly_touching(rng);
      first.push_back(s);
      points.insert(points.end(), {t.a, t.b, t.c});
    }
    const Body body(test::soup_body(first));
    for (const Vec3& point : points) {
      ASSERT_EQ(first_fault_of_point(body, point), "");
    }
  });
}

// A point is a triangle whose corners are equal: `distance` decides by other code.
TEST(ClosestProperty, APointIsABodyOfOnePoint) {
  check_property("closest/as-distance", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = test::meshes_of_kind(*rc::gen::inRange(0, test::kBodyKinds), rng).a;
    RC_PRE(!mesh.triangles.empty());
    const Body body(mesh, test::any_pose(rng, 2));
    const Vec3 p = point_in(rng, *rc::gen::element(0.5, 50.0, 1e7));
    const Closest near = closest(body, p);
    const Distance same = distance(body, test::body_of({p, p, p}));
    RC_ASSERT(near.distance == same.distance);
    RC_ASSERT(*near.triangle == same.triangles->a);
  });
}

TEST(ClosestProperty, TrianglesAgreeWithTheDistanceOfTriangles) {
  test::for_each_case("closest/triangles", 3000, [](Rng& rng) {
    const auto [s, t] = test::nearly_touching(rng);
    for (const Vec3& p : {t.a, t.b, t.c}) {
      const PointDistance found = point_distance(p, s);
      ASSERT_EQ(found.distance, triangle_distance(s, {p, p, p}).distance);
      ASSERT_EQ(found, point_distance(p, Triangle{s.b, s.c, s.a}));
      ASSERT_EQ(found, point_distance(p, Triangle{s.b, s.a, s.c}));
    }
  });
}

TEST(ClosestProperty, PowersOfTwoScaleIt) {
  check_property("closest/powers", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = mesh_on_lattice(0.125);
    const Vec3 p = point_in(rng, 6);
    const Closest expected = closest(Body(mesh), p);
    const int k = *rc::gen::inRange(-280, 280);
    const double factor = std::ldexp(1.0, k);
    const Closest scaled =
        closest(Body(mapped(mesh, [&](const Vec3& v) { return v * factor; })), p * factor);
    RC_ASSERT(scaled.distance.lower == expected.distance.lower * factor);
    RC_ASSERT(scaled.distance.upper == expected.distance.upper * factor);
    RC_ASSERT(scaled.triangle == expected.triangle);
    RC_ASSERT(scaled.feature == expected.feature);
    RC_ASSERT(scaled.point == expected.point * factor);
  });
}

TEST(ClosestProperty, RotationsOfTheCubeChangeNothing) {
  check_property("closest/rotations", [] {
    const Mesh mesh = mesh_on_lattice(0x1p-3);
    const Vec3 p = lattice_point(0x1p-3);
    const Closest expected = closest(Body(mesh), p);
    for (const Pose& turn : test::cube_rotations()) {
      Closest turned = closest(Body(mesh, turn), turn.apply(p));
      RC_ASSERT(turned.point == turn.apply(expected.point));
      turned.point = expected.point;
      turned.cost = expected.cost;
      RC_ASSERT(turned == expected);
    }
  });
}

TEST(ClosestProperty, PermutingTrianglesKeepsTheDistanceAndThePoint) {
  check_property("closest/permute", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = mesh_on_lattice(0.25);
    const Vec3 p = lattice_point(0.25);
    std::vector<TriangleId> order(mesh.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    Mesh permuted = mesh;
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::swap(order[i], order[i + rng.below(order.size() - i)]);
      permuted.triangles[i] = mesh.triangles[order[i]];
    }
    const Closest before = closest(Body(mesh), p);
    const Closest after = closest(Body(permuted), p);
    RC_ASSERT(after.distance == before.distance);
    RC_ASSERT(order[*after.triangle] >= *before.triangle);
  });
}

}  // namespace
}  // namespace soms

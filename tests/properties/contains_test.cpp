// Relations that hold between points and closed bodies, whatever they are.
#include "soms/query/contains.h"

#include "soms/base/error.h"
#include "soms/base/random.h"
#include "soms/geometry/closedness.h"
#include "soms/query/overlap.h"
#include "soms/query/reference/contains.h"

#include "tests/properties/meshes.h"
#include "tests/properties/property.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms {
namespace {

using test::any_closed_mesh;
using test::check_property;
using test::closed_mesh;
using test::mapped;

constexpr double kFar = std::numeric_limits<double>::max();

/// A point beside the surface or on it, in line with a vertex, in the box, or far away.
Vec3 any_point(Rng& rng, const Body& body) {
  const MeshView& mesh = body.shape.mesh();
  const auto vertex = [&] {
    return body.pose.apply(mesh.vertices[rng.below(mesh.vertices.size())]);
  };
  const auto& t = mesh.triangles[rng.below(mesh.triangles.size())];
  const Vec3 a = body.pose.apply(mesh.vertices[t[0]]);
  const Vec3 b = body.pose.apply(mesh.vertices[t[1]]);
  const Vec3 c = body.pose.apply(mesh.vertices[t[2]]);
  const double u = rng.below(2) == 0 ? 0.5 : rng.uniform(0, 1);
  Vec3 p = rng.below(3) == 0 ? a : (a + (b - a) * u) + (c - a) * (rng.below(2) == 0 ? 0 : 0.25);
  const std::uint64_t kind = rng.below(6);
  const std::size_t axis = rng.below(3);
  if (kind == 0) {
    p[axis] = std::nextafter(p[axis], rng.below(2) == 0 ? kFar : -kFar);
  } else if (kind == 1) {
    p[axis] = vertex()[axis];
  } else if (kind == 2) {
    p = (vertex() + vertex()) * 0.5;
  } else if (kind == 3) {
    p[axis] += (p[axis] - vertex()[axis]) * std::exp2(rng.uniform(-50, 60));
  } else if (kind == 4) {
    p = {vertex().x, vertex().y, vertex().z};
  }
  return p;
}

std::vector<Vec3> any_points(Rng& rng, const Body& body, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(any_point(rng, body));
  }
  return points;
}

/// A pose that may be off orthonormal by what is allowed, and far from the origin.
Pose any_pose_of(Rng& rng, const Mesh& mesh) {
  Pose pose = rng.below(3) == 0 ? Pose{} : test::awkward_rotation(rng);
  const Vec3 extent = bounds(mesh).extent();
  const double size = std::max({extent.x, extent.y, extent.z});
  const double far = rng.below(2) == 0 ? 0 : size * std::exp2(rng.uniform(-4, 56));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.m[4 * axis + 3] = far * rng.uniform(-1, 1);
  }
  return pose;
}

TEST(ContainsProperty, AnswersAsBruteForce) {
  std::array<std::size_t, 3> sides = {};
  check_property("contains/twin", [&](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = any_closed_mesh(rng);
    const ShapeOptions options{.build = test::awkward_options(rng),
                               .layout = rng.below(3) == 0 ? Layout::compact : Layout::wide};
    const Body body(Shape(mesh, options), any_pose_of(rng, mesh));
    const std::vector<Vec3> points = any_points(rng, body, 40);
    const ContainsBatch batch = contains(body, points);
    RC_ASSERT(batch.side == reference::contains_by_brute_force(body, points));
    for (const Side side : batch.side) {
      ++sides[static_cast<std::size_t>(side)];
    }
  });
  EXPECT_GT(sides[0], 1000U);
  EXPECT_GT(sides[1], 300U);
  EXPECT_GT(sides[2], 1000U);
}

TEST(ContainsProperty, IsOnExactlyWhereThePointOverlaps) {
  check_property("contains/on", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = any_closed_mesh(rng);
    const Body body(mesh, any_pose_of(rng, mesh));
    const ClosedBody closed(body);
    for (const Vec3& p : any_points(rng, body, 8)) {
      const bool touches = overlap(body, Body(test::soup_body({{p, p, p}}))).any;
      RC_ASSERT((contains(closed, p).side == Side::on) == touches);
    }
  });
}

TEST(ContainsProperty, MovingThePointsWithTheVerticesChangesNothing) {
  check_property("contains/rotations", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = any_closed_mesh(rng);
    const std::vector<Vec3> points = any_points(rng, Body(mesh), 10);
    const std::vector<Side> sides = contains(Body(mesh), points).side;
    for (const Pose& turn : test::cube_rotations()) {
      std::vector<Vec3> turned;
      for (const Vec3& p : points) {
        turned.push_back(turn.apply(p));
      }
      RC_ASSERT(contains(Body(mesh, turn), turned).side == sides);
    }
  });
}

// Modulo 2, two bodies as one are inside where just one of them is.
TEST(ContainsProperty, OfTwoBodiesAsOneIsTheirDifference) {
  check_property("contains/joined", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh a = closed_mesh(rng);
    const Mesh b = closed_mesh(rng);
    const Body both(test::joined(a, b));
    for (const Vec3& p : any_points(rng, both, 20)) {
      const Side of_a = contains(ClosedBody(Body(a)), p).side;
      const Side of_b = contains(ClosedBody(Body(b)), p).side;
      const Side expected = of_a == Side::on || of_b == Side::on ? Side::on
                            : of_a == of_b                       ? Side::outside
                                                                 : Side::inside;
      RC_ASSERT(contains(ClosedBody(both), p).side == expected);
    }
  });
}

// Without one of its triangles a body is open, unless that has no area or its like is there, too.
TEST(ContainsProperty, ABodyThatLacksATriangleIsRefused) {
  check_property("contains/open", [](std::uint64_t seed) {
    Rng rng(seed);
    Mesh mesh = closed_mesh(rng);
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(rng.below(4)));
    const bool closed = closedness(mesh).whole.closed;
    bool refused = false;
    try {
      static_cast<void>(ClosedBody(Body(mesh)));
    } catch (const Error& error) {
      refused = error.kind() == ErrorKind::not_closed;
    }
    RC_ASSERT(refused != closed);
  });
}

}  // namespace
}  // namespace soms

// Relations that hold between points and bodies of any triangles.
#include "soms/query/winding.h"

#include "soms/base/random.h"
#include "soms/geometry/closedness.h"
#include "soms/query/contains.h"
#include "soms/query/contains_parts.h"
#include "soms/query/reference/contains.h"
#include "soms/query/reference/winding.h"

#include "tests/properties/meshes.h"
#include "tests/properties/property.h"
#include "tests/query/overlap_inputs.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using test::check_property;

/// Triangles of any kind: some of a closed mesh, on a lattice, or of any pair of bodies.
Mesh any_triangles(Rng& rng) {
  Mesh mesh = rng.below(3) == 0 ? test::meshes_of_kind(static_cast<int>(rng.below(8)), rng).a
                                : test::any_closed_mesh(rng);
  mesh.parts.clear();
  mesh.faces.clear();
  if (rng.below(2) == 0) {
    const std::uint64_t kept = 1 + rng.below(9);
    mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
                                        [&](const auto&) { return rng.below(10) > kept; }),
                         mesh.triangles.end());
  }
  if (mesh.triangles.empty()) {
    mesh = test::box_body({0, 0, 0}, {1, 1, 1});
  }
  return mesh;
}

Pose winding_pose(Rng& rng, const Mesh& mesh) {
  Pose pose = rng.below(3) == 0 ? Pose{} : test::awkward_rotation(rng);
  const Vec3 extent = bounds(mesh).extent();
  const double far = rng.below(2) == 0 ? 0 : std::max({extent.x, extent.y, extent.z});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pose.m[4 * axis + 3] = far * rng.uniform(-1, 1);
  }
  return pose;
}

/// Points on triangles, beside them and their edges by any step, in line with corners, and far.
std::vector<Vec3> winding_points(Rng& rng, const Body& body, int count) {
  const MeshView& mesh = body.shape.mesh();
  std::vector<Vec3> points;
  const auto corner = [&] {
    const auto& t = mesh.triangles[rng.below(mesh.triangles.size())];
    return body.pose.apply(mesh.vertices[t[rng.below(3)]]);
  };
  for (int i = 0; i < count; ++i) {
    const Vec3 a = corner();
    const Vec3 b = corner();
    Vec3 p = a + (b - a) * (rng.below(2) == 0 ? 0.5 : rng.uniform(-0.5, 1.5));
    const std::size_t axis = rng.below(3);
    const Vec3 extent = bounds(mesh).extent();
    const double size = std::max({extent.x, extent.y, extent.z, 0x1p-1000});
    switch (rng.below(6)) {
      case 0:
        p = a;
        break;
      case 1:
        p[axis] += size * std::exp2(rng.uniform(-60, 0)) * rng.uniform(-1, 1);
        break;
      case 2:
        p[axis] = corner()[axis];
        break;
      case 3:
        p[axis] = std::nextafter(p[axis], rng.uniform(-1, 1) * 1e200);
        break;
      case 4:
        p = p + Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)} *
                    (size * std::exp2(rng.uniform(-4, 30)));
        break;
      default:
        break;
    }
    points.push_back(p);
  }
  return points;
}

bool meet(const Bracket& a, const Bracket& b) {
  return a.lower <= b.upper && b.lower <= a.upper;
}

TEST(WindingProperty, HoldsWhatBruteForceFinds) {
  std::array<std::size_t, 4> sides = {};
  check_property("winding/twin", [&](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = any_triangles(rng);
    const Body body(mesh, winding_pose(rng, mesh));
    const WindingIndex index(body);
    const std::vector<Vec3> points = winding_points(rng, body, 40);
    const double width = std::exp2(-rng.uniform(5, 40));
    const WindingBatch batch = winding(index, points, {.width = width});
    const std::vector<Bracket> twin = reference::winding_by_brute_force(body, points);
    const std::vector<Side> on = reference::contains_by_brute_force(body, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      RC_ASSERT(meet(batch.at(i).number, twin[i]));
      RC_ASSERT((batch.side[i] == Side::on) == (on[i] == Side::on));
      ++sides[static_cast<std::size_t>(batch.side[i])];
    }
  });
  EXPECT_GT(sides[0], 2000U);
  EXPECT_GT(sides[1], 200U);
  EXPECT_GT(sides[2], 1000U);
}

TEST(WindingProperty, IsAsNarrowAsItSays) {
  check_property("winding/width", [](std::uint64_t seed) {
    Rng rng(seed);
    const Mesh mesh = any_triangles(rng);
    const Body body(mesh, winding_pose(rng, mesh));
    const WindingIndex index(body);
    const double width = std::exp2(-rng.uniform(5, 40));
    const WindingBatch batch = winding(index, winding_points(rng, body, 20), {.width = width});
    const double rounding = 1e-12 + 1e-12 * static_cast<double>(mesh.triangles.size());
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Bracket number = batch.at(i).number;
      RC_ASSERT(batch.side[i] == Side::on || number.upper - number.lower <= width + rounding);
    }
  });
}

TEST(WindingProperty, OfMeshesThatFaceOneWayIsAnInteger) {
  check_property("winding/integer", [](std::uint64_t seed) {
    Rng rng(seed);
    Mesh mesh = test::box_body({-1, -1, -1}, {1, 1, 1}, static_cast<int>(1 + rng.below(4)));
    if (rng.below(2) == 0) {
      mesh = test::joined(mesh, test::box_body({0.5, -2, -0.25}, {0.75, 3, 0.25}));
    }
    const Body body(mesh, winding_pose(rng, mesh));
    const ClosedBody closed(body);
    const WindingIndex index(body);
    RC_ASSERT(index.boundary_edges() == 0U);
    for (const Vec3& p : winding_points(rng, body, 30)) {
      const Winding answer = winding(index, p);
      const Side side = contains(closed, p).side;
      RC_ASSERT((answer.side == Side::on) == (side == Side::on));
      if (side != Side::on) {
        RC_ASSERT(answer.number.lower == answer.number.upper);
        RC_ASSERT(answer.number.lower == std::round(answer.number.lower));
        RC_ASSERT((std::fmod(answer.number.lower, 2) != 0) == (side == Side::inside));
      }
    }
  });
}

// A mesh cut in two: the numbers of the halves add up to that of the whole.
TEST(WindingProperty, OfTwoHalvesAddsUp) {
  check_property("winding/halves", [](std::uint64_t seed) {
    Rng rng(seed);
    Mesh mesh = any_triangles(rng);
    const Pose pose = winding_pose(rng, mesh);
    Mesh first = mesh;
    Mesh second = mesh;
    const auto cut = static_cast<std::ptrdiff_t>(rng.below(mesh.triangles.size()));
    first.triangles.erase(first.triangles.begin() + cut, first.triangles.end());
    second.triangles.erase(second.triangles.begin(), second.triangles.begin() + cut);
    const WindingIndex whole{Body(mesh, pose)};
    const WindingIndex a{Body(first, pose)};
    const WindingIndex b{Body(second, pose)};
    for (const Vec3& p : winding_points(rng, whole.body(), 20)) {
      const Bracket one = winding(a, p).number;
      const Bracket two = winding(b, p).number;
      RC_ASSERT(meet(winding(whole, p).number,
                     {one.lower + two.lower - 1e-14, one.upper + two.upper + 1e-14}));
    }
  });
}

// Each part of several closed meshes, as a body of its own.
TEST(ContainsPartsProperty, AnswersAsEachPartAlone) {
  std::size_t inside = 0;
  check_property("contains/parts", [&](std::uint64_t seed) {
    Rng rng(seed);
    Mesh mesh;
    std::vector<Mesh> alone;
    for (std::uint64_t k = 0, count = 1 + rng.below(4); k < count; ++k) {
      Mesh part = test::closed_mesh(rng, 3);
      if (rng.below(4) == 0) {
        part.triangles.pop_back();
      }
      part.parts.clear();
      part.faces.clear();
      part.source = "part";
      append(mesh, part);
      alone.push_back(part);
    }
    const Pose pose = winding_pose(rng, mesh);
    const DividedBody body(Body(mesh, pose));
    RC_ASSERT(body.parts().size() == alone.size());
    const std::vector<Vec3> points = winding_points(rng, body.body(), 20);
    const ContainsPartsBatch batch = contains(body, points);
    for (std::uint32_t k = 0; k < alone.size(); ++k) {
      const bool closed = closedness(alone[k], {.pose = pose}).whole.closed;
      RC_ASSERT(body.parts()[k].closed == closed);
      // Whether it is closed or not, brute force tells where a point is on it.
      const std::vector<Side> sides =
          reference::contains_by_brute_force(Body(alone[k], pose), points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto row = batch.parts_of(i);
        const auto found = std::find_if(row.begin(), row.end(),
                                        [&](const PartSide& side) { return side.part == k; });
        const Side side = found == row.end() ? Side::outside : found->side;
        RC_ASSERT(side == (closed || sides[i] == Side::on ? sides[i] : Side::outside));
        inside += side == Side::inside ? 1 : 0;
      }
    }
  });
  EXPECT_GT(inside, 300U);
}

}  // namespace
}  // namespace soms

#include "soms/thesis/posed_boxes.h"

#include "soms/tree/build.h"

#include "tests/support/support.h"
#include "tests/thesis/cases.h"

#include <cmath>
#include <limits>
#include <vector>

namespace soms {
namespace {

/// Bounds of a node's moved triangles, one by one.
Box exact_bounds(const Mesh& mesh, const Tree& tree, const Node& node, const Pose& pose) {
  Box box;
  for (const TriangleId i : tree.triangles_of(node)) {
    const Triangle t = mesh.triangle(i);
    box.grow(pose.apply(t.a));
    box.grow(pose.apply(t.b));
    box.grow(pose.apply(t.c));
  }
  return box;
}

/// A number of any size: from 2^-1060 to 2^290, or zero.
double any_size(Rng& rng) {
  if (rng.below(8) == 0) {
    return 0;
  }
  return std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(1350)) - 1060);
}

/// A body, a valid tree and a pose; sizes from usual to absurd.
struct Moved {
  explicit Moved(Rng& rng)
      : kind(test::kKinds[rng.below(test::kKinds.size())]),
        mesh(test::body(rng, kind, 1 + rng.below(30))),
        pose(test::pose(rng, kind, 10)) {
    const auto scale = static_cast<int>(rng.below(4));
    if (scale == 1) {  // far from the origin, where poses round most
      for (Vec3& v : mesh.vertices) {
        v += {1e8, -3e7, 12345.678};
      }
    } else if (scale == 2) {
      for (Vec3& v : mesh.vertices) {
        v = {any_size(rng), any_size(rng), any_size(rng)};
      }
    } else if (scale == 3) {
      pose.m[3] = 1e16;
      pose.m[7] = any_size(rng);
    }
    tree = test::random_tree(rng, mesh, 1 + rng.below(3));
  }

  test::Kind kind;
  Mesh mesh;
  Pose pose;
  Tree tree;
};

TEST(PosedBoxes, RefitToTheBoundsOfTheMovedVertices) {
  test::for_each_case("boxes/refit", 3000, [](Rng& rng) {
    const Moved m(rng);
    PosedBoxes posed(m.mesh, m.tree);
    posed.move(m.pose);
    for (std::size_t i = 0; i < m.tree.nodes.size(); ++i) {
      EXPECT_EQ(posed.boxes()[i], exact_bounds(m.mesh, m.tree, m.tree.nodes[i], m.pose)) << i;
    }
    EXPECT_EQ(posed.vertices()[0], m.pose.apply(m.mesh.vertices[0]));
  });
}

TEST(PosedBoxes, ShiftToTheSameNumbersAsRefit) {
  test::for_each_case("boxes/shift", 3000, [](Rng& rng) {
    const Moved m(rng);
    const Pose shift = Pose::translation(any_size(rng), m.pose.m[7], rng.uniform(-1e9, 1e9));
    PosedBoxes posed(m.mesh, m.tree);
    posed.move(shift);
    for (std::size_t i = 0; i < m.tree.nodes.size(); ++i) {
      EXPECT_EQ(posed.boxes()[i], exact_bounds(m.mesh, m.tree, m.tree.nodes[i], shift)) << i;
    }
  });
}

/// The nearest doubles beyond the bounds of the eight moved corners of a box.
Box corners(const Box& box, const Pose& pose) {
  Box out;
  for (unsigned k = 0; k < 8; ++k) {
    out.grow(pose.apply({(k & 1U) != 0 ? box.upper.x : box.lower.x,
                         (k & 2U) != 0 ? box.upper.y : box.lower.y,
                         (k & 4U) != 0 ? box.upper.z : box.lower.z}));
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.lower[axis] = std::nextafter(out.lower[axis], -kInfinity);
    out.upper[axis] = std::nextafter(out.upper[axis], kInfinity);
  }
  return out;
}

TEST(PosedBoxes, ReboxToTheEightMovedCornersAndHoldAllVertices) {
  test::for_each_case("boxes/rebox", 3000, [](Rng& rng) {
    const Moved m(rng);
    PosedBoxes posed(m.mesh, m.tree);
    posed.move(m.pose, BoxUpdate::rebox);
    for (std::size_t i = 0; i < m.tree.nodes.size(); ++i) {
      const Node& node = m.tree.nodes[i];
      if (node.count == 0) {
        EXPECT_TRUE(posed.boxes()[i].empty());
        continue;
      }
      EXPECT_EQ(posed.boxes()[i], corners(node.bounds, m.pose)) << i;
      EXPECT_TRUE(posed.boxes()[i].contains(exact_bounds(m.mesh, m.tree, node, m.pose))) << i;
    }
  });
}

// Two thirds of the coordinate cancel, so the rounding of the products shows.
TEST(PosedBoxes, ReboxHoldsVerticesThatCancel) {
  test::for_each_case("boxes/cancel", 20000, [](Rng& rng) {
    const double angle = rng.uniform(0, 7);
    Pose pose = Pose::about_z(angle);
    Mesh mesh = test::body(rng, test::Kind::random, 1);
    const double far = std::ldexp(1.0, static_cast<int>(rng.below(60)));
    for (Vec3& v : mesh.vertices) {
      v += {far, far, far};
    }
    const Vec3 at = pose.apply(mesh.vertices[0]);
    pose.m[3] = -at.x;
    pose.m[7] = -at.y;
    const Tree tree = test::random_tree(rng, mesh, 1);
    PosedBoxes posed(mesh, tree);
    posed.move(pose, BoxUpdate::rebox);
    EXPECT_TRUE(posed.boxes()[0].contains(exact_bounds(mesh, tree, tree.nodes[0], pose)));
  });
}

TEST(PosedBoxes, FollowEachMoveAndChangeOfWay) {
  Rng rng(1);
  const Mesh mesh = test::body(rng, test::Kind::random, 20);
  const Tree tree = build(mesh);
  PosedBoxes posed(mesh, tree);
  for (int step = 0; step < 20; ++step) {
    const Pose pose = test::pose(rng, test::Kind::random);
    const BoxUpdate update = rng.below(2) == 0 ? BoxUpdate::refit : BoxUpdate::rebox;
    posed.move(pose, update);
    posed.move(pose, update);
    PosedBoxes once(mesh, tree);
    once.move(pose, update);
    EXPECT_EQ(posed.boxes(), once.boxes());
    EXPECT_EQ(posed.vertices(), once.vertices());
  }
}

TEST(PosedBoxes, LeaveAnUnmovedTreeAsItIs) {
  Rng rng(2);
  const Mesh mesh = test::body(rng, test::Kind::lattice, 20);
  const Tree tree = build(mesh);
  PosedBoxes posed(mesh, tree);
  posed.move(Pose::identity());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    EXPECT_EQ(posed.boxes()[i], tree.nodes[i].bounds);
  }
  EXPECT_EQ(posed.vertices(), mesh.vertices);
}

}  // namespace
}  // namespace soms

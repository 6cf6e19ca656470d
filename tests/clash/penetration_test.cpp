// How far convex parts go into each other.
#include "soms/clash/penetration.h"

#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/generate/shapes.h"
#include "soms/query/solid.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace soms {
namespace {

using test::box_body;

PartBody convex_part(const Mesh& mesh, const Pose& pose = {}) {
  return part_bodies(mesh, pose).at(0);
}

std::optional<Penetration> between(const PartBody& a, const PartBody& b) {
  const std::optional<ConvexPart> convex_a = ConvexPart::of(a);
  const std::optional<ConvexPart> convex_b = ConvexPart::of(b);
  return convex_a && convex_b ? penetration(*convex_a, *convex_b) : std::nullopt;
}

TEST(Penetration, OfBoxesIsTheLeastOverlap) {
  const PartBody slab = convex_part(box_body({0, 0, 0}, {10, 10, 1}));
  const std::optional<Penetration> found =
      between(slab, convex_part(box_body({4, 4, 0.75}, {5, 5, 3})));
  ASSERT_TRUE(found);
  EXPECT_GE(found->depth, 0.25);
  EXPECT_LE(found->depth, 0.25 + 1e-13);
  EXPECT_EQ(found->direction, (Vec3{0, 0, 1}));
  const std::optional<Penetration> back =
      between(convex_part(box_body({4, 4, 0.75}, {5, 5, 3})), slab);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->direction, (Vec3{0, 0, -1}));
}

TEST(Penetration, OfABoxInAnotherIsTheShortestWayOut) {
  const std::optional<Penetration> found = between(convex_part(box_body({0, 0, 0}, {10, 10, 10})),
                                                   convex_part(box_body({7, 4, 4}, {8, 5, 5})));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 3, 1e-12);
  EXPECT_EQ(found->direction, (Vec3{1, 0, 0}));
}

TEST(Penetration, AcrossTwoEdgesIsFound) {
  // Two beams, a quarter turned about their own axes, that cross edge on edge.
  const double half = std::sqrt(0.5);
  const Mesh beam = box_body({-5, -half, -half}, {5, half, half});
  const Pose lower = Pose::from_axis_angle({1, 0, 0}, std::acos(-1.0) / 4);
  const Pose upper = Pose::about_z(std::acos(-1.0) / 2, {0, 0, 1.75}) * lower;
  const std::optional<Penetration> found =
      between(convex_part(beam, lower), convex_part(beam, upper));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->depth, 0.25, 1e-9);
  EXPECT_NEAR(found->direction.z, 1, 1e-9);
}

TEST(Penetration, IsZeroOfPartsThatAreApart) {
  const PartBody box = convex_part(box_body({0, 0, 0}, {1, 1, 1}));
  const std::optional<Penetration> apart =
      between(box, convex_part(box_body({2, 0, 0}, {3, 1, 1})));
  ASSERT_TRUE(apart);
  EXPECT_EQ(apart->depth, 0);
  // Those that touch may cross by less than rounding.
  const std::optional<Penetration> beside =
      between(box, convex_part(box_body({1, 0, 0}, {2, 1, 1})));
  ASSERT_TRUE(beside);
  EXPECT_GT(beside->depth, 0);
  EXPECT_LT(beside->depth, 1e-13);
}

TEST(Penetration, IsNotZeroOfPartsThatCrossByLessThanRounding) {
  const std::optional<Penetration> found =
      between(convex_part(box_body({-1e9, -1e9, -1}, {0, 1e9, 1})),
              convex_part(box_body({-1e-9, -1, -1}, {1e9, 1, 1})));
  ASSERT_TRUE(found);
  EXPECT_GE(found->depth, 1e-9);
  EXPECT_LT(found->depth, 1e-4);
}

TEST(Penetration, IsOfConvexPartsOnly) {
  Mesh open = box_body({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_FALSE(ConvexPart::of(convex_part(open)));
  // Of two boxes each has corners on both sides of a face of the other.
  Mesh two = test::joined(box_body({0, 0, 0}, {1, 1, 1}), box_body({3, 0, 0}, {4, 1, 3}));
  two.parts.clear();
  EXPECT_FALSE(ConvexPart::of(convex_part(two)));
  const std::optional<ConvexPart> box = ConvexPart::of(convex_part(box_body({0, 0, 0}, {1, 2, 3})));
  ASSERT_TRUE(box);
  EXPECT_EQ(box->normals().size(), 3U);
  EXPECT_EQ(box->edges().size(), 3U);
  EXPECT_EQ(box->corners().size(), 8U);
}

TEST(Penetration, IsLeftOutWhereItWouldTakeLong) {
  const PartBody ball = convex_part(generate_sphere(2000));
  ASSERT_TRUE(ConvexPart::of(ball));
  EXPECT_FALSE(between(ball, ball));
  EXPECT_TRUE(between(ball, convex_part(box_body({0, 0, 0}, {1, 1, 1}))));
}

/// Corners on a ball: any of them, so that no two edges are parallel.
Mesh random_tetrahedron(Rng& rng, double scale, const Vec3& origin) {
  Mesh mesh;
  for (int k = 0; k < 4; ++k) {
    mesh.vertices.push_back(origin +
                            scale * Vec3{rng.unit() - 0.5, rng.unit() - 0.5, rng.unit() - 0.5});
  }
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  return mesh;
}

TEST(Penetration, SeparatesAndNoLessDoes) {
  std::uint64_t crossing = 0;
  for (const auto& [scale, origin] : {std::pair(1.0, Vec3{}), std::pair(1.0, Vec3{5e5, -4e5, 30}),
                                      std::pair(0x1p-300, Vec3{}), std::pair(0x1p200, Vec3{})}) {
    test::for_each_case("penetration", 60, [&, s = scale, o = origin](Rng& rng) {
      const PartBody a = convex_part(random_tetrahedron(rng, s, o));
      const PartBody b = convex_part(random_tetrahedron(rng, s, o));
      const std::optional<Penetration> found = between(a, b);
      ASSERT_TRUE(found);
      const auto relation_after = [&](double share) {
        Pose pose;
        const Vec3 by = share * found->depth * found->direction;
        pose.m[3] = by.x;
        pose.m[7] = by.y;
        pose.m[11] = by.z;
        return solid(a.body, Body(b.body.shape, pose)).relation;
      };
      const Relation now = relation_after(0);
      if (now == Relation::clear || now == Relation::touching) {
        EXPECT_LE(found->depth, 1e-9 * s);
        return;
      }
      ++crossing;
      // What moved corners are rounded by is allowed for: relative to where they lie.
      const double slack = 1e-9 * (1 + (std::abs(o.x) + std::abs(o.y)) / s * 1e-6);
      const Relation after = relation_after(1 + slack);
      EXPECT_TRUE(after == Relation::clear || after == Relation::touching) << found->depth;
      // A shorter way in that direction is not enough.
      const Relation before = relation_after(1 - 1e-3);
      EXPECT_TRUE(before != Relation::clear && before != Relation::touching) << found->depth;
    });
  }
  EXPECT_GT(crossing, 20U);
}

TEST(Clashes, SayHowDeepConvexPartsCross) {
  const PartBody slab = convex_part(box_body({0, 0, 0}, {10, 10, 1}));
  const PartBody post = convex_part(box_body({4, 4, 0.75}, {5, 5, 3}));
  const ClashList there = clashes(std::array{slab}, std::array{post});
  const ClashList back = clashes(std::array{post}, std::array{slab});
  ASSERT_TRUE(there.clashes.at(0).penetration && back.clashes.at(0).penetration);
  EXPECT_EQ(there.clashes[0].penetration->direction, (Vec3{0, 0, 1}));
  EXPECT_EQ(back.clashes[0].penetration->direction, (Vec3{0, 0, -1}));
  EXPECT_EQ(there.clashes[0].penetration->depth, back.clashes[0].penetration->depth);
  const PartBody above = convex_part(box_body({4, 4, 1}, {5, 5, 3}));
  EXPECT_FALSE(clashes(std::array{slab}, std::array{above}).clashes.at(0).penetration);
}

}  // namespace
}  // namespace soms

// What is decided of open parts, and what is not.
#include "soms/clash/detail/open_parts.h"

#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/geometry/triangle_overlap.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::box_body;

/// An edge of one triangle goes through the inside of the other, whose bodies have no others.
bool pass_through(const Triangle& s, const Triangle& t) {
  const detail::TriangleLoop none = [](const auto&) { return true; };
  return detail::edge_crosses(s, t, none, none) || detail::edge_crosses(t, s, none, none);
}

PartBody part_of(const Mesh& mesh) {
  return part_bodies(mesh).at(0);
}

PartBody open_box(const Vec3& lower, const Vec3& upper) {
  Mesh box = box_body(lower, upper);
  box.triangles.pop_back();
  return part_of(box);
}

std::optional<Clash> clash_of(const PartBody& a, const PartBody& b) {
  const ClashList list = clashes(std::array{a}, std::array{b});
  return list.clashes.empty() ? std::nullopt : std::optional(list.clashes.front());
}

ClashKind kind_of_pair(const PartBody& a, const PartBody& b) {
  const std::optional<Clash> there = clash_of(a, b);
  const std::optional<Clash> back = clash_of(b, a);
  EXPECT_TRUE(there && back);
  if (!there || !back) {
    return ClashKind::near;
  }
  EXPECT_EQ(there->kind, back->kind);
  return there->kind;
}

/// Two boxes that are one part.
Mesh two_boxes(const Vec3& first, const Vec3& second) {
  const Vec3 one{1, 1, 1};
  Mesh mesh = test::joined(box_body(first, first + one), box_body(second, second + one));
  mesh.parts.clear();
  return mesh;
}

/// Whole numbers of a corner, for arithmetic without rounding.
struct Whole {
  std::int64_t x, y, z;
};

Whole whole(const Vec3& v) {
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y),
          static_cast<std::int64_t>(v.z)};
}

Whole operator-(const Whole& v, const Whole& w) {
  return {v.x - w.x, v.y - w.y, v.z - w.z};
}

Whole cross_of(const Whole& v, const Whole& w) {
  return {v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x};
}

std::int64_t dot_of(const Whole& v, const Whole& w) {
  return v.x * w.x + v.y * w.y + v.z * w.z;
}

/// Whether the segment from p to q goes through the inside of a triangle: the point where it meets
/// the plane, over a common denominator, lies on the inner side of each edge.
bool goes_through(const Whole& p, const Whole& q, const std::array<Whole, 3>& t) {
  const Whole normal = cross_of(t[1] - t[0], t[2] - t[0]);
  const std::int64_t from = dot_of(normal, p - t[0]);
  const std::int64_t to = dot_of(normal, q - t[0]);
  if ((from <= 0 || to >= 0) && (from >= 0 || to <= 0)) {
    return false;
  }
  // The point is (p * -to + q * from) / (from - to).
  const std::int64_t over = from - to;
  for (std::size_t k = 0; k < 3; ++k) {
    const Whole& corner = t[k];
    const Whole d = p - corner;
    const Whole e = q - corner;
    const Whole point{d.x * -to + e.x * from, d.y * -to + e.y * from, d.z * -to + e.z * from};
    const Whole inward = cross_of(normal, t[(k + 1) % 3] - corner);
    const std::int64_t side = dot_of(inward, point);
    if (over > 0 ? side <= 0 : side >= 0) {
      return false;
    }
  }
  return true;
}

bool pass_through_in_whole_numbers(const Triangle& s, const Triangle& t) {
  const std::array of_s{whole(s.a), whole(s.b), whole(s.c)};
  const std::array of_t{whole(t.a), whole(t.b), whole(t.c)};
  const auto has_area = [](const std::array<Whole, 3>& c) {
    const Whole normal = cross_of(c[1] - c[0], c[2] - c[0]);
    return dot_of(normal, normal) != 0;
  };
  if (!has_area(of_s) || !has_area(of_t)) {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (goes_through(of_s[k], of_s[(k + 1) % 3], of_t) ||
        goes_through(of_t[k], of_t[(k + 1) % 3], of_s)) {
      return true;
    }
  }
  return false;
}

TEST(PassThrough, IsThatOfWholeNumbers) {
  std::uint64_t through = 0;
  std::uint64_t meeting_only = 0;
  test::for_each_case("pass through", 20000, [&](Rng& rng) {
    const std::uint64_t size = 2 + rng.below(5);
    const auto corner = [&] {
      return Vec3{static_cast<double>(rng.below(size)), static_cast<double>(rng.below(size)),
                  static_cast<double>(rng.below(size))};
    };
    const Triangle s{corner(), corner(), corner()};
    const Triangle t{corner(), corner(), corner()};
    const bool expected = pass_through_in_whole_numbers(s, t);
    EXPECT_EQ(pass_through(s, t), expected);
    EXPECT_EQ(pass_through(t, s), expected);
    const bool meet = triangles_overlap(s, t);
    EXPECT_TRUE(meet || !expected);
    through += expected ? 1 : 0;
    meeting_only += meet && !expected ? 1 : 0;
  });
  EXPECT_GT(through, 0U);
  EXPECT_GT(meeting_only, 0U);
}

TEST(PassThrough, NeedsMoreThanATouch) {
  const Triangle floor{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  // A corner on it; an edge in it; an edge through its own edge; one step above.
  EXPECT_FALSE(pass_through(floor, {{1, 1, 0}, {1, 1, 3}, {2, 1, 3}}));
  EXPECT_FALSE(pass_through(floor, {{1, 1, 0}, {2, 1, 0}, {1, 1, 3}}));
  EXPECT_FALSE(pass_through(floor, {{1, 0, -1}, {1, 0, 1}, {1, -2, 0}}));
  EXPECT_TRUE(pass_through(floor, {{1, 1, -1}, {1, 1, 3}, {2, 1, 3}}));
  EXPECT_FALSE(pass_through(floor, {{1, 1, 0x1p-1074}, {1, 1, 3}, {2, 1, 3}}));
  // A triangle without area bounds nothing.
  EXPECT_FALSE(pass_through(floor, {{1, 1, -1}, {1, 1, 3}, {1, 1, 1}}));
}

TEST(OpenParts, CrossWhereSurfacesPassThroughEachOther) {
  const PartBody open = open_box({0, 0, 0}, {4, 4, 4});
  EXPECT_EQ(kind_of_pair(open, part_of(box_body({3, 1, 1}, {5, 2, 2}))), ClashKind::crossing);
  EXPECT_EQ(kind_of_pair(open, open_box({3, 1, 1}, {5, 2, 2})), ClashKind::crossing);
  const std::optional<Clash> clash = clash_of(open, open_box({3, 1, 1}, {5, 2, 2}));
  ASSERT_TRUE(clash);
  EXPECT_EQ(clash->relation, Relation::crossing);
  EXPECT_EQ(clash->why, Undecided::none);
}

TEST(OpenParts, AreUndecidedWhereSurfacesOnlyTouch) {
  const PartBody open = open_box({0, 0, 0}, {4, 4, 4});
  const std::optional<Clash> clash = clash_of(open, part_of(box_body({4, 0, 0}, {5, 4, 4})));
  ASSERT_TRUE(clash);
  EXPECT_EQ(clash->kind, ClashKind::undecided);
  EXPECT_EQ(clash->why, Undecided::open);
  EXPECT_GT(clash->triangle_pairs, 0U);
}

TEST(OpenParts, AreInsideAClosedPart) {
  const PartBody solid = part_of(box_body({0, 0, 0}, {4, 4, 4}));
  const PartBody open = open_box({1, 1, 1}, {2, 2, 2});
  const std::optional<Clash> clash = clash_of(solid, open);
  ASSERT_TRUE(clash);
  EXPECT_EQ(clash->kind, ClashKind::inside);
  EXPECT_EQ(clash->relation, Relation::b_in_a);
  EXPECT_EQ(clash->box, (Box{{1, 1, 1}, {2, 2, 2}}));
  EXPECT_EQ(clash_of(open, solid)->relation, Relation::a_in_b);
}

TEST(OpenParts, CrossWhereSomeOfTheirComponentsAreInside) {
  Mesh two = two_boxes({1, 1, 1}, {6, 1, 1});
  two.triangles.pop_back();
  const PartBody open = part_of(two);
  ASSERT_EQ(open.components.size(), 2U);
  EXPECT_EQ(kind_of_pair(part_of(box_body({0, 0, 0}, {4, 4, 4})), open), ClashKind::crossing);
}

TEST(OpenParts, EncloseNothingOutsideTheirBox) {
  const PartBody open = open_box({0, 0, 0}, {4, 4, 4});
  // Boxes meet, in a corner that the other's surface leaves out, and neither holds the other.
  Mesh wedge;
  wedge.vertices = {{5, 5, 3}, {5, 3.5, 5}, {3.5, 5, 5}, {6, 6, 6}};
  wedge.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const PartBody closed = part_of(wedge);
  ASSERT_TRUE(closed.closed && overlaps(closed.box(), open.box()));
  EXPECT_FALSE(clash_of(open, closed));
  EXPECT_FALSE(clash_of(closed, open));
  // A component wholly in the box may be inside.
  EXPECT_EQ(kind_of_pair(open, part_of(box_body({1, 1, 1}, {2, 2, 2}))), ClashKind::undecided);
  EXPECT_EQ(kind_of_pair(open, part_of(two_boxes({1, 1, 1}, {6, 1, 1}))), ClashKind::undecided);
}

/// One part of several meshes.
PartBody joined_part(const std::vector<Mesh>& meshes) {
  Mesh all = meshes.front();
  for (std::size_t k = 1; k < meshes.size(); ++k) {
    all = test::joined(all, meshes[k]);
  }
  all.parts.clear();
  return part_of(all);
}

Mesh without_last(Mesh mesh) {
  mesh.triangles.pop_back();
  return mesh;
}

Mesh turned_over(Mesh mesh) {
  for (auto& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

// Two boxes that are glued together have a face twice, which bounds nothing.
TEST(OpenParts, AreNotCrossedByWhatBoundsNothing) {
  const PartBody glued =
      joined_part({box_body({0, 0, 0}, {2, 4, 4}), box_body({2, 0, 0}, {4, 4, 4})});
  ASSERT_TRUE(glued.closed);
  EXPECT_EQ(kind_of_pair(glued, part_of(box_body({1, 1, 1}, {3, 2, 2}))), ClashKind::inside);
  EXPECT_EQ(kind_of_pair(glued, open_box({1, 1, 1}, {3, 2, 2})), ClashKind::undecided);
  // Out of the far side it does cross.
  EXPECT_EQ(kind_of_pair(glued, open_box({1, 1, 1}, {5, 2, 2})), ClashKind::crossing);
}

TEST(OpenParts, DoNotCrossADoubledSheet) {
  Mesh fin;
  fin.vertices = {{1, 0, 0}, {3, 0, 0}, {1, 0, 2}};
  fin.triangles = {{0, 1, 2}, {0, 2, 1}};
  const PartBody finned = joined_part({box_body({0, 0, 0}, {1, 1, 1}), fin});
  Mesh through;
  through.vertices = {{1.5, -1, 0.25}, {1.5, 1, 0.25}, {1.5, 1, 0.75}};
  through.triangles = {{0, 1, 2}};
  EXPECT_EQ(kind_of_pair(finned, part_of(through)), ClashKind::undecided);
  // The sheet through an open box: it has an edge through a face, and bounds nothing.
  const PartBody open_fin = joined_part({without_last(box_body({8, 0, 0}, {9, 1, 1})), fin});
  EXPECT_EQ(kind_of_pair(open_fin, part_of(box_body({2, -1, 0.25}, {2.5, 1, 0.5}))),
            ClashKind::undecided);
}

TEST(OpenParts, MayBeEnteredThroughAnOpening) {
  Mesh tank = box_body({0, 0, 0}, {4, 4, 4});
  const auto on_lid = [&](const std::array<std::uint32_t, 3>& t) {
    return tank.vertices[t[0]].z == 4 && tank.vertices[t[1]].z == 4 && tank.vertices[t[2]].z == 4;
  };
  const PartBody pipe = part_of(box_body({1.5, 1.5, 2}, {2.5, 2.5, 6}));
  EXPECT_EQ(kind_of_pair(part_of(tank), pipe), ClashKind::crossing);
  std::erase_if(tank.triangles, on_lid);
  ASSERT_EQ(tank.triangles.size(), 10U);
  const PartBody open = part_of(tank);
  EXPECT_EQ(open.caps.shape.mesh().triangles.size(), 4U);
  EXPECT_EQ(open.caps.shape.bounds(), (Box{{0, 0, 4}, {4, 4, 4}}));
  EXPECT_EQ(kind_of_pair(open, pipe), ClashKind::undecided);
  // Beside the opening a part is clear.
  EXPECT_FALSE(clash_of(open, part_of(box_body({5, 1, 1}, {6, 2, 6}))));
  EXPECT_TRUE(part_of(box_body({0, 0, 0}, {1, 1, 1})).caps.shape.mesh().triangles.empty());
}

TEST(OpenParts, HaveACapForEachOpening) {
  Mesh box = box_body({0, 0, 0}, {4, 4, 4});
  const auto on_side = [&](double x) {
    return [&box, x](const std::array<std::uint32_t, 3>& t) {
      return box.vertices[t[0]].x == x && box.vertices[t[1]].x == x && box.vertices[t[2]].x == x;
    };
  };
  std::erase_if(box.triangles, on_side(0));
  std::erase_if(box.triangles, on_side(4));
  const PartBody open = part_of(box);
  const MeshView& caps = open.caps.shape.mesh();
  ASSERT_EQ(caps.triangles.size(), 8U);
  for (TriangleId i = 0; i < 8; ++i) {
    const Triangle cap = caps.triangle(i);
    EXPECT_TRUE(cap.c == (Vec3{0, 2, 2}) || cap.c == (Vec3{4, 2, 2})) << i;
    EXPECT_EQ(cap.a.x, cap.c.x);
    EXPECT_EQ(cap.b.x, cap.c.x);
  }
  // With its caps it is closed.
  EXPECT_TRUE(joined_part({Mesh(box), Mesh(caps)}).closed);
}

// An open shell in the wall of a hollow box, around its cavity: closed, it crosses the wall.
TEST(OpenParts, MayGoAroundACavity) {
  const PartBody hollow =
      joined_part({box_body({0, 0, 0}, {10, 10, 10}), turned_over(box_body({4, 4, 4}, {6, 6, 6}))});
  EXPECT_EQ(kind_of_pair(hollow, part_of(box_body({3, 3, 3}, {7, 7, 7}))), ClashKind::crossing);
  EXPECT_EQ(kind_of_pair(hollow, open_box({3, 3, 3}, {7, 7, 7})), ClashKind::undecided);
  EXPECT_EQ(kind_of_pair(hollow, open_box({1, 1, 1}, {2, 2, 2})), ClashKind::inside);
}

}  // namespace
}  // namespace soms

// Parts that stay open together enclose something together: what may be in there is not clear.
#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/geometry/bodies_of.h"

#include "tests/clash/tray.h"
#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::tray;

Mesh probe(const Vec3& middle, double half) {
  const Vec3 by{half, half, half};
  Mesh box = box_body(middle - by, middle + by);
  box.parts = {
      {.name = "probe", .first = 0, .count = static_cast<std::uint32_t>(box.triangles.size())}};
  return box;
}

Mesh with(Mesh mesh, const Mesh& more) {
  append(mesh, more);
  return mesh;
}

constexpr Vec3 kLow{0, 0, 0};
constexpr Vec3 kHigh{4, 4, 4};

TEST(OpenGroups, AreSharedByTheirParts) {
  const Mesh mesh = with(probe({9, 9, 9}, 1), tray(kLow, kHigh));
  const std::vector<PartBody> parts = part_bodies(mesh);
  ASSERT_EQ(parts.size(), 6U);
  EXPECT_FALSE(parts[0].together.body);
  EXPECT_TRUE(parts[0].leads());
  ASSERT_TRUE(parts[1].together.body);
  const PartBody& whole = *parts[1].together.body;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    EXPECT_EQ(parts[k].together.body.get(), &whole);
    EXPECT_EQ(parts[k].leads(), k == 1);
    EXPECT_TRUE(parts[k].joined.empty());
  }
  EXPECT_EQ(whole, part_bodies(mesh, {}, {}, OpenParts::joined).at(1));
  EXPECT_EQ(parts, part_bodies(mesh, {}, {.threads = 3}));
  EXPECT_NE(parts[1].together, parts[0].together);
}

TEST(OpenGroups, AreThoseOfBodies) {
  const Mesh mesh = with(tray(kLow, kHigh), tray({5, 0, 0}, {6, 1, 1}));
  const std::vector<PartBody> parts = part_bodies(mesh);
  const std::vector<PartGroup> groups = bodies_of(mesh);
  ASSERT_EQ(groups.size(), 2U);
  for (const PartBody& part : parts) {
    ASSERT_TRUE(part.together.body);
    std::vector<std::uint32_t> named{part.together.body->part};
    named.insert(named.end(), part.together.body->joined.begin(), part.together.body->joined.end());
    EXPECT_EQ(std::count_if(groups.begin(), groups.end(),
                            [&](const PartGroup& group) { return group.parts == named; }),
              1);
  }
}

void expect_undecided(const ClashList& list, std::uint32_t a, std::uint32_t b) {
  ASSERT_EQ(list.clashes.size(), 1U);
  const Clash& clash = list.clashes.front();
  EXPECT_EQ(clash.a, a);
  EXPECT_EQ(clash.b, b);
  EXPECT_EQ(clash.kind, ClashKind::undecided);
  EXPECT_EQ(clash.relation, Relation::undecided);
  EXPECT_EQ(clash.why, Undecided::open);
  EXPECT_EQ(clash.triangle_pairs, 0U);
  EXPECT_GT(clash.gap.lower, 0.0);
  EXPECT_FALSE(clash.box.empty());
}

/// Rows but for those of parts that share an edge.
ClashList without_own(ClashList list, const std::vector<PartBody>& parts) {
  std::erase_if(list.clashes, [&](const Clash& clash) {
    return parts[clash.a].together.body && parts[clash.a].together == parts[clash.b].together;
  });
  return list;
}

TEST(OpenGroups, MayHoldWhatNoneOfTheirPartsReaches) {
  const std::vector<PartBody> box = part_bodies(tray(kLow, kHigh));
  const std::vector<PartBody> inner = part_bodies(probe({2, 2, 2}, 0.5));
  expect_undecided(clashes(box, inner), 0, 0);
  expect_undecided(clashes(inner, box), 0, 0);
  EXPECT_EQ(clashes(box, inner).clashes[0].gap, (Bracket{1.5, 1.5}));
  const std::vector<PartBody> set = part_bodies(with(tray(kLow, kHigh), probe({2, 2, 2}, 0.5)));
  expect_undecided(without_own(clashes(set), set), 0, 5);
  // The lesser number is first, whichever of the two is the group.
  const std::vector<PartBody> other = part_bodies(with(probe({2, 2, 2}, 0.5), tray(kLow, kHigh)));
  expect_undecided(without_own(clashes(other), other), 0, 1);
}

TEST(OpenGroups, ReachThroughTheirOpening) {
  const std::vector<PartBody> box = part_bodies(tray(kLow, kHigh));
  const Mesh pipe = box_body({1.5, 1.5, 2}, {2.5, 2.5, 6});
  expect_undecided(clashes(box, part_bodies(pipe)), 0, 0);
  EXPECT_TRUE(clashes(box, part_bodies(box_body({1.5, 1.5, 4.5}, {2.5, 2.5, 6}))).clashes.empty());
  EXPECT_TRUE(clashes(box, part_bodies(probe({9, 2, 2}, 0.5))).clashes.empty());
}

TEST(OpenGroups, AddNothingToWhatTheirPartsSay) {
  const std::vector<PartBody> box = part_bodies(tray(kLow, kHigh));
  // Through one wall: that wall alone.
  const ClashList through = clashes(box, part_bodies(box_body({3, 1, 1}, {5, 2, 2})));
  ASSERT_EQ(through.clashes.size(), 1U);
  EXPECT_EQ(through.clashes[0].kind, ClashKind::crossing);
  // All of it in a closed one: each part is inside.
  const ClashList inside = clashes(box, part_bodies(box_body({-1, -1, -1}, {5, 5, 5})));
  ASSERT_EQ(inside.clashes.size(), 5U);
  for (const Clash& clash : inside.clashes) {
    EXPECT_EQ(clash.relation, Relation::a_in_b);
  }
  // In the box of an open part of one piece: it is the other that may hold it.
  Mesh open = box_body({-1, -1, -1}, {5, 5, 5});
  open.triangles.pop_back();
  EXPECT_EQ(clashes(box, part_bodies(open)).clashes.size(), 5U);
  // With a lid, they are closed, and no group.
  const ClashList closed =
      clashes(part_bodies(tray(kLow, kHigh, true)), part_bodies(probe({2, 2, 2}, 0.5)));
  ASSERT_EQ(closed.clashes.size(), 1U);
  EXPECT_EQ(closed.clashes[0].kind, ClashKind::inside);
}

TEST(OpenGroups, LeaveNoPairNearThatMayBeInside) {
  const std::vector<PartBody> box = part_bodies(tray(kLow, kHigh));
  const ClashOptions near{.within = 0.25};
  // The first part is the wall at x = 0.
  expect_undecided(clashes(box, part_bodies(probe({0.75, 2, 2}, 0.5)), near), 0, 0);
  const ClashList on_floor = clashes(box, part_bodies(probe({2, 2, 0.75}, 0.5)), near);
  ASSERT_EQ(on_floor.clashes.size(), 2U);
  EXPECT_EQ(on_floor.clashes[0].kind, ClashKind::undecided);
  EXPECT_EQ(on_floor.clashes[1].kind, ClashKind::near);
  EXPECT_EQ(on_floor.clashes[1].a, 4U);
  const ClashList beside = clashes(box, part_bodies(probe({4.75, 2, 2}, 0.5)), near);
  ASSERT_EQ(beside.clashes.size(), 1U);
  EXPECT_EQ(beside.clashes[0].kind, ClashKind::near);
}

TEST(OpenGroups, HoldEachOtherOnce) {
  const std::vector<PartBody> outer = part_bodies(tray(kLow, kHigh));
  const std::vector<PartBody> inner = part_bodies(tray({1, 1, 1}, {3, 3, 3}));
  expect_undecided(clashes(outer, inner), 0, 0);
  const std::vector<PartBody> set =
      part_bodies(with(tray({1, 1, 1}, {3, 3, 3}), tray(kLow, kHigh)));
  expect_undecided(without_own(clashes(set), set), 0, 5);
}

/// No pair is looked at only because both are of one group, or of the box around one.
TEST(OpenGroups, AddFewCandidates) {
  const std::vector<PartBody> outer = part_bodies(tray(kLow, kHigh));
  const std::vector<PartBody> inner = part_bodies(tray({1, 1, 1}, {3, 3, 3}));
  EXPECT_EQ(clash_candidates(outer, inner), (std::vector<PartNumbers>{{0, 0}}));
  // Walls that face each other do not meet.
  EXPECT_EQ(clash_candidates(outer).size(), 8U);
}

TEST(OpenGroups, AreLookedAtWithTheirFirstPart) {
  const std::vector<PartBody> box = part_bodies(tray(kLow, kHigh));
  const std::vector<PartBody> inner = part_bodies(probe({2, 2, 2}, 0.5));
  for (std::uint32_t wanted = 0; wanted < box.size(); ++wanted) {
    const ClashOptions options{
        .wanted = [&](std::uint32_t a, std::uint32_t) { return a == wanted; }};
    EXPECT_EQ(clashes(box, inner, options).clashes.size(), wanted == 0 ? 1U : 0U);
  }
}

}  // namespace
}  // namespace soms

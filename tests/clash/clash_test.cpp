#include "soms/clash/clash.h"

#include "soms/base/error.h"
#include "soms/clash/print.h"
#include "soms/io/read_mesh.h"
#include "soms/query/overlap.h"

#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <array>
#include <chrono>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

using test::box_body;

Mesh read_part_file(const std::string& name, UpAxis up = UpAxis::z) {
  return transformed(read_mesh(test::data("clash/" + name)), 1, up);
}

PartBody part_of_mesh(const Mesh& mesh) {
  return part_bodies(mesh).at(0);
}

/// The one clash of two parts.
Clash only_clash(const PartBody& a, const PartBody& b, const ClashOptions& options = {}) {
  const ClashList list = clashes(std::array{a}, std::array{b}, options);
  EXPECT_EQ(list.clashes.size(), 1U);
  return list.clashes.at(0);
}

TEST(Clashes, OfSpecialCasesAreAsTheirReadmeSays) {
  const std::vector<PartBody> a = part_bodies(read_part_file("special.obj"));
  const std::vector<PartBody> b = part_bodies(read_part_file("special_b.obj"));
  const ClashList list = clashes(a, b, {.within = 0.01});
  std::map<std::pair<std::string, std::string>, Clash> found;
  for (const Clash& clash : list.clashes) {
    found[{a[clash.a].body.name, b[clash.b].body.name}] = clash;
  }
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ((found[{"Slab", "Stands on slab"}].kind), ClashKind::touching);
  EXPECT_EQ((found[{"Slab", "Crosses slab"}].kind), ClashKind::crossing);
  EXPECT_EQ((found[{"Twin", "Twin again"}].kind), ClashKind::same);
  const Clash& in_slab = found[{"Slab", "In slab"}];
  EXPECT_EQ(in_slab.kind, ClashKind::inside);
  EXPECT_EQ(in_slab.relation, Relation::b_in_a);
  EXPECT_EQ(in_slab.triangle_pairs, 0U);
  EXPECT_GT(in_slab.gap.lower, 0);
  const Clash& near_post = found[{"Post", "Near post"}];
  EXPECT_EQ(near_post.kind, ClashKind::near);
  EXPECT_EQ(near_post.gap, (Bracket{31.001 - 31, 31.001 - 31}));
  EXPECT_EQ(near_post.triangle_pairs, 0U);
}

TEST(Clashes, ArePairsOfPartsThatOverlap) {
  const Mesh structure = read_part_file("structure.obj");
  const Mesh services = read_part_file("services.gltf", UpAxis::y);
  const std::vector<PartBody> a = part_bodies(structure);
  const std::vector<PartBody> b = part_bodies(services);
  EXPECT_EQ(a.size(), 166U);
  EXPECT_EQ(b.size(), 72U);
  const ClashList list = clashes(a, b, {}, {.threads = 2});
  EXPECT_EQ(list.coverage, Coverage::complete);

  std::map<PartNumbers, std::uint64_t> expected;
  std::map<TriangleId, std::uint32_t> part_a;
  std::map<TriangleId, std::uint32_t> part_b;
  for (std::uint32_t k = 0; k < a.size(); ++k) {
    for (const TriangleId i : a[k].triangles) {
      part_a[i] = k;
    }
  }
  for (std::uint32_t k = 0; k < b.size(); ++k) {
    for (const TriangleId i : b[k].triangles) {
      part_b[i] = k;
    }
  }
  for (const TrianglePair& pair : overlap(Body(structure), Body(services)).pairs) {
    ++expected[{part_a[pair.a], part_b[pair.b]}];
  }
  ASSERT_EQ(expected.size(), 260U);
  std::uint64_t with_contact = 0;
  for (const Clash& clash : list.clashes) {
    EXPECT_NE(clash.kind, ClashKind::undecided);
    if (clash.triangle_pairs > 0) {
      ++with_contact;
      EXPECT_EQ(clash.triangle_pairs, (expected[{clash.a, clash.b}]));
      EXPECT_EQ(clash.gap, (Bracket{0, 0}));
    } else {
      EXPECT_EQ(clash.kind, ClashKind::inside);
    }
  }
  EXPECT_EQ(with_contact, 260U);
}

TEST(Clashes, AreTheSameFromTheOtherSide) {
  const std::vector<PartBody> a = part_bodies(read_part_file("special.obj"));
  const std::vector<PartBody> b = part_bodies(read_part_file("special_b.obj"));
  const ClashOptions options{.within = 0.01};
  std::map<PartNumbers, Clash> there;
  for (const Clash& clash : clashes(a, b, options).clashes) {
    there[{clash.a, clash.b}] = clash;
  }
  const ClashList back = clashes(b, a, options);
  ASSERT_EQ(back.clashes.size(), there.size());
  for (const Clash& clash : back.clashes) {
    const Clash& other = there[{clash.b, clash.a}];
    EXPECT_EQ(clash.kind, other.kind);
    EXPECT_EQ(clash.relation == Relation::a_in_b, other.relation == Relation::b_in_a);
    EXPECT_EQ(clash.triangle_pairs, other.triangle_pairs);
    EXPECT_EQ(clash.gap, other.gap);
    EXPECT_EQ(clash.box, other.box);
    EXPECT_EQ(clash.place, other.place);
  }
}

TEST(Clashes, OfAnOpenPartAreUndecidedWhereTheOtherMayBeInside) {
  Mesh open_box = box_body({0, 0, 0}, {4, 4, 4});
  open_box.triangles.pop_back();
  const PartBody open = part_of_mesh(open_box);
  const PartBody inside = part_of_mesh(box_body({1, 1, 1}, {2, 2, 2}));
  const Clash apart = only_clash(open, inside);
  EXPECT_EQ(apart.kind, ClashKind::undecided);
  EXPECT_EQ(apart.why, Undecided::open);
  EXPECT_EQ(apart.triangle_pairs, 0U);
  EXPECT_EQ(apart.gap, (Bracket{1, 1}));

  const PartBody beside = part_of_mesh(box_body({5, 0, 0}, {6, 1, 1}));
  EXPECT_TRUE(clashes(std::array{open}, std::array{beside}).clashes.empty());
  EXPECT_EQ(only_clash(open, beside, {.within = 1}).kind, ClashKind::near);
  EXPECT_TRUE(
      clashes(std::array{open}, std::array{beside}, {.within = 1 - 0x1p-53}).clashes.empty());
}

TEST(Clashes, HaveTheirPlaceInTheirBox) {
  const Clash crossing = only_clash(part_of_mesh(box_body({0, 0, 0}, {10, 10, 1})),
                                    part_of_mesh(box_body({4, 4, -3}, {5, 5, 3})));
  EXPECT_EQ(crossing.kind, ClashKind::crossing);
  EXPECT_TRUE((Box{{3.999, 3.999, -0.001}, {5.001, 5.001, 1.001}}.contains(crossing.box)));
  EXPECT_TRUE(crossing.box.contains(Box{crossing.place, crossing.place}));

  const Clash inside = only_clash(part_of_mesh(box_body({0, 0, 0}, {10, 10, 10})),
                                  part_of_mesh(box_body({4, 4, 4}, {5, 5, 5})));
  EXPECT_EQ(inside.kind, ClashKind::inside);
  EXPECT_EQ(inside.box, (Box{{4, 4, 4}, {5, 5, 5}}));

  const Clash near = only_clash(part_of_mesh(box_body({0, 0, 0}, {1, 1, 1})),
                                part_of_mesh(box_body({3, 0, 0}, {4, 1, 1})), {.within = 2});
  EXPECT_EQ(near.place.x, 2);
}

TEST(Clashes, OfOneSetNameEachPairOnce) {
  Mesh mesh;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const double x = k;
    mesh = test::joined(mesh, box_body({x, 0, 0}, {x + 1, 1, 1}));
    mesh.parts.push_back({.name = std::to_string(k), .first = 12 * k, .count = 12});
  }
  const ClashList list = clashes(part_bodies(mesh));
  ASSERT_EQ(list.clashes.size(), 3U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(list.clashes[k].a, k);
    EXPECT_EQ(list.clashes[k].b, k + 1);
    EXPECT_EQ(list.clashes[k].kind, ClashKind::touching);
  }
}

TEST(Clashes, LeaveOutPairsThatAreNotWanted) {
  const std::vector<PartBody> a = part_bodies(read_part_file("special.obj"));
  const std::vector<PartBody> b = part_bodies(read_part_file("special_b.obj"));
  const ClashList list = clashes(
      a, b, {.wanted = [&](std::uint32_t i, std::uint32_t) { return a[i].body.name == "Twin"; }});
  ASSERT_EQ(list.clashes.size(), 1U);
  EXPECT_EQ(list.compared, 1U);
  EXPECT_EQ(list.clashes[0].kind, ClashKind::same);
}

TEST(Clashes, AreCutByADeadline) {
  const std::vector<PartBody> a = part_bodies(read_part_file("special.obj"));
  const std::vector<PartBody> b = part_bodies(read_part_file("special_b.obj"));
  const ClashList list =
      clashes(a, b, {}, {.deadline = std::chrono::steady_clock::time_point::min()});
  EXPECT_EQ(list.coverage, Coverage::cut);
  EXPECT_GT(list.left_out, 0U);
  EXPECT_EQ(list.compared + list.left_out, clash_candidates(a, b).size());
}

TEST(Clashes, RefuseWhatIsNoDistance) {
  for (const double within :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(check(ClashOptions{.within = within}), Error);
    EXPECT_THROW(static_cast<void>(clashes({}, {.within = within})), Error);
  }
  check(ClashOptions{.within = 0});
}

TEST(Clashes, RefusePartsThatAreNotThere) {
  const std::array part{part_of_mesh(box_body({0, 0, 0}, {1, 1, 1}))};
  const std::array pairs{PartNumbers{0, 1}};
  EXPECT_THROW(static_cast<void>(clashes_of(part, part, pairs)), Error);
}

TEST(Clashes, EndWhenAStopIsRequested) {
  const std::vector<PartBody> parts = part_bodies(read_part_file("structure.obj"));
  StopSource stop;
  stop.request_stop();
  EXPECT_THROW(static_cast<void>(clashes(parts, {}, {.stop = stop.get_token()})), Error);
}

TEST(Clashes, OfNothingAreNone) {
  EXPECT_EQ(clashes({}), ClashList());
  EXPECT_EQ(clashes({}, std::array{part_of_mesh(box_body({0, 0, 0}, {1, 1, 1}))}), ClashList());
}

}  // namespace
}  // namespace soms

#include "soms/geometry/bodies_of.h"

#include "soms/base/print.h"
#include "soms/base/random.h"
#include "soms/geometry/print.h"
#include "soms/geometry/reference/bodies_of.h"

#include "tests/support/bodies.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace soms {
namespace {

using test::box_body;
using test::cut_by;

using Groups = std::vector<PartGroup>;

/// Triangles of a box are two a face: which face each is of.
std::vector<std::uint32_t> by_face(std::size_t triangles) {
  std::vector<std::uint32_t> label(triangles);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    label[i] = i / 2;
  }
  return label;
}

Mesh box_in_halves(const Vec3& lower, const Vec3& upper) {
  return cut_by(box_body(lower, upper), {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0}, 2);
}

TEST(BodiesOf, AreAllPartsThatAreClosedAlone) {
  const Mesh mesh = test::joined(box_body({0, 0, 0}, {1, 1, 1}), box_body({1, 0, 0}, {2, 1, 1}));
  Mesh parts = mesh;
  parts.parts = {{.name = "a", .first = 0, .count = 12}, {.name = "b", .first = 12, .count = 12}};
  EXPECT_EQ(bodies_of(parts), (Groups{{{0}, true}, {{1}, true}}));
  parts.parts.pop_back();
  EXPECT_EQ(bodies_of(parts), (Groups{{{0}, true}, {{Part::kNoParent}, true}}));
  parts.parts.clear();
  EXPECT_EQ(bodies_of(parts), (Groups{{{Part::kNoParent}, true}}));
  EXPECT_EQ(bodies_of(Mesh()), Groups{});
}

TEST(BodiesOf, JoinPartsThatCloseEachOther) {
  EXPECT_EQ(bodies_of(box_in_halves({0, 0, 0}, {1, 1, 1})), (Groups{{{0, 1}, true}}));
  EXPECT_EQ(bodies_of(cut_by(box_body({0, 0, 0}, {1, 1, 1}), by_face(12), 6)),
            (Groups{{{0, 1, 2, 3, 4, 5}, true}}));
  // Triangles of no part are one, too.
  Mesh half = box_in_halves({0, 0, 0}, {1, 1, 1});
  half.parts.pop_back();
  EXPECT_EQ(bodies_of(half), (Groups{{{0, Part::kNoParent}, true}}));
}

TEST(BodiesOf, LeaveABodyOfItsOwnOutOfIt) {
  Mesh mesh = box_in_halves({0, 0, 0}, {1, 1, 1});
  Mesh other = box_body({1, 0, 0}, {2, 1, 1});
  other.parts = {{.name = "other", .first = 0, .count = 12}};
  append(mesh, other);
  EXPECT_EQ(bodies_of(mesh), (Groups{{{0, 1}, true}, {{2}, true}}));
}

TEST(BodiesOf, CloseAtATJunction) {
  // The lid of the box is two triangles; its rim has a vertex in the middle of each side.
  const Vec3 one{1, 1, 1};
  const Mesh fine = box_body({0, 0, 0}, one, 2);
  const Mesh plain = box_body({0, 0, 0}, one);
  const auto is_lid = [](const Mesh& mesh, std::size_t i) {
    const Triangle t = mesh.triangle(static_cast<TriangleId>(i));
    return t.a.z == 1 && t.b.z == 1 && t.c.z == 1;
  };
  Mesh box = fine;
  std::vector<std::uint32_t> label;
  box.triangles.clear();
  for (std::size_t i = 0; i < fine.triangles.size(); ++i) {
    if (!is_lid(fine, i)) {
      box.triangles.push_back(fine.triangles[i]);
      label.push_back(0);
    }
  }
  for (std::size_t i = 0; i < plain.triangles.size(); ++i) {
    if (is_lid(plain, i)) {
      const auto at = static_cast<std::uint32_t>(box.vertices.size());
      const Triangle t = plain.triangle(static_cast<TriangleId>(i));
      box.vertices.insert(box.vertices.end(), {t.a, t.b, t.c});
      box.triangles.push_back({at, at + 1, at + 2});
      label.push_back(1);
    }
  }
  EXPECT_EQ(bodies_of(cut_by(box, label, 2)), (Groups{{{0, 1}, true}}));
}

TEST(BodiesOf, LeaveOutAFlangeAtTheSeam) {
  Mesh mesh = box_in_halves({0, 0, 0}, {1, 1, 1});
  // A sheet on an edge of the seam.
  const std::vector<PartGroup> halves = bodies_of(mesh);
  ASSERT_EQ(halves.size(), 1U);
  Mesh sheet = test::soup_body({{{0, 0, 0}, {1, 0, 0}, {0, -1, -1}}});
  sheet.parts = {{.name = "flange", .first = 0, .count = 1}};
  append(mesh, sheet);
  EXPECT_EQ(bodies_of(mesh), (Groups{{{0, 1}, true}, {{2}, false}}));
}

TEST(BodiesOf, OfABoxWithoutItsLidAreOneOpenGroup) {
  Mesh mesh = box_body({0, 0, 0}, {1, 1, 1});
  mesh.triangles.resize(10);
  mesh.faces.clear();
  EXPECT_EQ(bodies_of(cut_by(mesh, by_face(10), 5)), (Groups{{{0, 1, 2, 3, 4}, false}}));
}

TEST(BodiesOf, TellNoneWhereTwoCouldBeMeant) {
  // Two halves of a box, twice in one place: which halves belong together, nobody can say.
  Mesh twice = box_in_halves({0, 0, 0}, {1, 1, 1});
  append(twice, box_in_halves({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(bodies_of(twice), (Groups{{{0, 1, 2, 3}, false}}));
  // Unless the file says what holds them.
  twice.parts.push_back({.name = "first", .first = 0, .count = 12});
  twice.parts.push_back({.name = "second", .first = 12, .count = 12});
  twice.parts[0].parent = twice.parts[1].parent = 4;
  twice.parts[2].parent = twice.parts[3].parent = 5;
  check(twice);
  EXPECT_EQ(bodies_of(twice), (Groups{{{0, 1}, true}, {{2, 3}, true}}));
}

TEST(BodiesOf, TellBoxesThatMeetInAnEdgeApart) {
  Mesh mesh = box_in_halves({0, 0, 0}, {1, 1, 1});
  append(mesh, box_in_halves({1, 1, 0}, {2, 2, 1}));
  EXPECT_EQ(bodies_of(mesh), (Groups{{{0, 1}, true}, {{2, 3}, true}}));
}

/// Boxes on few places, cut into parts at random, with objects around some.
Mesh random_cut(Rng& rng) {
  Mesh whole;
  std::vector<std::uint32_t> label;
  const auto parts = static_cast<std::uint32_t>(2 + rng.below(6));
  for (std::uint64_t k = 1 + rng.below(3); k > 0; --k) {
    const auto at = [&] { return static_cast<double>(rng.below(2)); };
    const Vec3 lower{at(), at(), at()};
    const Mesh box =
        box_body(lower, lower + Vec3{1, 1, 1 + at()}, 1 + static_cast<int>(rng.below(2)));
    const bool whole_faces = rng.below(2) == 0;
    const auto first = static_cast<std::uint32_t>(rng.below(parts));
    const auto last = static_cast<std::uint32_t>(1 + rng.below(parts - first));
    std::uint32_t now = first;
    for (std::size_t i = 0; i < box.triangles.size(); ++i) {
      now = whole_faces && i % 2 == 1 ? now : first + static_cast<std::uint32_t>(rng.below(last));
      label.push_back(now);
    }
    whole = test::joined(whole, box);
  }
  if (rng.below(4) == 0) {
    whole.triangles.pop_back();
    label.pop_back();
  }
  Mesh cut = cut_by(whole, label, parts);
  if (rng.below(2) == 0) {
    // Neighbors of some number are one object.
    const auto middle = static_cast<std::uint32_t>(1 + rng.below(parts - 1));
    const std::uint32_t begin = cut.parts[middle].first;
    cut.parts.push_back({.name = "front", .first = 0, .count = begin});
    cut.parts.push_back({.name = "back",
                         .first = begin,
                         .count = static_cast<std::uint32_t>(cut.triangles.size()) - begin});
    for (std::uint32_t k = 0; k < parts; ++k) {
      cut.parts[k].parent = k < middle ? parts : parts + 1;
    }
  }
  return cut;
}

TEST(BodiesOf, AreThoseOfBruteForce) {
  Rng rng(76);
  std::size_t joined = 0;
  std::size_t open = 0;
  for (int round = 0; round < 3000; ++round) {
    const Mesh mesh = random_cut(rng);
    check(mesh);
    const Groups found = bodies_of(mesh);
    Groups closed;
    std::copy_if(found.begin(), found.end(), std::back_inserter(closed),
                 [](const PartGroup& group) { return group.closed; });
    ASSERT_EQ(closed, reference::closed_bodies_by_brute_force(mesh)) << "round " << round;
    joined += static_cast<std::size_t>(
        std::count_if(closed.begin(), closed.end(),
                      [](const PartGroup& group) { return group.parts.size() > 1; }));
    open += found.size() - closed.size();
  }
  EXPECT_GT(joined, 500U);
  EXPECT_GT(open, 100U);
}

}  // namespace
}  // namespace soms

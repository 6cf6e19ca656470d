// Verdicts of floats and of doubles on pairs of triangles that touch, nearly touch or just miss,
// against the exact answer on moved vertices.
#include "soms/geometry/triangle_overlap.h"
#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/relative_pose.h"
#include "soms/tree/shape.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/support.h"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace soms::detail {
namespace {

/// Pairs judged so and so.
struct Tally {
  std::size_t hit = 0;
  std::size_t apart = 0;
  std::size_t open = 0;
  std::size_t open_in_double = 0;  // of all
  std::size_t hit_in_double = 0;
  std::size_t apart_in_double = 0;
  std::size_t overlapping = 0;
};

Vec3 between(Rng& rng, const Triangle& t) {
  // Inside, on an edge, or a corner.
  const std::uint64_t kind = rng.below(4);
  const double u = kind == 0 ? 0 : rng.unit();
  const double v = kind == 0 || kind == 1 ? 0 : rng.unit() * (1 - u);
  return t.a + u * (t.b - t.a) + v * (t.c - t.a);
}

Vec3 anywhere(Rng& rng, double reach) {
  return {rng.uniform(-reach, reach), rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
}

/// Where `pose` comes from, up to rounding.
Vec3 back(const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.shift();
  const auto& m = pose.m;
  return {(m[0] * d.x + m[4] * d.y) + m[8] * d.z, (m[1] * d.x + m[5] * d.y) + m[9] * d.z,
          (m[2] * d.x + m[6] * d.y) + m[10] * d.z};
}

void append(Mesh& mesh, const Triangle& t) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {t.a, t.b, t.c});
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Triangle moved(const Shape& shape, const Pose& pose, TriangleId id) {
  const Triangle t = shape.mesh().triangle(id);
  return {pose.apply(t.a), pose.apply(t.b), pose.apply(t.c)};
}

/// A triangle through, or beside, a point of `t` at a distance of `gap`.
Triangle touching(Rng& rng, const Triangle& t, double gap, double size) {
  const Vec3 p = between(rng, t) + gap * anywhere(rng, 1);
  switch (rng.below(5)) {
    case 0:  // a corner
      return {p, p + anywhere(rng, size), p + anywhere(rng, size)};
    case 1: {  // an edge
      const Vec3 d = anywhere(rng, size);
      return {p - rng.unit() * d, p + d, p + anywhere(rng, size)};
    }
    case 2: {  // the face
      const Vec3 d = anywhere(rng, size);
      const Vec3 e = anywhere(rng, size);
      return {p - d, p + 2 * d - e, p + e - d};
    }
    case 3: {  // in one plane, or nearly
      const Vec3 d = rng.uniform(-1, 1) * (t.b - t.a);
      const Vec3 e = rng.uniform(-1, 1) * (t.c - t.a);
      return {p, p + d, p + e + gap * anywhere(rng, 1)};
    }
    default: {  // without area
      const Vec3 d = anywhere(rng, size);
      return {p - d, p + d, rng.below(2) == 0 ? p : p + d};
    }
  }
}

/// Two bodies of few triangles, each of one near one of the other's.
struct Near {
  Near(Rng& rng, double scale, double far, double spread = 6) {
    pose_a = test::awkward_rotation(rng);
    pose_b = test::awkward_rotation(rng);
    for (Pose* const pose : {&pose_a, &pose_b}) {
      const Vec3 shift = far * Vec3{1, -0.5, 0.25} + anywhere(rng, scale);
      pose->m[3] = shift.x;
      pose->m[7] = shift.y;
      pose->m[11] = shift.z;
    }
    Mesh a;
    Mesh b;
    for (std::size_t i = 0; i < 1 + rng.below(16); ++i) {
      const double size = scale * std::exp2(-rng.uniform(0, spread));
      const Vec3 at = anywhere(rng, 0.2 * scale);
      const Triangle t{at, at + anywhere(rng, size), at + anywhere(rng, size)};
      append(a, t);
      const double gap =
          rng.below(3) == 0
              ? 0
              : size * std::exp2(-(rng.below(2) == 0 ? rng.uniform(12, 26) : rng.uniform(2, 54)));
      const Triangle near = touching(rng, {pose_a.apply(t.a), pose_a.apply(t.b), pose_a.apply(t.c)},
                                     gap, scale * std::exp2(-rng.uniform(0, spread)));
      append(b, {back(pose_b, near.a), back(pose_b, near.b), back(pose_b, near.c)});
    }
    shape_a = Shape(std::move(a));
    shape_b = Shape(std::move(b));
  }

  Shape shape_a;
  Shape shape_b;
  Pose pose_a;
  Pose pose_b;
};

/// What doubles say of some pairs of lanes, the same by all kernels.
Verdicts judge_in_double(const BlockTask& task, const TriangleSlot& slot,
                         const std::vector<std::uint32_t>& lanes, std::size_t begin,
                         std::size_t count) {
  std::array<std::uint16_t, kJudged> pairs;
  for (std::size_t k = 0; k < count; ++k) {
    pairs[k] = static_cast<std::uint16_t>(lanes[begin + k]);
  }
  const Verdicts verdicts =
      scalar::kernels().judge_in_double(&slot, *task.pose, pairs.data(), count);
  EXPECT_EQ(verdicts.hit & verdicts.open, 0U);
  for (const Kernels* kernels : kernels_here()) {
    const Verdicts there = kernels->judge_in_double(&slot, *task.pose, pairs.data(), count);
    EXPECT_EQ(there.hit, verdicts.hit) << kernels->name;
    EXPECT_EQ(there.open, verdicts.open) << kernels->name;
  }
  return verdicts;
}

/// Judges all pairs of two blocks, whether their boxes meet or not.
void judge_blocks(const Near& near, const BlockTask& task, Tally& tally) {
  TriangleSlot slot;
  const std::uint64_t met = scalar::kernels().test_boxes(task, slot);
  std::array<std::uint32_t, kJudged> first;
  std::array<std::uint32_t, kJudged> second;
  std::vector<std::uint32_t> lanes;
  for (std::uint64_t left = met; left != 0; left &= left - 1) {
    lanes.push_back(static_cast<std::uint32_t>(std::countr_zero(left)));
  }
  for (std::size_t begin = 0; begin < lanes.size(); begin += kJudged) {
    const std::size_t count = std::min(kJudged, lanes.size() - begin);
    const bool swap = begin % (2 * kJudged) != 0;
    for (std::size_t k = 0; k < kJudged; ++k) {
      const std::uint32_t lane = lanes[begin + (k < count ? k : 0)];
      first[k] = lane >> 3;
      second[k] = sizeof(TriangleSlot::Corners) / sizeof(float) + (lane & 7);
    }
    if (swap) {
      first.swap(second);
    }
    const Verdicts verdicts = scalar::kernels().judge(&slot, first.data(), second.data(), count);
    ASSERT_EQ(verdicts.hit & verdicts.open, 0U);
    for (const Kernels* kernels : kernels_here()) {
      const Verdicts there = kernels->judge(&slot, first.data(), second.data(), count);
      ASSERT_EQ(there.hit, verdicts.hit) << kernels->name;
      ASSERT_EQ(there.open, verdicts.open) << kernels->name;
    }
    const Verdicts in_double = judge_in_double(task, slot, lanes, begin, count);
    for (std::size_t k = 0; k < count; ++k) {
      const TriangleId i = task.x->id[lanes[begin + k] >> 3];
      const TriangleId j = task.y->id[lanes[begin + k] & 7];
      const bool exact = triangles_overlap(moved(near.shape_a, near.pose_a, i),
                                           moved(near.shape_b, near.pose_b, j));
      const bool hit = (verdicts.hit >> k & 1U) != 0;
      const bool open = (verdicts.open >> k & 1U) != 0;
      ASSERT_TRUE(open || hit == exact)
          << "triangles " << i << " and " << j << " overlap: " << exact << ", judged: " << hit;
      ++(hit ? tally.hit : open ? tally.open : tally.apart);
      const bool closer_hit = (in_double.hit >> k & 1U) != 0;
      const bool closer_open = (in_double.open >> k & 1U) != 0;
      ASSERT_TRUE(closer_open || closer_hit == exact)
          << "triangles " << i << " and " << j << " overlap: " << exact
          << ", judged in double: " << closer_hit;
      ++(closer_hit    ? tally.hit_in_double
         : closer_open ? tally.open_in_double
                       : tally.apart_in_double);
      tally.overlapping += exact ? 1 : 0;
    }
  }
}

void judge_bodies(const Near& near, Tally& tally) {
  const WideTree& x = near.shape_a.layout();
  const WideTree& y = near.shape_b.layout();
  if (x.exponent() < y.exponent()) {
    return;
  }
  RelativePose relative(x, near.pose_a, ReferenceFrame(y, near.pose_b));
  relative.prepare();
  for (const TriangleBlock& block_x : x.blocks()) {
    for (const TriangleBlock& block_y : y.blocks()) {
      BlockTask task{&relative.numbers(), &block_x, &block_y, {}, 0, 0, 0};
      scalar::kernels().test_slabs(&task, 1);
      ASSERT_NO_FATAL_FAILURE(judge_blocks(near, task, tally));
    }
  }
}

TEST(TrianglePairs, AreJudgedAsTheyAreOrLeftOpen) {
  Tally tally;
  test::for_each_case("triangle-pairs/usual", 3000,
                      [&](Rng& rng) { judge_bodies(Near(rng, 1, 0), tally); });
  // Many pairs are made to touch to a few rounding errors, and must stay open.
  EXPECT_GT(tally.hit, tally.open / 4);
  EXPECT_GT(tally.apart, tally.open / 2);
  EXPECT_GT(tally.overlapping, tally.apart / 4);
  EXPECT_GT(tally.hit_in_double, tally.hit);
  EXPECT_GT(tally.apart_in_double, tally.apart);
}

TEST(TrianglePairs, AreJudgedAsTheyAreFarFromTheOrigin) {
  Tally tally;
  test::for_each_case("triangle-pairs/far", 3000, [&](Rng& rng) {
    judge_bodies(Near(rng, 1, std::exp2(rng.uniform(0, 45))), tally);
  });
  EXPECT_GT(tally.hit, 1000U);
  EXPECT_GT(tally.apart, 1000U);
}

TEST(TrianglePairs, AreJudgedAsTheyAreAtEveryScale) {
  Tally tally;
  test::for_each_case("triangle-pairs/scale", 3000, [&](Rng& rng) {
    judge_bodies(Near(rng, std::exp2(rng.uniform(-120, 60)), 0), tally);
  });
  EXPECT_GT(tally.hit, 1000U);
  EXPECT_GT(tally.apart, 1000U);
}

/// A large triangle in the first body stretches its layout, and the others become tiny in it.
TEST(TrianglePairs, AreJudgedAsTheyAreWhereSizesDiffer) {
  Tally tally;
  test::for_each_case("triangle-pairs/sizes", 3000, [&](Rng& rng) {
    const Near near(rng, std::exp2(-rng.uniform(1, 50)), 0);
    Near wide = near;
    Mesh mesh(near.shape_a.mesh());
    append(mesh, {{-1, -1, 0}, {1, -1, 0.1}, {0, 1, rng.uniform(-1, 1)}});
    wide.shape_a = Shape(std::move(mesh));
    judge_bodies(wide, tally);
  });
  EXPECT_GT(tally.hit, 300U);
  EXPECT_GT(tally.apart, 1000U);
}

/// Where floats leave most pairs open, and doubles few of them.
TEST(TrianglePairs, AreJudgedAsTheyAreIfOneIsFarLargerThanTheOther) {
  Tally tally;
  test::for_each_case("triangle-pairs/unlike", 3000,
                      [&](Rng& rng) { judge_bodies(Near(rng, 1, 0, 24), tally); });
  EXPECT_GT(tally.hit_in_double, 2 * tally.hit);
  EXPECT_GT(tally.open, tally.open_in_double);
}

TEST(TrianglePairs, AreJudgedAsTheyAreIfUnlikeOnesAreFarFromTheOrigin) {
  Tally tally;
  test::for_each_case("triangle-pairs/unlike-far", 3000, [&](Rng& rng) {
    judge_bodies(Near(rng, 1, std::exp2(rng.uniform(0, 45)), 24), tally);
  });
  EXPECT_GT(tally.hit_in_double, tally.hit);
  EXPECT_GT(tally.open_in_double, 1000U);
}

}  // namespace
}  // namespace soms::detail

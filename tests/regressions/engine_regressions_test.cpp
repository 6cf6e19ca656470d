// Faults that other libraries had with poses, moving bodies, answers and far coordinates; numbers
// as in the list of regressions.
#include "soms/query/overlap.h"
#include "soms/query/reference/overlap.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/allocation.h"
#include "tests/support/support.h"

#include <cmath>
#include <vector>

namespace soms {
namespace {

/// The box from -half to half, each side cut into `n` x `n` squares.
Mesh box(double half, int n) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    const auto axis = static_cast<std::size_t>(side / 2);
    const auto corner = [&](int i, int j) {
      Vec3 v;
      v[axis] = side % 2 == 0 ? -half : half;
      v[(axis + 1) % 3] = half * (2.0 * i / n - 1);
      v[(axis + 2) % 3] = half * (2.0 * j / n - 1);
      return v;
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {corner(i, j), corner(i + 1, j),
                                                   corner(i + 1, j + 1), corner(i, j + 1)});
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.triangles.push_back({first, first + 2, first + 3});
      }
    }
  }
  return mesh;
}

// Overlap is about surfaces, and says so: a body inside another touches nothing of it.
TEST(Regression, R17ABodyInsideAnotherOverlapsNothingOfIt) {
  const std::vector<Body> nested = {Body{box(0.5, 3)}, Body{box(5, 3)}, Body{box(20, 2)}};
  for (const Body& a : nested) {
    for (const Body& b : nested) {
      EXPECT_EQ(overlap(a, b).any, &a == &b);
    }
  }
}

TEST(Regression, R35AnAnswerHoldsNothingOfTheOneBefore) {
  const Body fixed{box(1, 3)};
  Body mover{box(1, 3), Pose::translation(1.5, 0.25, 0.125)};
  Overlap answer = overlap(mover, fixed);
  EXPECT_TRUE(answer.any);
  const Overlap first = answer;
  mover.pose = Pose::translation(2.5, 0.25, 0.125);
  answer = overlap(mover, fixed);
  EXPECT_FALSE(answer.any);
  EXPECT_TRUE(answer.pairs.empty());
  mover.pose = Pose::translation(1.5, 0.25, 0.125);
  EXPECT_EQ(overlap(mover, fixed).pairs, first.pairs);
}

TEST(Regression, R44NoPairIsDroppedInSilence) {
  const Body body{box(1, 20)};
  const Overlap whole = overlap(body, body);
  EXPECT_GT(whole.pairs.size(), 20000U);
  EXPECT_EQ(whole.coverage, Coverage::complete);
  const Overlap cut = overlap(body, body, {.limit = 1000});
  EXPECT_EQ(cut.pairs.size(), 1000U);
  EXPECT_EQ(cut.coverage, Coverage::cut);
  const Overlap enough = overlap(body, body, {.limit = whole.pairs.size()});
  EXPECT_EQ(enough.pairs, whole.pairs);
}

TEST(Regression, R70FindsABodyWhereItsPoseWasSetAfterItWasMade) {
  Body mover{box(1, 3)};
  const Body target{box(1, 3), Pose::translation(10, 0.25, 0.25)};
  EXPECT_FALSE(overlap(mover, target).any);
  mover.pose = Pose::translation(8.5, 0, 0);
  EXPECT_TRUE(overlap(mover, target).any);
  EXPECT_TRUE(overlap(target, mover, {.mode = OverlapMode::any}).any);
  mover.pose = {};
  EXPECT_FALSE(overlap(mover, target).any);
}

TEST(Regression, R73MovingABodyAllocatesNothing) {
  const Shape shape(box(1, 64));
  ASSERT_EQ(shape.mesh().triangles.size(), 49152U);
  const Body fixed{box(1, 4)};
  std::vector<Pose> poses;
  poses.reserve(100000);
  for (int i = 0; i < 100000; ++i) {
    poses.push_back(Pose::about_z(0.001 * i, {1.99 + 0.0005 * (i % 97), 0.3, 0.1}));
  }
  Body body(shape);
  std::uint64_t apart = 0;
  EXPECT_TRUE(overlap(Body(box(1, 1)), Body(box(1, 1))).any);
  const test::AllocationWatch singly;  // the kernels were chosen by the query before
  for (std::size_t i = 0; i < 2000; ++i) {
    body.pose = poses[i];
    const Overlap answer = overlap(body, fixed, {.mode = OverlapMode::any});
    apart += answer.any ? 0 : 1;
  }
  const std::uint64_t single = singly.count();
  // A hit is returned in a vector of one pair.
  EXPECT_EQ(single, 2000 - apart);

  const test::AllocationWatch batched;
  const OverlapBatch few =
      overlap(shape, std::span(poses).first(1000), fixed, {.mode = OverlapMode::any});
  const std::uint64_t of_few = batched.count();
  const OverlapBatch many = overlap(shape, poses, fixed, {.mode = OverlapMode::any});
  const std::uint64_t of_many = batched.count() - of_few;
  ASSERT_EQ(many.size(), 100000U);
  // Blocks of poses allocate, not queries.
  EXPECT_LT(of_many, 100000 / 10);
  EXPECT_LT(of_few, 200U);
}

TEST(Regression, R81KeepsAMillimeterAtTenThousandKilometers) {
  // Bodies 1e7 m out, apart or meeting by a millimeter: floats there are a meter apart.
  const Vec3 far{1e7, -1e7, 5e6};
  const Body wall{test::placed(box(1, 6), 1, far)};
  const auto at = [&](double gap) {
    return Body{test::placed(box(1, 6), 1, far + Vec3{2 + gap, 0.0005, 0.0005})};
  };
  EXPECT_FALSE(overlap(wall, at(0.001)).any);
  EXPECT_TRUE(overlap(wall, at(-0.001)).any);
  for (const double gap : {0.001, 0.0, -0.001}) {
    const Body other = at(gap);
    EXPECT_EQ(overlap(wall, other).pairs,
              reference::overlap(wall.shape.mesh(), {}, other.shape.mesh(), {}).pairs);
  }
  test::for_each_case("regression/R81", 40, [&](Rng& rng) {
    const Mesh a = test::placed(test::awkward_mesh(rng, 60), 0.001, far);
    const Mesh b = test::placed(test::awkward_mesh(rng, 60), 0.001, far);
    ASSERT_EQ(overlap(Body{a}, Body{b}).pairs, reference::overlap(a, {}, b, {}).pairs);
  });
}

TEST(Regression, R82AnswersAlikeAtSurveyCoordinates) {
  // Coordinates are multiples of 2^-20, so both offsets are exact and nothing may change.
  test::for_each_case("regression/R82", 40, [](Rng& rng) {
    const auto rounded = [](Mesh mesh) {
      for (Vec3& v : mesh.vertices) {
        v = {std::round(v.x * 0x1p20) * 0x1p-20, std::round(v.y * 0x1p20) * 0x1p-20,
             std::round(v.z * 0x1p20) * 0x1p-20};
      }
      return mesh;
    };
    const Mesh a = rounded(test::awkward_mesh(rng, 80));
    const Mesh b = rounded(test::awkward_mesh(rng, 80));
    const Overlap near = overlap(Body{a}, Body{b});
    for (const Vec3& offset : {Vec3{400000, 800000, 50}, Vec3{4027894, 307045, 4919474}}) {
      const Overlap far =
          overlap(Body{test::placed(a, 1, offset)}, Body{test::placed(b, 1, offset)});
      ASSERT_EQ(far.pairs, near.pairs);
    }
  });
}

}  // namespace
}  // namespace soms

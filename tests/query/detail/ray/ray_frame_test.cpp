// Kernels of rays in any direction: all instruction sets give the same bits, and nothing sure is
// wrong.
#include "soms/query/detail/ray/ray_frame.h"

#include "soms/query/detail/kernels/instruction_set.h"
#include "soms/query/detail/moved_triangle.h"

#include "tests/query/overlap_inputs.h"
#include "tests/support/scales.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace soms::detail {
namespace {

Vec3 shift_of(Rng& rng) {
  const double far = rng.below(2) == 0 ? 0 : std::exp2(rng.uniform(-5, 25));
  return {far * rng.uniform(-1, 1), far * rng.uniform(-1, 1), far * rng.uniform(-1, 1)};
}

/// Triangles of very different sizes, of a body of any size that leaves room for far rays.
Body uneven_body(Rng& rng) {
  test::Scales scales = test::any_scales(rng);
  while (scales.body > 250) {
    scales = test::any_scales(rng);
  }
  return Body(Shape(test::uneven_mesh(rng, scales), {.build = test::awkward_options(rng)}),
              test::pose_at(rng, scales));
}

Body body_of(Rng& rng) {
  if (rng.below(3) == 0) {
    return uneven_body(rng);
  }
  const double scale = rng.below(2) == 0 ? 1 : std::exp2(std::floor(rng.uniform(-60, 60)));
  Pose pose = rng.below(3) == 0 ? Pose{} : test::awkward_rotation(rng);
  if (rng.below(2) == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      pose.m[4 * axis + 3] = rng.uniform(-1, 1) * std::exp2(rng.uniform(-30, 30));
    }
  }
  return Body(Shape(test::placed(test::awkward_mesh(rng, 200), scale, shift_of(rng)),
                    {.build = test::awkward_options(rng)}),
              pose);
}

/// A ray or segment through a point of a triangle as near as doubles allow, or a little off it,
/// from inside the body, from as near as the triangle is large, or from far away.
RayLine line_of(Rng& rng, const Body& body) {
  const auto count = static_cast<std::uint64_t>(body.shape.mesh().triangles.size());
  const Triangle t = moved_triangle(body, static_cast<TriangleId>(rng.below(count)));
  const double u = rng.below(2) == 0 ? 0 : rng.uniform(0, 1);
  const double v = rng.below(3) == 0 ? rng.uniform(0, 1 - u) : 0;
  const Vec3 p = t.a + (t.b - t.a) * u + (t.c - t.a) * v;
  const Vec3 side = body.shape.bounds().extent();
  Vec3 from = p;
  const double far = std::exp2(rng.below(2) == 0 ? rng.uniform(-4, 1) : rng.uniform(0, 40));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (rng.below(4) != 0) {
      from[axis] += std::max({side.x, side.y, side.z}) * far * rng.uniform(-1, 1);
    }
  }
  if (rng.below(3) == 0) {  // as near as a triangle is large
    const Vec3 edge = t.b - t.a;
    from = p + test::any_way(rng, std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)}) *
                                      std::exp2(rng.uniform(-1, 5)));
  }
  RayLine line{from, p, 1, true};
  const double reach = std::exp2(std::floor(rng.uniform(-100, 100)));
  const Vec3 direction = (p - from) * reach;
  if (rng.below(2) == 0 && direction != Vec3{}) {
    line = {from, direction, std::numeric_limits<double>::infinity(), false};
    if (rng.below(2) == 0) {
      line.length = (1 + 0x1p-52 * static_cast<double>(rng.below(3))) / reach;
    }
  }
  return line;
}

/// What a kernel puts on a ray's stack for a node.
std::vector<Ahead> boxes_ahead(const Kernels& kernels, const RayCourse& course,
                               const WideNode& node) {
  std::vector<Ahead> stack(WideNode::kWidth);
  LineDescent descent{&course.numbers, stack.data(), 0, stack.size(), 0, 0};
  kernels.line_node(node, descent);
  EXPECT_EQ(descent.boxes, node.count);
  stack.resize(descent.size);
  return stack;
}

LineBlockTask judged(const Kernels& kernels, const RayCourse& course, const TriangleBlock& block) {
  LineBlockTask task{&course.numbers, &block, 0, 0, 0, {}, {}};
  kernels.line_block(task);
  return task;
}

TEST(RayFrame, GivesTheSameBitsByAllInstructionSets) {
  std::size_t met = 0;
  test::for_each_case("ray-frame/bits", 150, [&](Rng& rng) {
    const Body body = body_of(rng);
    const RayFrame frame(body.shape.layout(), body.pose);
    for (int i = 0; i < 4; ++i) {
      const RayLine line = line_of(rng, body);
      RayCourse course;
      if (!frame.start(line, ScaledDirection(line), course)) {
        continue;
      }
      for (const Kernels* kernels : kernels_here()) {
        SCOPED_TRACE(kernels->name);
        for (const WideNode& node : body.shape.layout().nodes()) {
          const std::vector<Ahead> boxes = boxes_ahead(*kernels, course, node);
          ASSERT_EQ(boxes, boxes_ahead(scalar::kernels(), course, node));
          met += boxes.empty() ? 0U : 1U;
        }
        for (const TriangleBlock& block : body.shape.layout().blocks()) {
          const LineBlockTask task = judged(*kernels, course, block);
          const LineBlockTask twin = judged(scalar::kernels(), course, block);
          ASSERT_EQ(task.through, twin.through);
          ASSERT_EQ(task.sure, twin.sure);
          ASSERT_EQ(task.open, twin.open);
          ASSERT_EQ(task.near, twin.near);
          ASSERT_EQ(task.far, twin.far);
        }
      }
    }
  });
  EXPECT_GT(met, 1000U);
}

/// A hit's place along the ray is within the bounds of it, in units of the layout.
void expect_between(const RayLine& line, const RayCourse& course, const ExactRay& exact, float near,
                    float far) {
  if (line.segment && line.origin == line.ahead) {
    return;
  }
  RayTime scaled = exact.time();
  scaled.exponent += ScaledDirection(line).exponent;
  RayCourse until = course;
  const Bracket time = bracket(scaled);
  until.set_far(time.upper);  // rounded up, by a few roundings
  ASSERT_LE(near, until.numbers.far_open);
  const auto place = [&](double t) {
    return (course.start + t * course.speed) * course.numbers.scale;
  };
  const double rounding =
      (std::abs(course.start) + time.lower * course.speed) * 0x1p-49 + 0x1p-1064;
  ASSERT_GE(far, place(time.lower) - rounding * course.numbers.scale);
  ASSERT_LE(near, place(time.upper) + rounding * course.numbers.scale);
}

/// What a whole tree says of triangles: below nodes that the ray may meet only.
void expect_right(const Body& body, const RayLine& line, const RayCourse& course,
                  std::array<std::size_t, 4>& counts) {
  const auto& kernels = scalar::kernels();
  const WideTree& tree = body.shape.layout();
  std::vector<std::uint32_t> reached{0};
  std::vector<bool> decided(body.shape.mesh().triangles.size());
  while (!reached.empty()) {
    const std::uint32_t token = reached.back();
    reached.pop_back();
    if ((token & WideNode::kLeafBit) == 0) {
      for (const Ahead& box : boxes_ahead(kernels, course, tree.nodes()[token])) {
        reached.push_back(box.token);
      }
      continue;
    }
    const TriangleBlock& block = tree.blocks()[token & (WideNode::kMost - 1)];
    const LineBlockTask task = judged(kernels, course, block);
    ASSERT_EQ(task.through & task.open, 0U);
    ASSERT_EQ(task.sure & ~task.through, 0U);
    for (std::uint32_t k = 0; k < block.count; ++k) {
      const ExactRay exact(line, moved_triangle(body, block.id[k]));
      decided[block.id[k]] = true;
      const std::size_t said = (task.sure >> k & 1U) != 0      ? 0
                               : (task.through >> k & 1U) != 0 ? 1
                               : (task.open >> k & 1U) != 0    ? 2
                                                               : 3;
      ++counts[said];
      ASSERT_TRUE(said != 0 || exact.hit());
      ASSERT_TRUE(said != 3 || !exact.hit());
      // Off the edges, so a line beside it passes, too; a point has no line of its own.
      if (said < 2 && !(line.segment && line.origin == line.ahead)) {
        ASSERT_TRUE(exact.crossed_beside());
        ASSERT_TRUE(!exact.hit() || exact.features()[0] == kFace);
      }
      if (said != 3 && exact.hit()) {
        ASSERT_NO_FATAL_FAILURE(expect_between(line, course, exact, task.near[k], task.far[k]));
      }
    }
    if (block.following != 0) {
      reached.push_back(token + 1);
    }
  }
  for (TriangleId id = 0; id < decided.size(); ++id) {
    ASSERT_TRUE(decided[id] || !ExactRay(line, moved_triangle(body, id)).hit());
  }
}

TEST(RayFrame, IsNeverWrongWhereItIsSure) {
  std::array<std::size_t, 4> counts = {};
  test::for_each_case("ray-frame/sure", 900, [&](Rng& rng) {
    const Body body = body_of(rng);
    const RayFrame frame(body.shape.layout(), body.pose);
    for (int i = 0; i < 4; ++i) {
      const RayLine line = line_of(rng, body);
      RayCourse course;
      if (frame.start(line, ScaledDirection(line), course)) {
        ASSERT_NO_FATAL_FAILURE(expect_right(body, line, course, counts));
        continue;
      }
      for (TriangleId id = 0; id < body.shape.mesh().triangles.size(); ++id) {
        ASSERT_FALSE(ExactRay(line, moved_triangle(body, id)).hit());
      }
    }
  });
  for (const std::size_t count : counts) {
    EXPECT_GT(count, 500U);
  }
}

/// Bounds and brackets in floating point hold what whole numbers say.
TEST(RayFrame, BoundsHoldTheExactTime) {
  std::array<std::size_t, 2> sure = {};
  test::for_each_case("ray-frame/bounds", 600, [&](Rng& rng) {
    const Body body = body_of(rng);
    for (int i = 0; i < 20; ++i) {
      const RayLine line = line_of(rng, body);
      const ScaledDirection direction(line);
      const auto count = static_cast<std::uint64_t>(body.shape.mesh().triangles.size());
      const Triangle t = moved_triangle(body, static_cast<TriangleId>(rng.below(count)));
      const ExactRay exact(line, t);
      if (!exact.hit() || exact.side() == 0) {
        continue;
      }
      if (const auto bounds = time_bounds(line, direction, t)) {
        ++sure[0];
        ASSERT_EQ(bounds->side, exact.side());
        RayTime scaled = exact.time();
        scaled.exponent += direction.exponent;
        const Bracket time = bracket(scaled);
        ASSERT_LE(bounds->lower, time.lower);
        ASSERT_GE(bounds->upper, time.upper);
      }
      const auto hit = plane_hit(line, direction, t);
      if (hit && hit->t.lower > 0) {
        ++sure[1];
        ASSERT_EQ(hit->t, bracket(exact.time()));
        ASSERT_EQ(hit->point, exact.point());
      }
    }
  });
  EXPECT_GT(sure[0], 500U);
  EXPECT_GT(sure[1], 200U);
}

}  // namespace
}  // namespace soms::detail

#include "soms/query/detail/engine/pair_frame.h"

#include "soms/generate/shapes.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace soms::detail {
namespace {

Mesh scaled(Mesh mesh, double by) {
  for (Vec3& vertex : mesh.vertices) {
    vertex = vertex * by;
  }
  return mesh;
}

TEST(PairFrame, HasTheLargerBodyAsReferenceAndAnswersInTheCallersOrder) {
  const Body small(generate_sphere(80), Pose::translation(3, 0, 0));
  const Body large(scaled(generate_sphere(80), 2));
  const PairFrame kept(small, large);
  EXPECT_EQ(kept.x().shape, &small.shape);
  EXPECT_EQ(kept.x().pose, &small.pose);
  EXPECT_EQ(kept.y().shape, &large.shape);
  EXPECT_EQ(kept.in_callers_order(1, 2), (TrianglePair{1, 2}));
  const PairFrame swapped(large, small);
  EXPECT_EQ(swapped.x().shape, &small.shape);
  EXPECT_EQ(swapped.y().pose, &large.pose);
  EXPECT_EQ(swapped.in_callers_order(1, 2), (TrianglePair{2, 1}));
}

// Its layout's unit is coarser, and that of the other one is not made finer.
TEST(PairFrame, HasTheBodyOfTheCoarserUnitAsReference) {
  const Body tiny(scaled(generate_sphere(80), 1e-30));
  const Body huge(scaled(generate_sphere(80), 1e30));
  ASSERT_LT(huge.shape.layout().exponent(), tiny.shape.layout().exponent());
  EXPECT_EQ(PairFrame(tiny, huge).y().shape, &huge.shape);
  EXPECT_EQ(PairFrame(huge, tiny).y().shape, &huge.shape);
}

TEST(PoseFrames, PlacesTheFrameOfASinglePair) {
  const Shape small(generate_sphere(80));
  const Shape large(scaled(generate_sphere(80), 2));
  const Pose pose = Pose::translation(1.5, 0.25, 0);
  std::optional<PairFrame> frame;
  for (const auto& [mover, fixed] :
       {std::pair(small, Body(large)), std::pair(large, Body(small))}) {
    const PoseFrames frames(mover, fixed);
    frames.place(pose, frame);
    const Body body(mover, pose);
    PairFrame single(body, fixed);
    EXPECT_EQ(&frames.reference(), &large.layout());
    EXPECT_EQ(&frame->y().layout(), &single.y().layout());
    EXPECT_EQ(frame->y().pose->m, single.y().pose->m);
    EXPECT_EQ(frame->x().pose->m, single.x().pose->m);
    EXPECT_EQ(frame->in_callers_order(1, 2), single.in_callers_order(1, 2));
    EXPECT_EQ(frame->relative().numbers().shift, single.relative().numbers().shift);
    // What costs most of a query of a small body is ready only when it is needed.
    frame->relative().prepare();
    single.relative().prepare();
    EXPECT_EQ(frame->relative().numbers().column, single.relative().numbers().column);
  }
}

}  // namespace
}  // namespace soms::detail

#include "apps/view/scene/part_boxes.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <utility>

namespace soms::view {
namespace {

TEST(PartBoxes, AreOfThePartThatHoldsTheTriangleWhereItIs) {
  const Mesh cube = test::box_body({0, 0, 0}, {1, 1, 1});
  Mesh two = test::joined(cube, test::box_body({5, 0, 0}, {7, 1, 1}));
  const auto of_cube = static_cast<std::uint32_t>(cube.triangles.size());
  two.parts = {{.name = "small", .first = 0, .count = of_cube},
               {.name = "large", .first = of_cube, .count = of_cube - 1}};
  const ViewScene scene(two_bodies(Body(cube), Body(std::move(two), Pose::translation(0, 0, 10))));
  PartBoxes part_boxes(scene);
  EXPECT_EQ(part_boxes(mover(0), 0), (Box{{0, 0, 10}, {1, 1, 11}}));
  EXPECT_EQ(part_boxes(mover(0), of_cube), (Box{{5, 0, 10}, {7, 1, 11}}));
  EXPECT_EQ(part_boxes(mover(0), of_cube + 1), (Box{{5, 0, 10}, {7, 1, 11}}));
  // The last triangle is in no part, and the other body has none.
  EXPECT_EQ(part_boxes(mover(0), 2 * of_cube - 1), scene.bounds(mover(0)));
  EXPECT_EQ(part_boxes(city_part(0), 3), scene.bounds(city_part(0)));
}

}  // namespace
}  // namespace soms::view

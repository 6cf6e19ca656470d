#include "apps/view/sight/dense_place.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"

#include <gtest/gtest.h>

namespace soms::view {
namespace {

/// A house with 192 triangles about a place.
Mesh house(double x, double y) {
  return test::box_body({x - 5, y - 5, 0}, {x + 5, y + 5, 10}, 4);
}

/// Ten houses, five of them together, over 20 kilometers.
SceneContent scattered() {
  Mesh houses = house(0, 0);
  for (const auto& [x, y] :
       {std::pair(9000.0, 4000.0), std::pair(9030.0, 4000.0), std::pair(9000.0, 4030.0),
        std::pair(9030.0, 4030.0), std::pair(9060.0, 4000.0), std::pair(20000.0, 0.0),
        std::pair(0.0, 20000.0), std::pair(20000.0, 20000.0), std::pair(3000.0, 12000.0)}) {
    houses = test::joined(houses, house(x, y));
  }
  SceneContent content;
  content.city.emplace_back(std::move(houses));
  return content;
}

void add_car(SceneContent& content, double x, double y) {
  content.movers.push_back({Body(test::box_body({x - 2, y - 1, 1}, {x + 2, y + 1, 2})), {}});
}

TEST(DensePlace, IsWhereMostHousesAre) {
  const auto place = dense_place(ViewScene(scattered()));
  ASSERT_TRUE(place);
  EXPECT_EQ(place->box, (Box{{8995, 3995, 0}, {9065, 4035, 10}}));
  EXPECT_EQ(place->triangles_left, 5U * 192);
  EXPECT_EQ(place->movers_left, 0U);
}

TEST(DensePlace, IsRatherWhereMoversAreAndFirstWhereTheyTouch) {
  SceneContent content = scattered();
  add_car(content, 20000, 20);
  add_car(content, 19990, 40);
  add_car(content, 19980, 30);
  const auto movers = dense_place(ViewScene(content));
  ASSERT_TRUE(movers);
  EXPECT_TRUE(movers->box.contains({{20000, 20, 1}, {20000, 20, 1}}));
  EXPECT_EQ(movers->movers_left, 0U);
  add_car(content, 3004, 12000);  // in a wall
  const auto contact = dense_place(ViewScene(content));
  ASSERT_TRUE(contact);
  EXPECT_TRUE(contact->box.contains({{3004, 12000, 1}, {3004, 12000, 1}}));
  EXPECT_EQ(contact->movers_left, 3U);
}

TEST(DensePlace, IsNoneOfACityOrOfAModel) {
  SceneContent ground = scattered();
  ground.city.emplace_back(test::box_body({-10, -10, -1}, {20010, 20010, 0}));
  EXPECT_FALSE(dense_place(ViewScene(std::move(ground))));
  SceneContent model;
  model.city.emplace_back(test::joined(house(0, 0), house(9000, 0)));
  EXPECT_FALSE(dense_place(ViewScene(std::move(model))));
  EXPECT_FALSE(dense_place(ViewScene(SceneContent{})));
}

}  // namespace
}  // namespace soms::view

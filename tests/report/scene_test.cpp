#include "apps/report/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soms::report {

namespace {

using Numbers = std::vector<std::size_t>;
using Steps64 = std::vector<std::uint64_t>;

TEST(Longest, KeepsOrderAndTakesTheFirstOfEquals) {
  const std::vector<Span> spans{{0, 0}, {1, 9}, {2, 2}, {3, 30}, {4, 4}};
  EXPECT_EQ(longest(spans, 9), (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(longest(spans, 3), (Numbers{0, 1, 3}));
  EXPECT_EQ(longest(spans, 1), (Numbers{3}));
  EXPECT_EQ(longest(spans, 0), Numbers{});
}

TEST(FairShares, GiveAllToTheModestAndEqualPartsToTheOthers) {
  EXPECT_EQ(fair_shares(Steps64{2, 50, 3, 70}, 25), (Steps64{2, 10, 3, 10}));
  EXPECT_EQ(fair_shares(Steps64{2, 50, 3}, 100), (Steps64{2, 50, 3}));
  EXPECT_EQ(fair_shares(Steps64{}, 5), Steps64{});
}

TEST(FairShares, GoToThoseWhoWantMostWhereNotAllCanHaveOne) {
  EXPECT_EQ(fair_shares(Steps64{1, 9, 1, 5}, 2), (Steps64{0, 1, 0, 1}));
}

TEST(SpreadSteps, HoldsFirstAndLastAndNoMoreThanRequested) {
  EXPECT_EQ(spread_steps(0, 5), Steps64{});
  EXPECT_EQ(spread_steps(1, 5), Steps64{0});
  EXPECT_EQ(spread_steps(4, 5), (Steps64{0, 1, 2, 3}));
  for (std::uint64_t count = 2; count < 60; ++count) {
    for (std::uint64_t most = 2; most < 12; ++most) {
      const Steps64 steps = spread_steps(count, most);
      EXPECT_LE(steps.size(), most);
      EXPECT_EQ(steps.front(), 0U);
      EXPECT_EQ(steps.back(), count - 1);
      EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
    }
  }
}

Scene many_bodies(std::size_t still, std::size_t moving) {
  Scene scene;
  for (std::size_t k = 0; k < still + moving; ++k) {
    scene.bodies.push_back({.name = "", .moves = k >= still});
  }
  return scene;
}

TEST(ChosenBodies, AreAllWhereThereIsRoom) {
  EXPECT_EQ(chosen_bodies(many_bodies(2, 5), 7).size(), 7U);
  EXPECT_EQ(chosen_bodies(many_bodies(0, 0), 7).size(), 0U);
}

TEST(ChosenBodies, AreThoseThatTouchBeforeOthers) {
  Scene scene = many_bodies(1, 99);
  scene.rows.push_back({.a = 50, .b = 0});
  scene.rows.push_back({.a = 60, .b = 97});
  const std::vector<std::uint32_t> ten = chosen_bodies(scene, 10);
  EXPECT_EQ(ten.size(), 10U);
  for (const std::uint32_t body : {0U, 50U, 60U, 97U}) {
    EXPECT_TRUE(std::binary_search(ten.begin(), ten.end(), body)) << body;
  }
  EXPECT_GT(*std::max_element(ten.begin(), ten.end() - 1), 80U);  // spread over all
  EXPECT_EQ(chosen_bodies(scene, 2).size(), 4U);
}

TEST(SharedOut, GivesSmallModelsAllAndLargeOnesTheRest) {
  Mesh small;
  small.triangles.resize(10);
  Mesh large;
  large.triangles.resize(1000);
  Scene scene = many_bodies(3, 0);
  scene.models = {{large, "large"}, {small, "small"}, {large, "large too"}};
  for (std::size_t k = 0; k < 3; ++k) {
    scene.bodies[k].model = k;
  }
  const std::vector<std::uint32_t> bodies{0, 1, 2};
  EXPECT_EQ(shared_out(scene, bodies, {.triangles = 5000}), (Steps64{1000, 10, 1000}));
  EXPECT_EQ(shared_out(scene, bodies, {.triangles = 210}), (Steps64{100, 10, 100}));
}

TEST(SharedOut, GivesLessToAModelThatIsDrawnManyTimes) {
  Mesh mesh;
  mesh.triangles.resize(1000);
  Scene scene = many_bodies(0, 100);
  scene.models = {{mesh, "car"}, {mesh, "unused"}};
  std::vector<std::uint32_t> bodies;
  for (std::uint32_t k = 0; k < 100; ++k) {
    bodies.push_back(k);
  }
  EXPECT_EQ(shared_out(scene, bodies, {.drawn_at_once = 20'000}), (Steps64{200, 0}));
  EXPECT_EQ(shared_out(scene, bodies, {.drawn_at_once = 1}), (Steps64{64, 0}));
}

}  // namespace

}  // namespace soms::report

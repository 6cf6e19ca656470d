#include "apps/draw/depth_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace soms::look {
namespace {

constexpr std::size_t kSide = 8;

DepthGrid grid_of_side() {
  return DepthGrid({.columns = kSide, .rows = kSide});
}

/// A triangle over the whole grid at a depth.
void cover(DepthGrid& grid, double depth, std::uint32_t number) {
  grid.draw({-1, -1, depth}, {30, -1, depth}, {-1, 30, depth}, number);
}

TEST(DepthGrid, ShowsTheNearestInAnyOrder) {
  DepthGrid near_first = grid_of_side();
  cover(near_first, 1, 7);
  cover(near_first, 2, 8);
  DepthGrid far_first = grid_of_side();
  cover(far_first, 2, 8);
  cover(far_first, 1, 7);
  for (std::size_t k = 0; k < kSide * kSide; ++k) {
    EXPECT_EQ(near_first.shown()[k], 7U);
    EXPECT_EQ(far_first.shown()[k], 7U);
    EXPECT_EQ(far_first.depths()[k], 1);
  }
}

TEST(DepthGrid, OfEquallyNearTheLaterIsShown) {
  DepthGrid grid = grid_of_side();
  cover(grid, 1, 7);
  cover(grid, 1, 8);
  EXPECT_EQ(std::count(grid.shown().begin(), grid.shown().end(), 8U), 64);
}

TEST(DepthGrid, TrianglesThatCrossShareTheSamples) {
  DepthGrid grid = grid_of_side();
  cover(grid, 4, 1);
  grid.draw({-8, -8, -8}, {24, -8, 24}, {-8, 24, -8}, 2);  // its depth is x
  for (std::size_t row = 0; row < kSide; ++row) {
    EXPECT_EQ(grid.shown()[row * kSide + 1], 2U);
    EXPECT_EQ(grid.shown()[row * kSide + 6], 1U);
  }
}

TEST(DepthGrid, WhatHasNoAreaIsNotShown) {
  DepthGrid grid = grid_of_side();
  grid.draw({1, 1, 0}, {5, 5, 0}, {3, 3, 0}, 1);
  grid.draw({1, std::nan(""), 0}, {5, 5, 0}, {3, 1, 0}, 2);
  EXPECT_EQ(std::count(grid.shown().begin(), grid.shown().end(), DepthGrid::kNothing), 64);
  EXPECT_EQ(grid.depths()[9], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace soms::look

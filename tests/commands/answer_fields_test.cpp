#include "apps/soms/answers/answer_fields.h"

#include "soms/query/closest.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/solid.h"
#include "soms/query/within.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

namespace soms::command {
namespace {

std::string empty_triangle(int /*side*/, const std::optional<TriangleId>& triangle) {
  return triangle ? std::to_string(*triangle) + ",," : ",,";
}

template <class T>
std::string cells_of(const T& answer) {
  std::string cells;
  add_field_cells(answer, empty_triangle, cells);
  return cells;
}

/// As many cells as the head has names.
template <class T>
void expect_as_many_cells(const T& answer) {
  const std::string head = field_head<T>();
  const std::string cells = cells_of(answer);
  EXPECT_EQ(std::count(head.begin(), head.end(), ','), std::count(cells.begin(), cells.end(), ','))
      << head << '\n'
      << cells;
}

TEST(AnswerFields, AFlagThatTimeLeftUnknownIsNoFalse) {
  const Within cut{.at_least = 0.25, .coverage = Coverage::cut};
  EXPECT_EQ(field_keys(cut), ",\"within\":null,\"at_least\":0.25");
  EXPECT_EQ(cells_of(cut), ",0.25,,,,,,,,,,,,,cut");
  const AnyHit unknown{.coverage = Coverage::cut};
  EXPECT_EQ(field_keys(unknown), ",\"hit\":null");
  EXPECT_EQ(cells_of(unknown), ",cut");
  EXPECT_EQ(field_keys(AnyHit{}), ",\"hit\":false");
  EXPECT_EQ(field_keys(AnyHit{.hit = true, .coverage = Coverage::cut}), ",\"hit\":true");
  EXPECT_EQ(field_keys(Within{.at_least = 1}), ",\"within\":false,\"at_least\":1");
}

TEST(AnswerFields, WhatIsNotThereIsLeftOut) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Closest farther{.distance = {2, kInfinity}, .farther = true};
  EXPECT_EQ(field_keys(farther), ",\"lower\":2,\"upper\":null,\"farther\":true");
  EXPECT_EQ(cells_of(farther), "2,inf,true,,,,,,,,complete");
  const Closest found{
      .distance = {1, 1}, .triangle = 7, .point = {1, 0, -0.5}, .feature = TriangleFeature::edge};
  EXPECT_EQ(field_keys(found),
            ",\"lower\":1,\"upper\":1,\"farther\":false,\"triangle\":7,\"point\":[1,0,-0.5],"
            "\"feature\":\"edge\"");
  EXPECT_EQ(cells_of(found), "1,1,false,7,,,1,0,-0.5,edge,complete");
}

TEST(AnswerFields, ARowHasAsManyCellsAsItsHead) {
  expect_as_many_cells(Within{});
  expect_as_many_cells(Within{.within = true, .triangles = TrianglePair{1, 2}});
  expect_as_many_cells(Within{.coverage = Coverage::cut});
  expect_as_many_cells(Distance{});
  expect_as_many_cells(Distance{.distance = {}, .triangles = TrianglePair{1, 2}});
  expect_as_many_cells(Closest{});
  expect_as_many_cells(Closest{.distance = {}, .triangle = 3});
  expect_as_many_cells(ClosestHit{});
  expect_as_many_cells(ClosestHit{.triangle = 3});
  expect_as_many_cells(AnyHit{.coverage = Coverage::cut});
  expect_as_many_cells(Solid{});
}

}  // namespace
}  // namespace soms::command

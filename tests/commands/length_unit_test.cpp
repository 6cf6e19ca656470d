// What lengths of a scene are called, and on the scale bar of a map.
#include "apps/cli/length_unit.h"

#include "apps/world/map_page.h"

#include <gtest/gtest.h>

#include <sstream>
#include <vector>

namespace soms::command {
namespace {

Body body_in(double unit) {
  Mesh mesh;
  mesh.unit = unit;
  return Body(mesh);
}

TEST(LengthUnit, IsWhatAllBodiesDeclare) {
  EXPECT_EQ(common_unit({}), 0);
  EXPECT_EQ(common_unit(std::vector{body_in(0.01), body_in(0.01)}), 0.01);
  EXPECT_EQ(common_unit(std::vector{body_in(0.01), body_in(1)}), 0);
  EXPECT_EQ(common_unit(std::vector{body_in(1), body_in(0)}), 0);
  EXPECT_EQ(common_unit(std::vector{body_in(0), body_in(0)}), 0);
}

TEST(LengthUnit, HasANameWhereItIsKnown) {
  EXPECT_EQ(unit_name(1), "m");
  EXPECT_EQ(unit_name(0.001F), "mm");
  EXPECT_EQ(unit_name(0.3048), "ft");
  EXPECT_EQ(unit_name(0), "units");
  EXPECT_EQ(unit_name(0.5), "units of 0.5 m");
  EXPECT_EQ(length_with_unit(500, 1), "500 m");
  EXPECT_EQ(length_with_unit(5000, 1), "5 km");
  EXPECT_EQ(length_with_unit(5000, 0), "5000 units");
}

TEST(LengthUnit, StandsAtTheScaleBar) {
  for (const auto& [unit, words] :
       {std::pair(1.0, ">20 m<"), std::pair(0.01, ">20 cm<"), std::pair(0.0, ">20 units<")}) {
    std::ostringstream out;
    close_map(out, make_map_page({{0, 0, 0}, {100, 100, 10}}, unit));
    EXPECT_NE(out.str().find(words), std::string::npos) << out.str();
  }
}

}  // namespace
}  // namespace soms::command

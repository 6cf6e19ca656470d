#include "soms/tree/option_names.h"

#include "soms/base/error.h"

#include "tests/support/support.h"

#include <string>

namespace soms {
namespace {

TEST(OptionNames, NameAndValueGoBothWays) {
  for (const Midpoint value : {Midpoint::thesis, Midpoint::centroid, Midpoint::aabb}) {
    EXPECT_EQ(midpoint_named(name(value)), value);
  }
  for (const AxisFrom value : {AxisFrom::outer, AxisFrom::inner}) {
    EXPECT_EQ(axis_from_named(name(value)), value);
  }
  for (const EmptySide value :
       {EmptySide::stop, EmptySide::next_axis, EmptySide::object_median, EmptySide::chain}) {
    EXPECT_EQ(empty_side_named(name(value)), value);
  }
  EXPECT_EQ(name(EmptySide::next_axis), "next_axis");
  EXPECT_EQ(empty_side_named("next-axis"), EmptySide::next_axis);
}

TEST(OptionNames, UnknownNamesListTheKnownOnes) {
  try {
    static_cast<void>(empty_side_named("halt"));
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_EQ(error.place(), "no empty side is named \"halt\"");
    EXPECT_EQ(error.remedy(), "choose one of stop, next_axis, object_median, chain");
  }
  EXPECT_THROW(static_cast<void>(midpoint_named("")), Error);
  EXPECT_THROW(static_cast<void>(axis_from_named("middle")), Error);
}

}  // namespace
}  // namespace soms

#include "soms/geometry/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soms {
namespace {

using Doubts = std::vector<FrameDoubt>;

constexpr CoordinateFrame kObj{};
constexpr CoordinateFrame kGltf{.unit = 1, .up = UpAxis::y};
constexpr CoordinateFrame kInches{.unit = 0.0254, .up = UpAxis::z};

Doubts both_orders(const CoordinateFrame& a, const CoordinateFrame& b) {
  Doubts doubts = compare_frames(a, b);
  EXPECT_EQ(doubts, compare_frames(b, a));
  return doubts;
}

/// With what the caller says of it: turned to z, its unit vouched for.
CoordinateFrame stated(CoordinateFrame frame, bool unit, bool up) {
  frame.unit_is_stated = unit;
  frame.up_is_stated = up;
  frame.up = up ? UpAxis::z : frame.up;
  return frame;
}

TEST(Frames, R117AreDoubtedWhereTheyDifferOrOneIsUnknown) {
  EXPECT_EQ(both_orders(kObj, kGltf), (Doubts{FrameDoubt::axis_unknown, FrameDoubt::unit_unknown}));
  EXPECT_EQ(both_orders(kInches, kGltf),
            (Doubts{FrameDoubt::axes_differ, FrameDoubt::units_differ}));
  EXPECT_EQ(both_orders({.up = UpAxis::z}, kObj), Doubts{FrameDoubt::axis_unknown});
  EXPECT_EQ(both_orders({.unit = 1}, {.unit = 1.00001}), Doubts{FrameDoubt::units_differ});
  EXPECT_EQ(both_orders(kGltf, kGltf), Doubts{});
  EXPECT_EQ(both_orders(kObj, kObj), Doubts{}) << "neither declares anything";
}

TEST(Frames, R117WhatTheCallerStatesIsNotDoubted) {
  EXPECT_EQ(both_orders(kObj, stated(kGltf, false, true)), Doubts{FrameDoubt::unit_unknown});
  EXPECT_EQ(both_orders(kObj, stated(kGltf, true, false)), Doubts{FrameDoubt::axis_unknown});
  EXPECT_EQ(both_orders(stated(kObj, true, true), stated(kGltf, false, true)), Doubts{});
  EXPECT_EQ(both_orders(kInches, stated(kGltf, true, true)), Doubts{});
  // One was turned to z, of the other its file says y: no word of the caller makes these the same.
  EXPECT_EQ(both_orders(stated(kObj, true, true), kGltf), Doubts{FrameDoubt::axes_differ});
}

TEST(Frames, UnitsThatDifferByTheRoundingOfAFloatAreTheSame) {
  EXPECT_EQ(both_orders({.unit = 0.001}, {.unit = double{0.1F} / 100}), Doubts{});
  EXPECT_TRUE(same_unit(0.3048, 0.3048));
  EXPECT_FALSE(same_unit(0.3048, 1200.0 / 3937)) << "the foot and the US survey foot";
}

TEST(Frames, AScaleThatDoesNotFitContradictsDeclaredUnits) {
  const CoordinateFrame meters{.unit = 1};
  const auto scaled = [](double unit, double scale) {
    return CoordinateFrame{.unit = unit / scale, .unit_is_stated = true, .scale = scale};
  };
  EXPECT_EQ(both_orders(meters, scaled(0.001, 0.001)), Doubts{});
  EXPECT_EQ(both_orders(meters, scaled(0.001, 0.01)), Doubts{FrameDoubt::units_differ});
  EXPECT_EQ(both_orders(meters, scaled(0.001, 1)), Doubts{}) << "the numbers fit as they are";
  EXPECT_EQ(both_orders(scaled(1, 1), scaled(0.001, 0.01)), Doubts{});
  EXPECT_EQ(both_orders(kObj, scaled(0.001, 0.01)), Doubts{}) << "no file contradicts";
  EXPECT_EQ(explain(FrameDoubt::units_differ, meters, "a", scaled(0.001, 0.01), "b"),
            "the unit is 1 m in a, and 0.1 m (after scaling by 0.01) in b");
}

TEST(Frames, AreExplainedWithWhatIsKnownFirst) {
  EXPECT_EQ(explain(FrameDoubt::axis_unknown, kObj, "a.obj", kGltf, "b.gltf"),
            "the up axis is y in b.gltf, and unknown in a.obj");
  EXPECT_EQ(explain(FrameDoubt::axes_differ, kInches, "a.dae", kGltf, "b.gltf"),
            "the up axis is z in a.dae, and y in b.gltf");
  EXPECT_EQ(explain(FrameDoubt::unit_unknown, kObj, "a.obj", kInches, "b.dae"),
            "the unit is 0.0254 m in b.dae, and unknown in a.obj");
  EXPECT_EQ(explain(FrameDoubt::units_differ, kGltf, "a.gltf", kInches, "b.dae"),
            "the unit is 1 m in a.gltf, and 0.0254 m in b.dae");
}

TEST(Frames, GapIsTheGreatestAlongAnAxis) {
  const Box unit{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(gap(unit, {{3, 5, 0}, {4, 6, 1}}), 4);
  EXPECT_EQ(gap({{3, 5, 0}, {4, 6, 1}}, unit), 4);
  EXPECT_EQ(gap(unit, {{1, 1, 1}, {2, 2, 2}}), 0);
  EXPECT_EQ(gap(unit, unit), 0);
  EXPECT_EQ(gap(unit, Box{}), 0);
  EXPECT_EQ(gap(Box{}, Box{}), 0);
}

TEST(Frames, R117BoxesAreFarApartByMoreThanEitherIsLong) {
  const Box long_box{{0, 0, 0}, {2, 8, 1}};
  const auto at = [](double x) { return Box{{x, 0, 0}, {x + 1, 1, 1}}; };
  EXPECT_FALSE(far_apart(long_box, at(2 + 8)));
  EXPECT_TRUE(far_apart(long_box, at(std::nextafter(2 + 8, 11))));
  EXPECT_TRUE(far_apart(at(std::nextafter(2 + 8, 11)), long_box));
  EXPECT_FALSE(far_apart(long_box, Box{}));
  const Box point{{0, 0, 0}, {0, 0, 0}};
  EXPECT_FALSE(far_apart(point, point));
  const Box far{{0x1p300, 0, 0}, {0x1p300, 1, 1}};
  EXPECT_TRUE(far_apart({{-0x1p300, 0, 0}, {-0x1p300, 1, 1}}, far));
}

}  // namespace
}  // namespace soms

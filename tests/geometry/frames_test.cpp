#include "soms/geometry/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soms {
namespace {

using Doubts = std::vector<FrameDoubt>;

const CoordinateFrame kObj{};
const CoordinateFrame kGltf{.unit = 1, .up = UpAxis::y};
const CoordinateFrame kInches{.unit = 0.0254, .up = UpAxis::z};

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

CoordinateFrame placed(const Georeference& georeference, bool stated = false) {
  return {.georeference = georeference, .georeference_is_stated = stated};
}

TEST(Frames, R117GeoreferencesAreDoubtedWhereTheyDifferOrOneIsUnknown) {
  const Georeference city{.crs = "EPSG:7415"};
  const Georeference site{.crs = "EPSG:7415", .map_conversion = MapConversion{.eastings = 8e4}};
  const Georeference datum{.crs = "EPSG:7415", .vertical_datum = "NAP"};
  const Doubts differ{FrameDoubt::georeferences_differ};
  const Doubts unknown{FrameDoubt::georeference_unknown};
  for (const Georeference& one : {city, site, datum}) {
    EXPECT_EQ(both_orders(placed(one), placed(one)), Doubts{});
    EXPECT_EQ(both_orders(placed(one), placed({})), unknown);
    EXPECT_EQ(both_orders(placed(one, true), placed({})), Doubts{}) << "the caller has seen both";
  }
  EXPECT_EQ(both_orders(placed({}), placed({})), Doubts{});
  EXPECT_EQ(both_orders(placed(city), placed(site)), differ);
  EXPECT_EQ(both_orders(placed(city), placed(datum)), differ);
  EXPECT_EQ(both_orders(placed(city, true), placed({.crs = "EPSG:28992"})), differ);
  MapConversion turned = *site.map_conversion;
  turned.abscissa = 0.6;
  turned.ordinate = 0.8;
  EXPECT_EQ(both_orders(placed(site), placed({.crs = "EPSG:7415", .map_conversion = turned})),
            differ);
  EXPECT_EQ(both_orders({.unit = 1, .up = UpAxis::z, .georeference = city}, kGltf),
            (Doubts{FrameDoubt::axes_differ, FrameDoubt::georeference_unknown}));
}

TEST(Frames, GeoreferencesAreExplainedByWhatDiffers) {
  const auto words = [](const Georeference& a, const Georeference& b) {
    const CoordinateFrame one = placed(a);
    const CoordinateFrame other = placed(b);
    return explain(compare_frames(one, other).at(0), one, "a", other, "b");
  };
  const Georeference city{.crs = "EPSG:7415"};
  const Georeference site{.crs = "EPSG:7415",
                          .map_conversion = MapConversion{.eastings = 311988, .unit = 1}};
  EXPECT_EQ(words({}, site),
            "the georeference is EPSG:7415; origin at east 311988, north 0, height 0 in b, and "
            "unknown in a");
  EXPECT_EQ(words(city, {.crs = "EPSG:28992"}),
            "the coordinate reference system is EPSG:7415 in a, and EPSG:28992 in b");
  EXPECT_EQ(words(city, {.vertical_datum = "NAP"}),
            "the coordinate reference system is EPSG:7415 in a, and unknown in b");
  EXPECT_EQ(words(city, {.crs = "EPSG:7415", .vertical_datum = "NAP"}),
            "the vertical datum is unknown in a, and NAP in b");
  EXPECT_EQ(words(site, city),
            "the map conversion is origin at east 311988, north 0, height 0 in a, and none in b");
  EXPECT_EQ(describe({.map_conversion = MapConversion{1, 2, 3, 0.6, 0.8, 4, {5, 6, 7}, 0.3048}}),
            "origin at east 1, north 2, height 3; x toward (0.6, 0.8); scale 4; factors (5, 6, 7); "
            "map units of 0.3048 m");
  EXPECT_EQ(describe({}), "none");
}

TEST(Frames, AGeoreferenceFollowsTheScaleAndIsGoneFromATurnedMesh) {
  Mesh mesh;
  mesh.vertices = {{1, 2, 3}};
  mesh.georeference = {.crs = "EPSG:7415"};
  EXPECT_EQ(transformed(mesh, 1, UpAxis::z).georeference, mesh.georeference);
  EXPECT_EQ(transformed(mesh, 4, UpAxis::z).georeference.map_conversion,
            MapConversion{.scale = 0.25});
  mesh.georeference.map_conversion = MapConversion{.eastings = 7, .scale = 3};
  EXPECT_EQ(transformed(mesh, 2, UpAxis::unknown).georeference.map_conversion,
            (MapConversion{.eastings = 7, .scale = 1.5}));
  EXPECT_TRUE(transformed(mesh, 1, UpAxis::y).georeference.empty());
  mesh.georeference = {.crs = "EPSG:7415"};
  EXPECT_EQ(transformed(transformed(mesh, 1000, UpAxis::z), 0.001, UpAxis::z).georeference,
            mesh.georeference)
      << "numbers that are those of the system again";
  EXPECT_TRUE(transformed(Mesh{}, 2, UpAxis::z).georeference.empty());
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

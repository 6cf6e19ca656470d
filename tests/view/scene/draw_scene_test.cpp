#include "apps/view/scene/draw_scene.h"

#include "soms/geometry/triangle_overlap.h"

#include "apps/view/scene/load.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace soms::view {
namespace {

Body box_at(const Vec3& lower, const Vec3& upper, const std::string& name, int cuts = 2) {
  Body body(test::box_body(lower, upper, cuts));
  body.name = name;
  return body;
}

/// Two cubes of side 2; the second is moved by hand.
ViewScene cubes() {
  return ViewScene(
      two_bodies(box_at({0, 0, 0}, {2, 2, 2}, "still"), box_at({0, 0, 0}, {2, 2, 2}, "moving")));
}

bool same(const Triangle& a, const Triangle& b) {
  return a == b;
}

std::size_t count(const std::vector<TriangleMark>& marks, const Triangle& t) {
  return static_cast<std::size_t>(std::count_if(
      marks.begin(), marks.end(), [&](const TriangleMark& m) { return same(m.corners, t); }));
}

ViewOptions without_gap() {
  ViewOptions options;
  options.gap = false;
  options.contacts.triangles = true;
  options.contacts.segments = false;  // of which areas in common are marks
  return options;
}

/// Every triangle of every body is red exactly if it touches one of another body, by brute force.
void expect_red_where_touching(ViewScene& scene) {
  const DrawList list = make_draw_list(scene, without_gap());
  check(list);
  const BodyRef a = city_part(0);
  const BodyRef b = mover(0);
  std::size_t touching = 0;
  for (const auto& [of, other] : {std::pair(a, b), std::pair(b, a)}) {
    for (TriangleId i = 0; i < scene.body(of).shape.mesh().triangles.size(); ++i) {
      const Triangle t = scene.triangle(of, i);
      bool touches = false;
      for (TriangleId j = 0; j < scene.body(other).shape.mesh().triangles.size(); ++j) {
        touches = touches || triangles_overlap(t, scene.triangle(other, j));
      }
      EXPECT_EQ(count(list.marks, t) > 0, touches);
      touching += touches ? 1U : 0U;
    }
  }
  for (const TriangleMark& mark : list.marks) {
    EXPECT_EQ(mark.color, ViewColors{}.contact);
  }
  EXPECT_LE(list.marks.size(), touching);  // triangles that coincide are marked for each body
}

TEST(DrawScene, MarksTouchingTrianglesAndNoOthers) {
  ViewScene scene = cubes();
  for (const double x : {0.0, 0.7, 1.0, 2.0, 2.5}) {
    scene.set_pose(0, Pose::translation(x, 0.3, 0.1));
    expect_red_where_touching(scene);
  }
  scene.set_pose(0, Pose::about_z(0.4, {1.2, 0.5, 0.3}));
  expect_red_where_touching(scene);
}

TEST(DrawScene, DrawsNothingRedWhereNothingTouches) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(5, 0, 0));
  const DrawList list = make_draw_list(scene, without_gap());
  EXPECT_TRUE(list.marks.empty());
  EXPECT_TRUE(list.lines.empty());
  EXPECT_TRUE(list.points.empty());
  EXPECT_EQ(list.instances.size(), 2U);
  EXPECT_EQ(list.instances[1].pose, Pose::translation(5, 0, 0));
}

TEST(DrawScene, KeepsKeysAndMeshesFromFrameToFrame) {
  ViewScene scene = cubes();
  const DrawList before = make_draw_list(scene, {});
  scene.set_pose(0, Pose::translation(1, 0, 0));
  const DrawList after = make_draw_list(scene, {});
  ASSERT_EQ(before.meshes.size(), after.meshes.size());
  for (std::size_t k = 0; k < before.meshes.size(); ++k) {
    EXPECT_EQ(before.meshes[k].key, after.meshes[k].key);
    EXPECT_EQ(before.meshes[k].version, after.meshes[k].version);
    EXPECT_EQ(before.meshes[k].mesh.get(), after.meshes[k].mesh.get());
    EXPECT_EQ(before.meshes[k].colors.get(), after.meshes[k].colors.get());
  }
}

TEST(DrawScene, NamesAMeshOfManyMoversOnce) {
  SceneContent content;
  const Shape block(test::box_body({0, 0, 0}, {1, 1, 1}));
  for (int k = 0; k < 100; ++k) {
    content.movers.push_back({Body(block, Pose::translation(3 * k, 0, 0)), {}});
  }
  ViewScene scene(std::move(content));
  const DrawList list = make_draw_list(scene, {});
  EXPECT_EQ(list.meshes.size(), 1U);
  EXPECT_EQ(list.instances.size(), 100U);
  std::set<std::uint8_t> reds;
  for (const Instance& instance : list.instances) {
    EXPECT_GE(instance.color.b, instance.color.r);  // one hue, in tints
    reds.insert(instance.color.r);
  }
  EXPECT_EQ(reds.size(), 4U);
}

TEST(DrawScene, DrawsSegmentsWhereTrianglesCross) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::about_z(0.3, {0.9, 0.4, 0.7}));
  ViewOptions options;
  options.contacts.triangles = false;
  const DrawList list = make_draw_list(scene, options);
  EXPECT_TRUE(list.marks.empty());
  std::size_t segments = 0;
  for (const Touch& touch : scene.contacts()) {
    segments += scene.common_points(touch).count == 2 ? 1U : 0U;
  }
  EXPECT_GT(segments, 4U);
  // With rims, without, and pale where surfaces hide them.
  EXPECT_EQ(list.lines.size(), 3 * segments);
  for (const Line& line : list.lines) {
    EXPECT_GE(line.on_top ? 3 : line.width, 3);
  }
  options.contacts.lines = true;
  EXPECT_EQ(make_draw_list(scene, options).lines.size(), 3 * segments + scene.contacts().size());
}

TEST(DrawScene, PutsOneMarkerOnEachMoverThatTouches) {
  SceneContent content;
  content.city.push_back(box_at({0, -1, 0}, {100, 1, 1}, "wall"));
  const Shape block(test::box_body({0, 0, 0}, {1, 1, 1}));
  for (int k = 0; k < 20; ++k) {
    // Every other one stands in the wall.
    content.movers.push_back({Body(block, Pose::translation(5 * k, k % 2 == 0 ? 0 : 9, 0.5)), {}});
  }
  // One more touches none but the last, from above.
  content.movers.push_back({Body(block, Pose::translation(95, 9, 1.25)), {}});
  ViewScene scene(std::move(content));
  ViewOptions options;
  const DrawList list = make_draw_list(scene, options);
  ASSERT_EQ(list.markers.size(), 12U);
  EXPECT_EQ(list.markers.size(), scene.statistics().touching_movers);
  for (const Marker& marker : list.markers) {
    EXPECT_EQ(marker.count, 1U);
    EXPECT_FALSE(marker.always);
    EXPECT_GT(marker.reach, 0);
    EXPECT_LT(marker.reach, 1);
  }
  for (std::uint32_t k = 0; k < 10; ++k) {
    EXPECT_TRUE(scene.bounds(mover(2 * k)).contains({list.markers[k].at, list.markers[k].at}));
  }
  options.contacts.all_markers = true;
  EXPECT_TRUE(make_draw_list(scene, options).markers[0].always);
  options.contacts.markers = false;
  EXPECT_TRUE(make_draw_list(scene, options).markers.empty());
}

TEST(DrawScene, RedReachesAsFarAsTheMoverIsLargeNotTheWall) {
  Mesh wall;
  wall.vertices = {{-500, 0, -500}, {500, 0, -500}, {0, 0, 800}};
  wall.triangles = {{0, 1, 2}};
  ViewScene scene(two_bodies(Body(std::move(wall)), box_at({-1, -1, -1}, {1, 1, 1}, "block")));
  scene.set_pose(0, Pose::translation(0, 0.5, 0));
  const DrawList list = make_draw_list(scene, {});
  EXPECT_TRUE(list.marks.empty()) << "no triangle is painted whole";
  ASSERT_FALSE(list.glows.empty());
  const Box block = scene.bounds(mover(0));
  for (const Glow& glow : list.glows) {
    EXPECT_LT(glow.radius, 1);
    EXPECT_TRUE(block.contains({glow.a, glow.a}) && block.contains({glow.b, glow.b}));
  }
  ViewOptions options;
  options.contacts.glow = false;
  EXPECT_TRUE(make_draw_list(scene, options).glows.empty());
}

TEST(DrawScene, TheGroundIsBelowTheSceneAndTheKeySaysWhatThereIs) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(5, 0, 0));
  const auto signs = [&](const ViewOptions& options) {
    std::vector<std::string> words;
    for (const KeyEntry& entry : make_draw_list(scene, options).captions.key) {
      words.push_back(entry.text);
    }
    return words;
  };
  ViewOptions options;
  options.gap = false;
  EXPECT_EQ(signs(options), (std::vector<std::string>{"moving", "still"}));
  scene.set_pose(0, Pose::translation(1, 1, 1));
  EXPECT_EQ(signs(options),
            (std::vector<std::string>{"moving", "still", "contact", "n movers in contact"}));
  options.level = LevelBoxes{.body = city_part(0), .level = 2};
  EXPECT_EQ(signs(options)[2], "boxes of level 2");
  options.key = false;
  EXPECT_TRUE(signs(options).empty());
  const DrawList list = make_draw_list(scene, options);
  ASSERT_TRUE(list.ground);
  EXPECT_LT(list.ground->center.z, 0);
  EXPECT_GT(list.ground->center.z, -0.01);
  options.ground = false;
  EXPECT_FALSE(make_draw_list(scene, options).ground);
}

TEST(DrawScene, WhereBoxesThatCollideAreRedSurfacesThatTouchAreNot) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(1, 1, 1));
  ViewOptions options;
  options.contacts.triangles = true;
  const DrawList plain = make_draw_list(scene, options);
  EXPECT_EQ(plain.glow_color, palette::kContact);
  options.trace = TraceBoxes{.visited = true, .pruned = false, .found = true};
  const DrawList boxes = make_draw_list(scene, options);
  EXPECT_EQ(boxes.glow_color, palette::kViolet);
  ASSERT_FALSE(boxes.marks.empty());
  for (const TriangleMark& mark : boxes.marks) {
    EXPECT_EQ(mark.color, palette::kViolet);
  }
  ASSERT_FALSE(boxes.lines.empty());
  EXPECT_EQ(with_alpha(boxes.lines[0].color, 255), palette::kViolet);
  ASSERT_FALSE(boxes.box_groups.empty());
  EXPECT_EQ(boxes.box_groups[1].boxes[0].color, palette::kContact);
  std::vector<std::string> words;
  for (const KeyEntry& entry : boxes.captions.key) {
    words.push_back(entry.text);
  }
  EXPECT_EQ(words,
            (std::vector<std::string>{"moving", "still", "boxes visited", "boxes that collide",
                                      "surfaces that touch", "n movers in contact"}));
  options.trace->found = false;  // nothing else is red then
  EXPECT_EQ(make_draw_list(scene, options).glow_color, palette::kContact);
}

TEST(DrawScene, MarksThePartsThatTouch) {
  Mesh house =
      test::joined(test::box_body({0, 0, 0}, {4, 4, 1}), test::box_body({0, 0, 1.5}, {4, 4, 3}));
  house.parts = {{"floor", Part::kNoParent, 0, 12}, {"upper", Part::kNoParent, 12, 12}};
  ViewScene scene(two_bodies(Body(std::move(house)), box_at({0, 0, 0}, {1, 1, 1}, "block", 1)));
  scene.set_pose(0, Pose::translation(-0.5, 1, 1.75));
  ViewOptions options;
  options.contacts.parts = true;
  options.contacts.triangles = false;
  const DrawList list = make_draw_list(scene, options);
  EXPECT_EQ(list.marks.size(), 12U);  // the upper floor; the block has no parts
  for (TriangleId i = 0; i < 24; ++i) {
    EXPECT_EQ(count(list.marks, scene.triangle(city_part(0), i)), i < 12 ? 0U : 1U);
  }
  options.contacts.most_of_parts = 11;
  const DrawnScene without = draw_scene(scene, options);
  EXPECT_TRUE(without.list.marks.empty());
  EXPECT_EQ(without.counts.part_triangles, 12U);
  EXPECT_EQ(without.counts.part_triangles_drawn, 0U);
}

TEST(DrawScene, BoundsWhatManyContactsDraw) {
  ViewScene scene(two_bodies(box_at({0, 0, 0}, {2, 2, 2}, "still", 12),
                             box_at({0, 0, 0}, {2, 2, 2}, "moving", 12)));
  ASSERT_GT(scene.contacts().size(), 5000U);
  ViewOptions options;
  options.contacts.most = 300;
  const DrawList list = make_draw_list(scene, options);
  EXPECT_LE(list.marks.size(), 1200U);
  EXPECT_LE(list.lines.size(), 5400U);
  const ShownCounts counts = draw_scene(scene, options).counts;
  EXPECT_EQ(counts.contacts, scene.contacts().size());
  EXPECT_EQ(counts.contacts_drawn, 300U);
  const std::vector<Touch> some = drawn_contacts(scene, 300);
  EXPECT_EQ(some.size(), 300U);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end()));
  EXPECT_EQ(std::set<Touch>(some.begin(), some.end()).size(), 300U);
}

TEST(DrawScene, SaysWhatFoundNoRoom) {
  EXPECT_TRUE(left_out({}).empty());
  EXPECT_EQ(left_out({.contacts = 12'345,
                      .contacts_drawn = 2'000,
                      .part_triangles = 30'000,
                      .boxes = 1'000'000,
                      .boxes_drawn = 50'000}),
            (std::vector<std::string>{"2,000 of 12,345 contacts", "0 of 30,000 triangles of parts",
                                      "50,000 of 1,000,000 boxes"}));
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(1, 1, 1));
  ViewOptions options;
  options.level = LevelBoxes{.body = city_part(0), .level = 3};
  EXPECT_TRUE(left_out(draw_scene(scene, options).counts).empty());
  options.most_boxes = 1;
  options.contacts.most = 1;
  EXPECT_EQ(left_out(draw_scene(scene, options).counts).size(), 2U);
  options.contacts.glow = options.contacts.segments = false;  // not requested
  EXPECT_EQ(left_out(draw_scene(scene, options).counts).size(), 1U);
}

TEST(DrawScene, HidesWhatIsNotWanted) {
  ViewScene scene = cubes();
  ViewOptions options;
  options.city = false;
  EXPECT_EQ(make_draw_list(scene, options).instances.size(), 1U);
  options.movers = false;
  EXPECT_TRUE(make_draw_list(scene, options).instances.empty());
}

TEST(DrawScene, ShowsTheChosenThroughEverything) {
  ViewScene scene = cubes();
  scene.set_pose(0, Pose::translation(1, 1, 1));
  ViewOptions options;
  options.chosen = scene.contacts().front();
  options.highlighted = mover(0);
  options.contacts.triangles = false;
  options.contacts.segments = false;
  const DrawList list = make_draw_list(scene, options);
  ASSERT_GE(list.lines.size(), 6U) << "the outlines of both triangles";
  for (const Line& line : list.lines) {
    EXPECT_TRUE(line.on_top);
  }
  EXPECT_FALSE(list.instances[0].highlighted);
  EXPECT_TRUE(list.instances[1].highlighted);
}

TEST(DrawScene, ColorsTheCityByBuildingOrPlain) {
  ViewScene scene = cubes();
  ViewOptions options;
  const DrawList colored = make_draw_list(scene, options);
  ASSERT_NE(colored.meshes[0].colors, nullptr);
  options.city_colors = CityColors::plain;
  const DrawList plain = make_draw_list(scene, options);
  EXPECT_EQ(plain.meshes[0].colors, nullptr);
  EXPECT_NE(plain.meshes[0].key, colored.meshes[0].key);
}

}  // namespace
}  // namespace soms::view

#include "apps/view/verbs/render_camera.h"

#include "soms/base/error.h"
#include "soms/generate/shapes.h"

#include "apps/view/scene/load.h"
#include "apps/view/verbs/stage.h"
#include "tests/support/bodies.h"
#include "tests/support/support.h"

#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace soms::view {
namespace {

ViewScene two_spheres(double apart) {
  const Body still(generate_sphere(200));
  return ViewScene(two_bodies(still, Body(still.shape, Pose::translation(apart, 0, 0))));
}

TEST(ParseCamera, TakesSubjectSideAndZoomInAnyOrder) {
  const CameraChoice a = parse_camera("2x,mover:3,north");
  EXPECT_EQ(a.subject, CameraChoice::Subject::mover);
  EXPECT_EQ(a.mover, 3U);
  EXPECT_EQ(a.bearing, 0);
  EXPECT_EQ(a.zoom, 2);
  EXPECT_FALSE(a.free_side);
  const CameraChoice b = parse_camera("contact 120.5:-10");
  EXPECT_EQ(b.subject, CameraChoice::Subject::contact);
  EXPECT_EQ(b.bearing, 120.5);
  EXPECT_EQ(b.elevation, -10);
  EXPECT_TRUE(parse_camera("contact").free_side);
  const CameraChoice c = parse_camera("-1 2 3.5 4 5 6e0");
  EXPECT_EQ(c.subject, CameraChoice::Subject::place);
  EXPECT_EQ(c.eye, (Vec3{-1, 2, 3.5}));
  EXPECT_EQ(c.target, (Vec3{4, 5, 6}));
}

TEST(ParseCamera, RefusesWhatMakesNoSense) {
  for (const char* text : {"", " , ", "1 2 3", "1 2 3 1 2 3", "nowhere", "0x", "-2x", "10:91",
                           "1e7x", "1e-7x", "mover:x", "10:", "1 2 3 4 5 nan"}) {
    EXPECT_THROW((void)parse_camera(text), Error) << text;
  }
}

TEST(PlaceCamera, SeesTheSceneFromTheNamedSide) {
  const ViewScene scene = two_spheres(5);
  const Size size{300, 200};
  const Camera north = place_camera(parse_camera("north"), scene, size, {});
  EXPECT_GT(north.eye.y, 2);
  const Camera east = place_camera(parse_camera("90:0"), scene, size, {});
  EXPECT_GT(east.eye.x, 5);
  EXPECT_NEAR(frame(east).forward.x, -1, 1e-6);
  const Box all = scene_bounds(scene);
  EXPECT_GT(all.upper.x, 5.5);
  for (const Vec3& p : {all.lower, all.upper}) {
    const auto seen = project(north, size, p);
    ASSERT_TRUE(seen.has_value());
    EXPECT_GE(seen->pixel.x, -0.05 * size.width);
    EXPECT_LE(seen->pixel.x, 1.05 * size.width);
  }
  const Camera nearer = place_camera(parse_camera("north,2x"), scene, size, {});
  EXPECT_NEAR(distance_to_target(nearer), distance_to_target(north) / 2, 1e-9);
  const Camera placed =
      place_camera(parse_camera("0 -9 0 0 0 0"), scene, size, Vec3{100, 200, 300});
  EXPECT_EQ(placed.eye, (Vec3{100, 191, 300}));
}

TEST(PlaceCamera, SeesAllOfAMeshThatIsLookedAtInSamples) {
  Mesh field;
  constexpr std::uint32_t kTriangles = 410'000;
  for (std::uint32_t i = 0; i < kTriangles; ++i) {
    const auto x = static_cast<double>(i % 700);
    const std::uint32_t row = i / 700;
    const double y = row;
    field.vertices.insert(field.vertices.end(), {{x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0}});
    field.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Vec3 mast{350, 300, 2000};
  field.vertices[3 * (kTriangles / 2) + 2] = mast;
  SceneContent content;
  content.city.emplace_back(std::move(field));
  const ViewScene scene(std::move(content));
  const Size size{300, 200};
  for (const char* side : {"scene", "north", "top", "120:-40"}) {
    const auto seen = project(place_camera(parse_camera(side), scene, size, {}), size, mast);
    ASSERT_TRUE(seen.has_value()) << side;
    EXPECT_TRUE(seen->pixel.x >= 0 && seen->pixel.x <= size.width) << side;
    EXPECT_TRUE(seen->pixel.y >= 0 && seen->pixel.y <= size.height) << side;
  }
}

TEST(PlaceCamera, FindsAFreeSideOfTheContact) {
  const ViewScene scene = two_spheres(1);
  ASSERT_FALSE(scene.contacts().empty());
  const Camera camera = place_camera(parse_camera("contact"), scene, {300, 200}, {});
  EXPECT_GT(distance_to_target(camera), 1);
  EXPECT_THROW((void)place_camera(parse_camera("contact"), two_spheres(50), {300, 200}, {}), Error);
  EXPECT_THROW((void)place_camera(parse_camera("mover:1"), scene, {300, 200}, {}), Error);
}

TEST(PlaceCamera, SeesAContactThatAWallHidesFromMostSides) {
  // A cube stands in a niche that is open to the east alone, and touches its floor.
  Mesh niche = test::box_body({-3, -3, -1}, {3, 3, 0});
  for (const auto& [lower, upper] :
       {std::pair(Vec3{-3, -3, 0}, Vec3{-2, 3, 6}), std::pair(Vec3{-2, -3, 0}, Vec3{3, -2, 6}),
        std::pair(Vec3{-2, 2, 0}, Vec3{3, 3, 6}), std::pair(Vec3{-3, -3, 6}, Vec3{3, 3, 7})}) {
    niche = test::joined(niche, test::box_body(lower, upper));
  }
  const Shape cube(test::box_body({-1, -1, -0.25}, {1, 1, 1}));
  const ViewScene scene(two_bodies(Body(std::move(niche)), Body(cube)));
  ASSERT_FALSE(scene.contacts().empty());
  const Camera camera = place_camera(parse_camera("contact"), scene, {300, 200}, {});
  EXPECT_GT(camera.eye.x, 3);
  EXPECT_GT(std::abs(camera.eye.x), std::abs(camera.eye.y));
}

// Two spheres that touch in a closed box: from outside, its walls hide them on every side.
TEST(PlaceCamera, CutsAwayWhatHidesAContactOnEverySide) {
  const Body sphere(generate_sphere(200));
  const Mesh room =
      test::joined(test::box_body({-9, -9, -9}, {9, 9, 9}), Mesh(sphere.shape.mesh()));
  const ViewScene scene(two_bodies(Body(room), Body(sphere.shape, Pose::translation(1.5, 0, 0))));
  CameraChoice choice = parse_camera("contact");
  const Size size{300, 200};
  EXPECT_EQ(place_camera(choice, scene, size, {}).cut, 0) << "not unless it may";
  choice.may_cut = true;
  const Camera camera = place_camera(choice, scene, size, {});
  const double to_mover = dot(Vec3{1.5, 0, 0} - camera.eye, frame(camera).forward);
  EXPECT_GT(camera.cut, 0);
  EXPECT_LT(camera.cut, to_mover - 0.9);
  EXPECT_GT(camera.cut, to_mover - 3) << "the floor that is seen stays, too";
  choice.free_side = false;
  EXPECT_EQ(place_camera(choice, scene, size, {}).cut, 0) << "the side was named";
}

TEST(PlaceCamera, FromANamedSideLooksAtAContactThatIsSeenFromThere) {
  // Two cubes lean on a wall; the one with more contacts stands to its south.
  SceneContent content;
  content.city.emplace_back(test::box_body({-20, -1, 0}, {60, 0, 30}));
  for (const auto& [lower, upper, parts] : {std::tuple(Vec3{-2, -4.8, 2}, Vec3{2, -0.8, 6}, 6),
                                            std::tuple(Vec3{38, -0.2, 2}, Vec3{42, 3.8, 6}, 1)}) {
    content.movers.push_back({Body(test::box_body(lower, upper, parts)), {}});
  }
  const ViewScene scene(std::move(content));
  const auto looks_at = [&](const char* camera) {
    return place_camera(parse_camera(camera), scene, {300, 200}, {}).target.x;
  };
  EXPECT_LT(looks_at("contact,south"), 10);
  EXPECT_GT(looks_at("contact,north"), 30);
}

TEST(PlaceCamera, CutsNothingAwayWhereTheContactIsSeen) {
  CameraChoice choice = parse_camera("contact");
  choice.may_cut = true;
  EXPECT_EQ(place_camera(choice, two_spheres(1.5), {300, 200}, {}).cut, 0);
}

TEST(PlaceCamera, OneMoverFarAwayDoesNotRuleTheFrameAndManyDo) {
  const Body still(generate_sphere(200));
  const auto scene_with = [&](int far) {
    SceneContent content;
    content.city.push_back(still);
    for (int k = 0; k < 40; ++k) {
      content.movers.push_back(
          {Body(still.shape, Pose::translation(k < far ? 4e6 + k : 3, 0, 0)), {}});
    }
    return ViewScene(std::move(content));
  };
  const auto reach = [](const ViewScene& scene) {
    return distance_to_target(place_camera(parse_camera("scene"), scene, {300, 200}, {}));
  };
  const double near = reach(scene_with(0));
  EXPECT_EQ(astray_movers(scene_with(1)), (std::vector<std::uint32_t>{0}));
  EXPECT_NEAR(reach(scene_with(1)), near, 1e-9);
  EXPECT_TRUE(astray_movers(scene_with(3)).empty());
  EXPECT_GT(reach(scene_with(3)), 1e6);
}

TEST(SunFor, StandsAtTheLeftUnlessAWallHidesIt) {
  const Camera camera{{0, -20, 10}, {0, 0, 0}, {0, 0, 1}, 0.8};
  const auto east_of = [&](const Box& wall) {
    return sun_for(camera, ViewScene(two_bodies(Body(test::box_body(wall.lower, wall.upper)),
                                                Body(test::box_body({-1, -1, -1}, {1, 1, 1})))))
        .x;
  };
  EXPECT_LT(east_of({{-9, 90, 0}, {-8, 99, 9}}), 0);
  EXPECT_GT(east_of({{-9, -90, 0}, {-8, 90, 90}}), 0) << "the wall is at the left";
  EXPECT_LT(east_of({{-90, -90, 80}, {90, 90, 81}}), 0) << "a roof hides it everywhere";
}

TEST(GroundLevel, IsWhereMoversStandOverNothing) {
  const auto level = [](double x, double z) {
    SceneContent content;
    content.city.emplace_back(test::box_body({0, 0, 0}, {50, 50, 100}));
    content.movers.push_back(
        {Body(Shape(test::box_body({0, 0, 0}, {1, 1, 1})), Pose::translation(x, 0, z)), {}});
    return ground_level({}, ViewScene(std::move(content)), -0.1);
  };
  EXPECT_NEAR(level(60, 3), 3, 0.1) << "a car beside the house";
  EXPECT_LT(level(60, 3), 3);
  EXPECT_EQ(level(60, 40), -0.1) << "a drone";
  EXPECT_EQ(level(20, 3), -0.1) << "a car in the house stands over its floor";
}

bool is_seen(const Camera& camera, const Vec3& point) {
  const auto seen = project(camera, {300, 200}, point);
  return seen && seen->pixel.x > 0 && seen->pixel.x < 300 && seen->pixel.y > 0 &&
         seen->pixel.y < 200;
}

TEST(PlaceCamera, KeepsTheGapInThePicture) {
  for (const double apart : {2.01, 3.0, 9.0, 400.0}) {
    const ViewScene scene = two_spheres(apart);
    const Distance near = scene.gap()->distance;
    for (const char* text : {"scene", "top", "north", "gap", "gap,top", "gap,90:10", "mover:0"}) {
      CameraChoice choice = parse_camera(text);
      choice.with_gap = true;
      const Camera camera = place_camera(choice, scene, {300, 200}, {});
      EXPECT_TRUE(is_seen(camera, near.point_a)) << text << ' ' << apart;
      EXPECT_TRUE(is_seen(camera, near.point_b)) << text << ' ' << apart;
    }
  }
}

TEST(PlaceCamera, SeesAGapFromBesideItNotAlongIt) {
  const ViewScene scene = two_spheres(3);
  CameraChoice choice = parse_camera("gap");
  choice.with_gap = true;
  const Camera camera = place_camera(choice, scene, {300, 200}, {});
  const Distance near = scene.gap()->distance;
  const Vec3 along = near.point_b - near.point_a;
  const Vec3 line = camera.target - camera.eye;
  EXPECT_LT(std::abs(dot(along, line)), 0.5 * std::sqrt(dot(along, along) * dot(line, line)));
  const auto first = scene.pick({camera.eye, frame(camera).forward});
  EXPECT_TRUE(!first || first->distance > distance_to_target(camera)) << "nothing stands before it";
}

TEST(PlaceCamera, RefusesAGapThatIsNotDrawn) {
  CameraChoice choice = parse_camera("gap");
  EXPECT_THROW((void)place_camera(choice, two_spheres(5), {300, 200}, {}), Error);
  choice.with_gap = true;
  EXPECT_THROW((void)place_camera(choice, two_spheres(1), {300, 200}, {}), Error);
}

TEST(PlaceCamera, CountsContactsOfBothMovers) {
  // Movers 0 to 2 touch mover 3, each from another side; nobody touches more than it.
  const Shape cube(test::box_body({-1, -1, -1}, {1, 1, 1}, 4));
  SceneContent content;
  for (const Vec3& at : {Vec3{-1.9, 0, 0}, Vec3{1.9, 0, 0}, Vec3{0, 1.9, 0}, Vec3{0, 0, 0}}) {
    content.movers.push_back({Body(cube, Pose::translation(at.x, at.y, at.z)), {}});
  }
  const ViewScene scene(std::move(content));
  ASSERT_FALSE(scene.contacts().empty());
  const Camera contact = place_camera(parse_camera("contact,top"), scene, {300, 200}, {});
  const Camera most = place_camera(parse_camera("mover:3,top"), scene, {300, 200}, {});
  EXPECT_EQ(contact, most);
}

}  // namespace
}  // namespace soms::view

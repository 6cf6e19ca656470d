#include "apps/report/motion_data.h"

#include "soms/generate/shapes.h"

#include "apps/report/page.h"
#include "tests/report/reading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace soms::report {

namespace {

using MotionJson = nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// A body that turns and one that is shifted, of a scene that is far away and small.
Scene two_motions() {
  const Pose start = Pose::about_z(0.3, {1000, -5, 2});
  const Pose end = Pose::from_axis_angle({1, 2, 3}, 1.2) * start;
  Scene scene;
  scene.bodies = {{.model = 0, .name = "mover", .moves = true}};
  scene.motions = {{.motion = RigidMotion::between(start, end, {0.5, 1, -2}),
                    .number = 7,
                    .blocked = true,
                    .t = {0.25, 0.5},
                    .moment = 0.5,
                    .place = Vec3{1001, 2, 3},
                    .verdict = "t = 0.5",
                    .words = "free until <0.25>"},
                   {.motion = RigidMotion::along(start, {4, 5, 6}), .t = {1, kNone}}};
  scene.motions_in_all = 9;
  return scene;
}

MotionJson motions_of(const Scene& scene, const MotionFrame& frame) {
  return MotionJson::parse("{" + motions_json(scene, frame).substr(1) + "}");
}

/// Where the law of the page has the middle of the body, as motions.js works it out.
Vec3 middle_at(const MotionJson& motion, double t) {
  const auto between = [&](const char* key, std::size_t part) {
    const MotionJson& ends = motion.at(key);
    const double from = ends.at(0).at(part);
    return from + t * (ends.at(1).at(part).get<double>() - from);
  };
  const RigidMotion::Quaternion q{between("turns", 3), between("turns", 0), between("turns", 1),
                                  between("turns", 2)};
  const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  const Pose turn = Pose::from_quaternion(q[0] / size, q[1] / size, q[2] / size, q[3] / size);
  const MotionJson& arm = motion.at("arm");
  return Vec3{between("way", 0), between("way", 1), between("way", 2)} +
         turn.apply({arm.at(0), arm.at(1), arm.at(2)});
}

TEST(MotionData, MovesTheBodyAsTheMotionDoes) {
  const MotionFrame frame{.middle = {3, -1, 2}, .origin = {1000, 0, 0}, .scale = 0.25};
  const Scene scene = two_motions();
  const MotionJson motions = motions_of(scene, frame).at("motions");
  for (std::size_t k = 0; k < 2; ++k) {
    for (const double t : {0.0, 0.125, 0.5, 0.9, 1.0}) {
      const Vec3 found = middle_at(motions.at(k), t);
      const Vec3 moved = scene.motions[k].motion.pose_at(t).apply(frame.middle);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(found[axis], (moved[axis] - frame.origin[axis]) * frame.scale, 1e-9)
            << k << ' ' << t;
      }
    }
  }
}

TEST(MotionData, SaysWhatIsKnownOfEach) {
  const std::string text = motions_json(two_motions(), {});
  EXPECT_EQ(text.find('<'), std::string::npos);
  const MotionJson all = MotionJson::parse("{" + text.substr(1) + "}");
  EXPECT_EQ(all.at("motions_in_all"), 9);
  const MotionJson& first = all.at("motions").at(0);
  EXPECT_EQ(first.at("number"), 7);
  EXPECT_EQ(first.at("blocked"), true);
  EXPECT_EQ(first.at("lower"), 0.25);
  EXPECT_EQ(first.at("upper"), 0.5);
  EXPECT_EQ(first.at("row"), 0);
  EXPECT_EQ(first.at("place"), MotionJson({1001, 2, 3}));
  EXPECT_EQ(first.at("words"), "free until <0.25>");
  const MotionJson& second = all.at("motions").at(1);
  EXPECT_EQ(second.at("row"), -1);
  EXPECT_TRUE(second.at("place").is_null());
  EXPECT_TRUE(second.at("upper").is_null());
}

TEST(MotionData, APageOfMotionsHasAWayInPlaceOfSteps) {
  const Mesh mesh = generate_knot(500);
  Page page{.title = "title", .lead = "lead", .facts = {}, .plots = {}, .notes = {}};
  page.scene = two_motions();
  page.scene.motions.front().place.reset();
  page.scene.models = {{mesh, "knot"}};
  page.scene.steps.count = 2 * kStepsOfMotion;
  page.scene.pose = [](std::uint32_t, std::uint64_t) { return Pose(); };
  page.tables = {
      {.title = "Motions", .columns = {"motion"}, .rows = {{"7"}, {"0"}}, .of_motions = true}};
  std::ostringstream out;
  EXPECT_FALSE(write_page(out, page).is_live);
  const std::string text = out.str();
  for (const char* part : {"<section id=\"view\" class=\"motions\">", "id=\"part\"", "id=\"track\"",
                           "<a href=\"#motion=7\">7</a>", "<a href=\"#motion=0\">0</a>"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(text.find("id=\"step\""), std::string::npos);
  EXPECT_EQ(text.find("id=\"time-line\""), std::string::npos);
  const MotionJson scene = test::scene_of(text);
  EXPECT_TRUE(scene.at("live").is_null());
  EXPECT_EQ(scene.at("motions").size(), 2U);
}

}  // namespace

}  // namespace soms::report

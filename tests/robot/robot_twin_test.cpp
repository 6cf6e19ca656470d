// Answers about robots are those of the brute-force twin.
#include "soms/base/print.h"
#include "soms/robot/print.h"
#include "soms/robot/reference/robot_query.h"
#include "soms/robot/robot_query.h"

#include "tests/robot/robots.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace soms {
namespace {

/// Where links and cell have their corners: on few coordinates, so that many touch; or anywhere.
enum class Places { grid, anywhere };

double coordinate(Rng& rng, Places places) {
  return places == Places::grid ? static_cast<double>(rng.below(4)) : 4 * rng.unit();
}

/// A box, now and then of several parts, open, or with a triangle cut by a T-junction.
Mesh random_body(Rng& rng, Places places, double scale) {
  Mesh mesh;
  const std::uint64_t boxes = 1 + rng.below(2);
  for (std::uint64_t k = 0; k < boxes; ++k) {
    Vec3 lower;
    Vec3 upper;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = scale * (coordinate(rng, places) - 2);
      upper[axis] =
          lower[axis] + scale * (places == Places::grid ? static_cast<double>(1 + rng.below(3))
                                                        : 0.1 + 2 * rng.unit());
    }
    Mesh box = test::box_body(lower, upper);
    if (rng.below(4) == 0) {
      box.triangles.pop_back();
    } else if (rng.below(4) == 0) {
      // The first triangle in two, by a vertex on an edge that the neighbor does not have.
      const auto [a, b, c] = box.triangles[0];
      const auto middle = static_cast<std::uint32_t>(box.vertices.size());
      box.vertices.push_back((box.vertices[a] + box.vertices[b]) * 0.5);
      box.triangles[0] = {a, middle, c};
      box.triangles.push_back({middle, b, c});
    }
    mesh = test::joined(mesh, box);
  }
  if (rng.below(2) == 0) {
    mesh.parts.clear();  // else each box is a part
  }
  // Small ones in large ones, too.
  const double factor = std::array{1.0, 0.125, 3.0}[rng.below(3)];
  return test::mapped(mesh, [&](const Vec3& v) { return v * factor; });
}

Pose random_origin(Rng& rng, Places places, double scale) {
  const Vec3 shift{scale * (coordinate(rng, places) - 2), scale * (coordinate(rng, places) - 2),
                   scale * (coordinate(rng, places) - 2)};
  if (places == Places::grid) {
    Pose pose = test::cube_rotations()[rng.below(24)];
    pose.m[3] = shift.x;
    pose.m[7] = shift.y;
    pose.m[11] = shift.z;
    return pose;
  }
  return pose_from_rpy({rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)}, shift);
}

Robot random_boxes_robot(Rng& rng, Places places, double scale) {
  Robot robot{.name = "boxes"};
  const auto n = static_cast<std::uint32_t>(2 + rng.below(4));
  for (std::uint32_t k = 0; k < n; ++k) {
    Link link{.name = std::to_string(k)};
    for (std::uint64_t m = rng.below(3); m > 0; --m) {
      link.collisions.push_back(random_body(rng, places, scale));
    }
    robot.links.push_back(std::move(link));
    if (k > 0) {
      robot.joints.push_back({.name = std::to_string(k),
                              .type = static_cast<JointType>(rng.below(4)),
                              .parent = static_cast<std::uint32_t>(rng.below(k)),
                              .child = k,
                              .origin = random_origin(rng, places, scale),
                              .axis = {0, 0, 1}});
    }
  }
  if (rng.below(2) == 0) {
    robot.allowed = std::vector<LinkPair>{};
  }
  return robot;
}

double joint_value(Rng& rng, const Joint& joint, Places places, double scale) {
  if (joint.type == JointType::prismatic) {
    return scale * (coordinate(rng, places) - 2);
  }
  return places == Places::grid ? 0 : rng.uniform(-3, 3);
}

/// Counts of what was seen, so that no test passes by seeing one kind alone.
struct Seen {
  int free = 0;
  int contact = 0;
  int inside = 0;
  int undecided = 0;
};

void expect_robot_as_twin(Rng& rng, Places places, double scale, const Vec3& far, Seen& seen) {
  const Robot robot = random_boxes_robot(rng, places, scale);
  std::vector<Mesh> cell;
  if (rng.below(2) == 0) {
    cell.push_back(
        test::mapped(random_body(rng, places, scale), [&](const Vec3& v) { return v + far; }));
  }
  const RobotModel model(robot, cell, {.base = Pose::translation(far.x, far.y, far.z)});
  const Kinematics& kinematics = model.kinematics();
  std::vector<double> states;
  for (int row = 0; row < 6; ++row) {
    for (const std::uint32_t joint : kinematics.movable()) {
      states.push_back(joint_value(rng, robot.joints[joint], places, scale));
    }
  }
  const std::vector<RobotAnswer> answers = robot_contacts(model, states, {.distance = true});
  EXPECT_EQ(robot_contacts(model, states, {.distance = true}, {.threads = 3}), answers);
  const std::vector<RobotAnswer> first = robot_contacts(model, states, {.first_contact = true});
  const std::size_t width = kinematics.size();
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const RobotAnswer twin = reference::robot_contacts_by_brute_force(
        model, std::span(states).subspan(k * width, width), true);
    EXPECT_TRUE(reference::agrees(answers[k], twin)) << answers[k] << '\n' << twin;
    EXPECT_TRUE(reference::agrees(first[k], twin)) << first[k] << '\n' << twin;
    seen.free += twin.verdict == RobotVerdict::free ? 1 : 0;
    seen.contact += twin.verdict == RobotVerdict::contact ? 1 : 0;
    seen.undecided += twin.verdict == RobotVerdict::undecided ? 1 : 0;
    for (const RobotContact& contact : twin.contacts) {
      seen.inside += contact.surfaces_meet ? 0 : 1;
    }
  }
}

TEST(RobotTwin, AgreesWhereBodiesTouch) {
  Seen seen;
  test::for_each_case("robot grid", 150,
                      [&](Rng& rng) { expect_robot_as_twin(rng, Places::grid, 1, {}, seen); });
  EXPECT_GT(seen.free, 20);
  EXPECT_GT(seen.contact, 20);
}

TEST(RobotTwin, AgreesAnywhere) {
  Seen seen;
  test::for_each_case("robot anywhere", 150,
                      [&](Rng& rng) { expect_robot_as_twin(rng, Places::anywhere, 1, {}, seen); });
  EXPECT_GT(seen.free, 20);
  EXPECT_GT(seen.contact, 20);
  EXPECT_GT(seen.inside, 5);
  EXPECT_GT(seen.undecided, 0);  // T-junctions that open
}

TEST(RobotTwin, AgreesFarAway) {
  Seen seen;
  test::for_each_case("robot far", 40, [&](Rng& rng) {
    expect_robot_as_twin(rng, Places::anywhere, 1, {1e6, -3e6, 2e6}, seen);
  });
  EXPECT_GT(seen.contact, 5);
}

TEST(RobotTwin, AgreesWhereAllIsTiny) {
  Seen seen;
  test::for_each_case("robot tiny", 40, [&](Rng& rng) {
    expect_robot_as_twin(rng, Places::anywhere, 0x1p-60, {}, seen);
  });
  EXPECT_GT(seen.contact, 5);
}

TEST(RobotTwin, SaysWhatDiffers) {
  const RobotModel model(test::sliding_robot({test::cube(1), test::cube(1)}));
  const std::vector<double> state{0, 1};
  const RobotAnswer twin = reference::robot_contacts_by_brute_force(model, state, true);
  RobotAnswer answer = robot_contacts(model, state, {.distance = true}).at(0);
  EXPECT_TRUE(reference::agrees(answer, twin));
  RobotAnswer wrong = answer;
  wrong.contacts.clear();
  EXPECT_FALSE(reference::agrees(wrong, twin));
  wrong = answer;
  wrong.verdict = RobotVerdict::free;
  EXPECT_FALSE(reference::agrees(wrong, twin));
  wrong = answer;
  wrong.gap->distance = {0, 1};
  EXPECT_FALSE(reference::agrees(wrong, twin));
  wrong = answer;
  wrong.beyond_limits = {0};
  EXPECT_FALSE(reference::agrees(wrong, twin));
  wrong = answer;
  wrong.contacts[0].surfaces_meet = false;
  EXPECT_FALSE(reference::agrees(wrong, twin));
}

}  // namespace
}  // namespace soms

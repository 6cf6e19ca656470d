#include "soms/kinematics/robot.h"

#include "soms/base/print.h"
#include "soms/kinematics/print.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <sstream>
#include <string>

namespace soms {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// a - b - c, by two revolute joints.
Robot chain() {
  Robot robot{.name = "chain", .links = {{.name = "a"}, {.name = "b"}, {.name = "c"}}};
  robot.joints = {{.name = "ab", .type = JointType::revolute, .parent = 0, .child = 1},
                  {.name = "bc", .type = JointType::revolute, .parent = 1, .child = 2}};
  return robot;
}

/// What is wrong once `change` was made.
std::string fault_after(const std::function<void(Robot&)>& change) {
  Robot robot = chain();
  change(robot);
  const auto fault = find_fault(robot);
  if (!fault) {
    return "none";
  }
  EXPECT_FALSE(fault->remedy.empty());
  EXPECT_THROW(check(robot), Error);
  return fault->what;
}

TEST(Robot, OfATreeHasNoFault) {
  EXPECT_EQ(fault_after([](Robot&) {}), "none");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[1].parent = 0; }), "none");
}

TEST(Robot, HasLinksWithNames) {
  EXPECT_EQ(fault_after([](Robot& r) { r = Robot{}; }), "the robot has no links");
  EXPECT_EQ(fault_after([](Robot& r) { r.links[1].name = ""; }), "link \"\" has no name");
  EXPECT_EQ(fault_after([](Robot& r) { r.links[1].name = "a"; }),
            "link \"a\" has the name of another");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[1].name = "ab"; }),
            "joint \"ab\" has the name of another");
}

TEST(Robot, IsOneTree) {
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[1].child = 7; }),
            "joint \"bc\" connects a link that does not exist");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[1].child = 1; }),
            "joint \"bc\" connects a link to itself");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints.pop_back(); }),
            "link \"c\" has no parent, nor has \"a\"");
  EXPECT_EQ(fault_after([](Robot& r) {
              r.joints[1].parent = 0;
              r.joints[1].child = 1;
            }),
            "joint \"bc\" gives link \"b\" a second parent");
  EXPECT_EQ(
      fault_after([](Robot& r) { r.joints.push_back({.name = "ca", .parent = 2, .child = 0}); }),
      "the links have no root: joints connect them in a circle");
  EXPECT_EQ(fault_after([](Robot& r) {
              r.links.push_back({.name = "d"});
              r.joints = {{.name = "bc", .parent = 1, .child = 2},
                          {.name = "cd", .parent = 2, .child = 3},
                          {.name = "db", .parent = 3, .child = 1}};
            }),
            "link \"b\" is part of, or hangs on, a circle of joints");
}

TEST(Robot, HasJointsWithDirectionsAndLimits) {
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[0].axis = {}; }),
            "joint \"ab\" has the axis 0 0 0, which is no direction");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[0].axis.y = kNotANumber; }),
            "joint \"ab\" has an axis that is not finite");
  EXPECT_EQ(fault_after([](Robot& r) {
              r.joints[0].axis = {};
              r.joints[0].type = JointType::fixed;
            }),
            "none");
  EXPECT_EQ(fault_after([](Robot& r) {
              r.joints[0].lower = 1;
              r.joints[0].upper = 0.5;
            }),
            "joint \"ab\" has the lower limit 1 above the upper limit 0.5");
  EXPECT_EQ(fault_after([](Robot& r) { r.joints[0].upper = kNotANumber; }),
            "joint \"ab\" has a limit that is not a number");
  EXPECT_NE(fault_after([](Robot& r) { r.joints[0].origin.m[0] = 2; }), "none");
}

TEST(Robot, FollowsJointsToOneThatMoves) {
  const auto mimic = [](std::uint32_t i, std::uint32_t followed) {
    return [=](Robot& r) { r.joints[i].mimic = Mimic{.joint = followed}; };
  };
  EXPECT_EQ(fault_after(mimic(1, 0)), "none");
  EXPECT_EQ(fault_after(mimic(1, 1)),
            "joint \"bc\" mimics itself, or joints that mimic each other in a circle");
  EXPECT_EQ(fault_after([&](Robot& r) {
              mimic(1, 0)(r);
              mimic(0, 1)(r);
            }),
            "joint \"ab\" mimics itself, or joints that mimic each other in a circle");
  EXPECT_EQ(fault_after(mimic(1, 2)), "joint \"bc\" mimics a joint that does not exist");
  EXPECT_EQ(fault_after([&](Robot& r) {
              mimic(1, 0)(r);
              r.joints[0].type = JointType::fixed;
            }),
            "joint \"bc\" mimics \"ab\", which is fixed");
  EXPECT_EQ(fault_after([&](Robot& r) {
              mimic(1, 0)(r);
              r.joints[1].mimic->offset = kNotANumber;
            }),
            "joint \"bc\" mimics by a number that is not finite");
}

TEST(Robot, NamesPairsAndStatesThatExist) {
  EXPECT_NE(fault_after([](Robot& r) { r.allowed = {{1, 0}}; }), "none");
  EXPECT_NE(fault_after([](Robot& r) { r.allowed = {{1, 3}}; }), "none");
  EXPECT_EQ(fault_after([](Robot& r) { r.allowed = {{1, 2}}; }), "none");
  EXPECT_NE(fault_after([](Robot& r) {
              r.states = {{.name = "x", .values = {{2, 0.0}}}};
            }),
            "none");
}

TEST(Robot, IsPrinted) {
  std::ostringstream out;
  out << chain() << ' ' << LinkPair{1, 2} << ' ' << JointType::prismatic;
  EXPECT_EQ(out.str(), "Robot{\"chain\", 3 links, 2 joints} LinkPair{a: 1, b: 2} prismatic");
}

}  // namespace
}  // namespace soms

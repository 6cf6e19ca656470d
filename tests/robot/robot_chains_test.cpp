// 200 chains of joints whose first contact is known: tests/data/motion/robot_chains.csv.
#include "soms/robot/print.h"
#include "soms/robot/robot_path.h"

#include "tests/motion/motion_table.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace soms {
namespace {

/// Rounding of poses, in units of the size of a chain.
constexpr double kRounding = 1e-12;
constexpr double kSize = 8;  ///< no chain is longer

std::vector<std::string> split_at(const std::string& text, char mark) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, mark);) {
    parts.push_back(part);
  }
  return parts;
}

/// The rotation of a quaternion of whole numbers: entries are quotients, each rounded once, as
/// those of robot_chain.py.
Pose pose_of_whole(double w, double x, double y, double z, const Vec3& shift) {
  const double n = w * w + x * x + y * y + z * z;
  Pose pose;
  pose.m = {(w * w + x * x - y * y - z * z) / n,
            2 * (x * y - w * z) / n,
            2 * (x * z + w * y) / n,
            shift.x,
            2 * (x * y + w * z) / n,
            (w * w + y * y - x * x - z * z) / n,
            2 * (y * z - w * x) / n,
            shift.y,
            2 * (x * z - w * y) / n,
            2 * (y * z + w * x) / n,
            (w * w + z * z - x * x - y * y) / n,
            shift.z};
  return pose;
}

Joint chain_joint(const std::string& text, std::uint32_t number) {
  static const std::map<std::string, JointType> types{{"fixed", JointType::fixed},
                                                      {"revolute", JointType::revolute},
                                                      {"continuous", JointType::continuous},
                                                      {"prismatic", JointType::prismatic}};
  std::istringstream in(text);
  std::string kind;
  std::array<double, 4> q{};
  Vec3 shift;
  Vec3 axis;
  double leader = 0;
  Mimic mimic;
  in >> kind >> q[0] >> q[1] >> q[2] >> q[3] >> shift.x >> shift.y >> shift.z >> axis.x >> axis.y >>
      axis.z >> leader >> mimic.multiplier >> mimic.offset;
  EXPECT_TRUE(in) << text;
  Joint joint{.name = "joint " + std::to_string(number),
              .type = types.at(kind),
              .parent = number,
              .child = number + 1,
              .origin = pose_of_whole(q[0], q[1], q[2], q[3], shift),
              .axis = axis};
  if (leader >= 0) {
    mimic.joint = static_cast<std::uint32_t>(leader);
    joint.mimic = mimic;
  }
  return joint;
}

struct KnownChain {
  Robot robot;
  std::vector<Mesh> cell;
};

KnownChain known_chain(const test::MotionTable& table, std::size_t row) {
  KnownChain chain;
  const std::vector<std::string> joints = split_at(table.text(row, "joints"), '|');
  for (std::uint32_t k = 0; k <= joints.size(); ++k) {
    chain.robot.links.push_back({.name = "link " + std::to_string(k)});
    if (k < joints.size()) {
      chain.robot.joints.push_back(chain_joint(joints[k], k));
    }
  }
  for (const std::string& body : split_at(table.text(row, "bodies"), '|')) {
    std::istringstream in(body);
    int link = 0;
    in >> link;
    Mesh mesh;
    mesh.vertices.resize(4);
    for (Vec3& v : mesh.vertices) {
      in >> v.x >> v.y >> v.z;
    }
    EXPECT_TRUE(in) << body;
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {0, 2, 3}};
    (link < 0 ? chain.cell : chain.robot.links[static_cast<std::size_t>(link)].collisions)
        .push_back(std::move(mesh));
  }
  return chain;
}

std::vector<double> known_states(const test::MotionTable& table, std::size_t row) {
  std::vector<double> states;
  for (const char* name : {"from", "to"}) {
    std::istringstream in(table.text(row, name));
    for (double value = 0; in >> value;) {
      states.push_back(value);
    }
  }
  return states;
}

RobotPair known_pair(const test::MotionTable& table, std::size_t row) {
  const auto link = static_cast<std::uint32_t>(table.number(row, "link"));
  const std::vector<std::string> other = split_at(table.text(row, "other"), ' ');
  return {link, other.size() > 1, static_cast<std::uint32_t>(std::stoul(other.back()))};
}

void expect_known(const test::MotionTable& table, std::size_t row, const RobotSegment& segment) {
  const std::string& answer = table.text(row, "answer");
  if (answer == "free") {
    ASSERT_EQ(segment.verdict, ContactVerdict::free) << segment;
    return;
  }
  if (answer == "started") {
    ASSERT_EQ(segment.verdict, ContactVerdict::started) << segment;
    ASSERT_EQ(segment.pair, known_pair(table, row));
    return;
  }
  ASSERT_EQ(segment.verdict, ContactVerdict::contact) << segment;
  ASSERT_EQ(segment.pair, known_pair(table, row)) << segment;
  // No contact before `lower` is said of the law itself, so it has no tolerance. The contact is one
  // of a rounded pose.
  ASSERT_LE(segment.t.lower, table.number(row, "upper")) << segment;
  const double tolerance = kRounding * kSize / table.number(row, "speed");
  ASSERT_GE(segment.t.upper, table.number(row, "lower") - tolerance) << segment;
  ASSERT_LE(segment.t.upper - segment.t.lower, 1000 * tolerance) << segment;
}

TEST(RobotChains, FirstContactsOfTheLawAreFound) {
  const test::MotionTable table(test::data("motion/robot_chains.csv"));
  ASSERT_EQ(table.size(), 200U);
  std::map<std::string, int> seen;
  for (std::size_t row = 0; row < table.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row) + ", " + table.text(row, "kind"));
    ++seen[table.text(row, "kind")];
    const KnownChain chain = known_chain(table, row);
    const RobotModel model(chain.robot, chain.cell);
    const RobotPath path = robot_path(model, known_states(table, row));
    ASSERT_EQ(path.segments.size(), 1U);
    ASSERT_NO_FATAL_FAILURE(expect_known(table, row, path.segments.front()));
    for (const int threads : {2, 5}) {
      ASSERT_EQ(robot_path(model, known_states(table, row), {}, {.threads = threads}), path);
    }
  }
  EXPECT_GE(seen["free"] + seen["miss"], 60);
  EXPECT_GE(seen["self"], 20);
  EXPECT_GE(seen["graze"], 20);
}

// The same ways in one call: segments are shared by threads, and the way back is the same way.
TEST(RobotChains, WaysThereAndBackAreAnsweredByAnyThreads) {
  const test::MotionTable table(test::data("motion/robot_chains.csv"));
  for (std::size_t row = 0; row < table.size(); row += 9) {
    SCOPED_TRACE("row " + std::to_string(row));
    const KnownChain chain = known_chain(table, row);
    const RobotModel model(chain.robot, chain.cell);
    const std::vector<double> there = known_states(table, row);
    const std::size_t half = there.size() / 2;
    std::vector<double> states = there;
    for (int k = 0; k < 3; ++k) {
      states.insert(states.end(), there.begin(), there.begin() + static_cast<std::ptrdiff_t>(half));
      states.insert(states.end(), there.begin() + static_cast<std::ptrdiff_t>(half), there.end());
    }
    const RobotPath path = robot_path(model, states);
    ASSERT_EQ(path.segments.size(), 7U);
    const bool is_free = table.text(row, "answer") == "free";
    for (std::size_t k = 0; k < path.segments.size(); ++k) {
      ASSERT_EQ(path.segments[k].verdict == ContactVerdict::free, is_free) << k;
      if (k % 2 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_known(table, row, path.segments[k]));
      }
    }
    for (const int threads : {2, 4}) {
      ASSERT_EQ(robot_path(model, states, {}, {.threads = threads}), path);
    }
  }
}

}  // namespace
}  // namespace soms

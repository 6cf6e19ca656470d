// However files cut a link's or the cell's closed meshes into parts, a robot's answers stay.
#include "soms/base/print.h"
#include "soms/io/robot.h"
#include "soms/kinematics/primitive_meshes.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"

#include "tests/robot/robots.h"
#include "tests/support/cut_mesh.h"
#include "tests/support/support.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace soms {
namespace {

/// A closed body of a size of its own.
Mesh random_solid(Rng& rng) {
  const double size = rng.below(3) == 0 ? 0.1 : 0.3 + rng.unit();
  Mesh mesh;
  switch (rng.below(3)) {
    case 0:
      mesh = box_mesh({size, size * (0.5 + rng.unit()), size}).mesh;
      break;
    case 1:
      mesh = cylinder_mesh(0.4 * size, size, 0.05 * size).mesh;
      break;
    default:
      mesh = sphere_mesh(0.5 * size, 0.1 * size).mesh;
      break;
  }
  mesh.parts.clear();
  const Pose pose = pose_from_rpy({rng.uniform(-3, 3), rng.uniform(-3, 3), rng.uniform(-3, 3)},
                                  {rng.unit() - 0.5, rng.unit() - 0.5, rng.unit() - 0.5});
  return test::mapped(mesh, [&](const Vec3& v) { return pose.apply(v); });
}

/// The mesh in parts: at random, in runs, or each triangle one.
Mesh cut_at_random(Rng& rng, const Mesh& mesh) {
  const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  const std::uint64_t way = rng.below(3);
  const std::uint32_t parts =
      way == 2 && triangles < 100 ? triangles : 2 + static_cast<std::uint32_t>(rng.below(5));
  std::vector<std::uint32_t> label(triangles);
  for (std::uint32_t i = 0; i < triangles; ++i) {
    label[i] = way == 0 ? static_cast<std::uint32_t>(rng.below(parts))
                        : static_cast<std::uint32_t>(std::uint64_t{i} * parts / triangles);
  }
  return test::cut_by(mesh, label, parts);
}

/// Its parts, each a mesh of its own.
std::vector<Mesh> taken_apart(const Mesh& mesh) {
  std::vector<Mesh> meshes;
  for (const Part& part : mesh.parts) {
    Mesh alone = mesh;
    const auto first = mesh.triangles.begin() + part.first;
    alone.triangles.assign(first, first + part.count);
    alone.parts.clear();
    alone.source = part.name;
    if (part.count > 0) {
      meshes.push_back(std::move(alone));
    }
  }
  return meshes;
}

std::vector<Mesh> cut(Rng& rng, const std::vector<Mesh>& meshes) {
  std::vector<Mesh> all;
  for (const Mesh& mesh : meshes) {
    const Mesh parts = cut_at_random(rng, mesh);
    if (rng.below(3) == 0) {
      for (Mesh& alone : taken_apart(parts)) {
        all.push_back(std::move(alone));
      }
    } else {
      all.push_back(parts);
    }
  }
  return all;
}

Robot random_robot(Rng& rng) {
  Robot robot{.name = "solids"};
  const auto n = static_cast<std::uint32_t>(3 + rng.below(3));
  for (std::uint32_t k = 0; k < n; ++k) {
    Link link{.name = std::to_string(k)};
    for (std::uint64_t m = 1 + rng.below(2); m > 0; --m) {
      link.collisions.push_back(random_solid(rng));
    }
    robot.links.push_back(std::move(link));
    if (k > 0) {
      robot.joints.push_back(
          {.name = std::to_string(k),
           .type = rng.below(2) == 0 ? JointType::continuous : JointType::prismatic,
           .parent = static_cast<std::uint32_t>(rng.below(k)),
           .child = k,
           .origin = pose_from_rpy({rng.uniform(-3, 3), 0, 0}, {rng.unit(), rng.unit(), 0}),
           .axis = {0, 0, 1}});
    }
  }
  robot.allowed = std::vector<LinkPair>{};
  return robot;
}

struct SeenCuts {
  int free = 0;
  int contact = 0;
  int inside = 0;
};

/// The same answers but for the points and the cost, which are about other triangles.
void expect_same_answers(const RobotModel& whole, const RobotModel& parts,
                         const std::vector<double>& states, SeenCuts& seen) {
  const std::vector<RobotAnswer> before = robot_contacts(whole, states, {.distance = true});
  const std::vector<RobotAnswer> after = robot_contacts(parts, states, {.distance = true});
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(before[k].verdict, after[k].verdict) << "state " << k;
    EXPECT_EQ(before[k].contacts, after[k].contacts) << "state " << k;
    EXPECT_EQ(before[k].gap->distance, after[k].gap->distance) << "state " << k;
    EXPECT_EQ(before[k].gap->pair, after[k].gap->pair) << "state " << k;
    seen.free += before[k].verdict == RobotVerdict::free ? 1 : 0;
    seen.contact += before[k].verdict == RobotVerdict::contact ? 1 : 0;
    for (const RobotContact& contact : before[k].contacts) {
      seen.inside += contact.surfaces_meet ? 0 : 1;
    }
  }
}

TEST(CutRobots, AnswerAsWhole) {
  Rng rng(122);
  SeenCuts seen;
  for (int round = 0; round < 122; ++round) {
    SCOPED_TRACE("robot " + std::to_string(round));
    const Robot robot = random_robot(rng);
    Robot parts = robot;
    for (Link& link : parts.links) {
      link.collisions = cut(rng, link.collisions);
    }
    std::vector<Mesh> cell;
    for (std::uint64_t k = rng.below(3); k > 0; --k) {
      cell.push_back(random_solid(rng));
    }
    const std::vector<Mesh> cut_cell = cut(rng, cell);
    const RobotModel before(robot, cell);
    const RobotModel after(parts, cut_cell);
    ASSERT_EQ(before.bodies(), after.bodies());
    std::vector<double> states;
    for (std::size_t k = 0; k < 10 * before.kinematics().size(); ++k) {
      states.push_back(rng.uniform(-1.5, 1.5));
    }
    expect_same_answers(before, after, states, seen);
  }
  EXPECT_GT(seen.free, 50);
  EXPECT_GT(seen.contact, 200);
  EXPECT_GT(seen.inside, 20);
}

TEST(CutRobots, AnswerAsThePanda) {
  SOMS_NEEDS_OUTSIDE_DATA("a test of the Panda arm");
  const Robot robot = read_robot(*test::outside_data("robots/panda_description/urdf/panda.urdf"),
                                 {.packages = {{"moveit_resources_panda_description",
                                                *test::outside_data("robots/panda_description")}}});
  Rng rng(7);
  Robot parts = robot;
  for (Link& link : parts.links) {
    link.collisions = cut(rng, link.collisions);
  }
  const RobotModel before(robot);
  const RobotModel after(parts);
  std::vector<double> states;
  for (int k = 0; k < 200; ++k) {
    for (const std::uint32_t joint : before.kinematics().movable()) {
      states.push_back(rng.uniform(robot.joints[joint].lower, robot.joints[joint].upper));
    }
  }
  SeenCuts seen;
  expect_same_answers(before, after, states, seen);
  EXPECT_GT(seen.free, 0);
  EXPECT_GT(seen.contact, 0);
}

/// An open box with a lid of its own, and what is in it.
TEST(CutRobots, CallUndecidedWhatMayBeInsideOfAnOpenBody) {
  Mesh crate = test::cube(3);
  crate.triangles.resize(10);  // a face is missing
  crate.faces.clear();
  std::vector<std::uint32_t> face(10);
  for (std::uint32_t i = 0; i < face.size(); ++i) {
    face[i] = i / 2;
  }
  for (const Mesh& mesh : {crate, test::cut_by(crate, face, 5)}) {
    const RobotModel model(test::sliding_robot({test::cube(1), mesh}));
    const auto at = [&](double x) { return robot_contacts(model, std::vector{0, x}).at(0); };
    EXPECT_EQ(at(0).verdict, RobotVerdict::undecided);
    EXPECT_EQ(at(0).coverage, Coverage::complete);
    EXPECT_EQ(at(0).undecided, 1U);
    EXPECT_EQ(at(3).verdict, RobotVerdict::contact);
    EXPECT_EQ(at(4.5).verdict, RobotVerdict::free) << "the boxes are apart";
  }
}

TEST(CutRobots, FindWhatIsInAClosedPieceOfAnOpenBody) {
  Mesh machine = test::joined(test::cube(3), test::soup_body({{{9, 0, 0}, {9, 1, 0}, {9, 0, 1}}}));
  machine.parts.clear();
  const RobotModel model(test::sliding_robot({test::cube(1), machine}));
  const auto at = [&](double x) { return robot_contacts(model, std::vector{x, 0.0}).at(0); };
  EXPECT_EQ(at(0).verdict, RobotVerdict::contact);
  EXPECT_FALSE(at(0).contacts.at(0).surfaces_meet);
  EXPECT_EQ(at(6).verdict, RobotVerdict::undecided) << "in the box of the sheet and the cube";
  EXPECT_EQ(at(-6).verdict, RobotVerdict::free);
}

}  // namespace
}  // namespace soms

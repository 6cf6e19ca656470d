// An arm of six links in a cell, both generated. Lengths in meters.
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/grazing.h"
#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <algorithm>
#include <array>
#include <optional>

namespace soms::bench {

namespace {

constexpr std::size_t kJoints = 6;
using Angles = std::array<double, kJoints>;

struct Joint {
  Vec3 origin;  ///< in the frame of the link before, at angle 0
  Vec3 axis;
  double most = 0;  ///< either way
};

/// An articulated arm 3.4 m high when it is stretched upward: turn, shoulder, elbow, roll, bend,
/// flange.
constexpr std::array<Joint, kJoints> kArm{{{{0, 0, 0.5}, {0, 0, 1}, 3.1},
                                           {{0.2, 0, 0.4}, {0, 1, 0}, 1.9},
                                           {{0, 0, 1.0}, {0, 1, 0}, 2.4},
                                           {{0.1, 0, 0.2}, {0, 0, 1}, 3.1},
                                           {{0, 0, 0.8}, {0, 1, 0}, 2.1},
                                           {{0, 0, 0.2}, {0, 0, 1}, 3.1}}};

/// Poses of the links, in turn, at these angles of the joints.
std::array<Pose, kJoints> links_at(const Angles& angles) {
  std::array<Pose, kJoints> poses;
  Pose parent;
  for (std::size_t k = 0; k < kJoints; ++k) {
    const Joint& joint = kArm[k];
    parent = parent * Pose::from_axis_angle(joint.axis, angles[k], joint.origin);
    poses[k] = parent;
  }
  return poses;
}

/// The housing of a joint: a drum about the y axis and a cap over it.
FloatMesh housing(const Vec3& at, double radius, double half) {
  FloatMesh mesh = cylinder(at, {0, 1, 0}, radius, half, 64);
  append(mesh, ellipsoid(at, {radius, half + 0.05, radius}, 48, 24));
  return mesh;
}

FloatMesh gripper() {
  FloatMesh mesh = cylinder({0, 0, 0.03}, {0, 0, 1}, 0.06, 0.03, 48);
  append(mesh, box({0, 0, 0.1}, {0.05, 0.12, 0.04}));
  for (const double side : {-0.09, 0.09}) {
    append(mesh, box({0, side, 0.21}, {0.02, 0.012, 0.08}));
    append(mesh, cylinder({0.06, side, 0.1}, {0, 0, 1}, 0.02, 0.06, 24));
    append(mesh, ellipsoid({0, side, 0.3}, {0.02, 0.012, 0.02}, 24, 12, 0.5));
  }
  return mesh;
}

std::vector<FloatMesh> arm_links() {
  FloatMesh turn = cylinder({0, 0, 0.1}, {0, 0, 1}, 0.3, 0.1, 96);
  append(turn, housing({0.2, 0, 0.4}, 0.22, 0.12));
  append(turn, ellipsoid({0, 0, 0.3}, {0.28, 0.2, 0.25}, 48, 24, 0.6));
  FloatMesh upper = housing({0, 0.22, 0}, 0.18, 0.08);
  append(upper, ellipsoid({0, 0.22, 0.5}, {0.13, 0.09, 0.55}, 64, 32, 0.5));
  append(upper, cylinder({-0.12, 0.22, 0.5}, {0, 0, 1}, 0.04, 0.4, 32));
  FloatMesh elbow = housing({0, 0, 0}, 0.17, 0.14);
  append(elbow, ellipsoid({0.08, 0, 0.1}, {0.17, 0.13, 0.16}, 48, 24, 0.6));
  append(elbow, cylinder({-0.25, 0, 0.1}, {1, 0, 0}, 0.08, 0.12, 48));
  FloatMesh forearm = cylinder({0, 0, 0.05}, {0, 0, 1}, 0.13, 0.05, 64);
  append(forearm, ellipsoid({0, 0, 0.4}, {0.1, 0.09, 0.42}, 64, 32, 0.5));
  FloatMesh wrist = housing({0, 0, 0}, 0.08, 0.07);
  append(wrist, cylinder({0, 0, 0.1}, {0, 0, 1}, 0.07, 0.08, 48));
  return {turn, upper, elbow, forearm, wrist, gripper()};
}

/// A fence of wires around the cell, 6 m by 6 m, 2.2 m high, a wire every 0.1 m.
FloatMesh fence() {
  constexpr double kHalf = 3;
  FloatMesh mesh;
  for (int i = 0; i < 60; ++i) {
    const double s = -kHalf + 0.1 * i;
    for (const Vec3& foot :
         {Vec3{s, -kHalf, 1.1}, {s, kHalf, 1.1}, {-kHalf, s, 1.1}, {kHalf, s, 1.1}}) {
      append(mesh, cylinder(foot, {0, 0, 1}, 0.003, 1.1, 8));
    }
  }
  for (int i = 0; i <= 22; ++i) {
    const double z = 0.1 * i;
    for (const double side : {-kHalf, kHalf}) {
      append(mesh, cylinder({0, side, z}, {1, 0, 0}, 0.003, kHalf, 8));
      append(mesh, cylinder({side, 0, z}, {0, 1, 0}, 0.003, kHalf, 8));
    }
  }
  return mesh;
}

/// A conveyor: rollers between two rails, boxes on it.
FloatMesh conveyor() {
  FloatMesh mesh;
  for (int i = 0; i < 50; ++i) {
    append(mesh, cylinder({-2.5 + 0.1 * i, -1.7, 0.7}, {0, 1, 0}, 0.04, 0.4, 48));
  }
  for (const double y : {-2.15, -1.25}) {
    append(mesh, box({0, y, 0.7}, {2.6, 0.03, 0.08}));
  }
  for (int i = 0; i < 5; ++i) {
    append(mesh, box({-2.0 + i, -1.7, 0.95}, {0.25, 0.2, 0.2}, 0.15 * i));
  }
  return mesh;
}

/// Shelves with parts on them.
FloatMesh shelves() {
  FloatMesh mesh;
  for (int level = 0; level < 4; ++level) {
    const double z = 0.4 + 0.5 * level;
    append(mesh, box({-1.9, 0.6, z}, {0.25, 1.5, 0.015}));
    for (int i = 0; i < 14; ++i) {
      const double y = -0.75 + 0.2 * i;
      const double size = 0.05 + 0.01 * ((level + 3 * i) % 4);
      const double power = 0.5 + 0.25 * ((level + i) % 3);
      append(mesh, ellipsoid({-1.9, y, z + 0.015 + size}, {0.12, 0.07, size}, 32, 20, power));
    }
  }
  for (const double x : {-2.15, -1.65}) {
    for (const double y : {-0.9, 2.1}) {
      append(mesh, box({x, y, 1.1}, {0.02, 0.02, 1.1}));
    }
  }
  return mesh;
}

/// A car's body on a stand, to be worked at: hood, cabin, wheels, and pipes below.
FloatMesh work_piece() {
  FloatMesh mesh = ellipsoid({1.5, 0.4, 0.95}, {0.75, 1.9, 0.4}, 240, 140, 0.5);
  append(mesh, ellipsoid({1.5, 0.6, 1.4}, {0.6, 1.0, 0.35}, 160, 90, 0.6));
  for (const double x : {0.75, 2.25}) {
    for (const double y : {-0.9, 1.7}) {
      append(mesh, cylinder({x, y, 0.6}, {1, 0, 0}, 0.32, 0.1, 128));
      append(mesh, ellipsoid({x, y, 0.6}, {0.14, 0.2, 0.2}, 48, 24));
    }
  }
  for (int i = 0; i < 12; ++i) {
    append(mesh, cylinder({1.0 + 0.09 * i, 0.4, 0.5}, {0, 1, 0}, 0.03, 1.6, 48));
  }
  append(mesh, box({1.5, 0.4, 0.2}, {0.5, 1.5, 0.2}));
  return mesh;
}

/// A machine with a knotted hose on it.
FloatMesh machine() {
  FloatMesh mesh = box({0.3, 2.3, 0.6}, {0.8, 0.4, 0.6});
  FloatMesh hose = torus_knot(700, 70);
  for (auto& v : hose.vertices) {
    v = narrow(0.45 * wide(v) + Vec3{0.3, 2.2, 1.6});
  }
  append(mesh, hose);
  for (int i = 0; i < 40; ++i) {
    append(mesh, box({-0.3 + 0.03 * i, 1.88, 0.8}, {0.01, 0.02, 0.25}));
  }
  return mesh;
}

FloatMesh cell() {
  FloatMesh mesh = box({0, 0, -0.05}, {3.1, 3.1, 0.05});
  append(mesh, cylinder({0, 0, 0.24}, {0, 0, 1}, 0.35, 0.24, 96));
  for (const FloatMesh& part : {fence(), conveyor(), shelves(), work_piece(), machine()}) {
    append(mesh, part);
  }
  return mesh;
}

/// Says whether a link touches the cell.
class Arm {
 public:
  explicit Arm(const Scene& scene) : cell_(widened(scene.fixed)) {
    for (const FloatMesh& link : scene.links) {
      links_.emplace_back(widened(link));
    }
  }

  bool touches(const Angles& angles) {
    const std::array<Pose, kJoints> poses = links_at(angles);
    for (std::size_t k = 0; k < kJoints; ++k) {
      links_[k].pose = poses[k];
      if (overlap(links_[k], cell_, {.mode = OverlapMode::any}).any) {
        return true;
      }
    }
    return false;
  }

 private:
  std::vector<Body> links_;
  Body cell_;
};

Angles random_angles(Rng& rng) {
  Angles angles{};
  for (std::size_t k = 0; k < kJoints; ++k) {
    angles[k] = rng.uniform(-kArm[k].most, kArm[k].most);
  }
  return angles;
}

Angles turned(Angles angles, const Angles& rates, double way) {
  for (std::size_t k = 0; k < kJoints; ++k) {
    angles[k] += way * rates[k];
  }
  return angles;
}

void add(PoseSet& set, const Angles& angles) {
  const std::array<Pose, kJoints> poses = links_at(angles);
  set.poses.insert(set.poses.end(), poses.begin(), poses.end());
}

}  // namespace

Scene arm_scene(std::uint64_t seed) {
  Scene scene{
      "unlike-arm-cell", {}, cell(), {{"random", {}, kAnyAndAll}, {"grazing", {}, kAnyAndAll}}};
  scene.links = arm_links();
  Rng rng = rng_of(75, seed);
  for (std::size_t i = 0; i < kPoses; ++i) {
    add(scene.sets[0], random_angles(rng));
  }
  Arm arm(scene);
  Rng turns = rng_of(76, seed);
  while (scene.sets[1].poses.size() < kPoses * kJoints) {
    const Angles start = random_angles(turns);
    Angles rates{};
    for (double& rate : rates) {
      rate = turns.uniform(-1, 1);
    }
    const double into = turns.uniform(0.0005, 0.025);
    const auto touches = [&](double way) { return arm.touches(turned(start, rates, way)); };
    if (const auto way = free_way(touches, {.step = 0.02, .reach = 3})) {
      add(scene.sets[1], turned(start, rates, *way + into));
    }
  }
  return scene;
}

}  // namespace soms::bench

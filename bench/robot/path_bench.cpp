// A path of a robot beside its states alone: a robot of six links in a cell of 300,000 triangles,
// 1,000 states. `path_bench [STEP]` prints both times and their ratio, for a cell of 100 bodies and
// for one of one body; STEP is how far each joint
// goes from state to state at most, in radians (0.02).
#include "soms/base/random.h"
#include "soms/generate/shapes.h"
#include "soms/robot/robot_path.h"

#include "bench/measure.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace soms::bench {
namespace {

constexpr int kStates = 1000;
constexpr std::uint64_t kCellTriangles = 300'000;
constexpr std::uint64_t kCellBodies = 100;
constexpr std::uint64_t kLinkTriangles = 2000;

Mesh stretched(Mesh mesh, const Vec3& factors, const Vec3& shift) {
  for (Vec3& v : mesh.vertices) {
    v = Vec3{v.x * factors.x, v.y * factors.y, v.z * factors.z} + shift;
  }
  return mesh;
}

/// Six ellipsoids of 0.4 m, each turned by the one before, about z and y in turn.
Robot six_links() {
  Robot robot{.name = "six", .links = {{.name = "base"}}};
  const Mesh link = stretched(generate_sphere(kLinkTriangles), {0.05, 0.05, 0.17}, {0, 0, 0.2});
  for (std::uint32_t k = 0; k < 6; ++k) {
    robot.links.push_back({.name = std::to_string(k), .collisions = {link}});
    robot.joints.push_back({.name = std::to_string(k),
                            .type = JointType::revolute,
                            .parent = k,
                            .child = k + 1,
                            .origin = Pose::translation(0, 0, k == 0 ? 0 : 0.4),
                            .axis = k % 2 == 0 ? Vec3{0, 0, 1} : Vec3{0, 1, 0},
                            .lower = -2.5,
                            .upper = 2.5});
  }
  return robot;
}

/// Knots around the robot, most within its reach.
std::vector<Mesh> knots(Rng& rng) {
  std::vector<Mesh> meshes;
  const Mesh knot = generate_knot(kCellTriangles / kCellBodies);
  while (meshes.size() < kCellBodies) {
    const Vec3 place{rng.uniform(-2, 2), rng.uniform(-2, 2), rng.uniform(-2, 2)};
    if (std::hypot(place.x, place.y, place.z) > 0.6) {
      meshes.push_back(stretched(knot, {0.07, 0.07, 0.07}, place));
    }
  }
  return meshes;
}

/// A walk by steps whose states are free.
std::vector<double> free_states(const RobotModel& model, double step, Rng& rng) {
  const std::size_t width = model.kinematics().size();
  std::vector<double> states;
  std::vector<double> state(width, 0.3);
  std::vector<double> drift(width);
  while (states.size() < kStates * width) {
    std::vector<double> next = state;
    for (std::size_t k = 0; k < width; ++k) {
      next[k] += drift[k];
    }
    if (robot_contacts(model, next).front().verdict == RobotVerdict::free &&
        model.kinematics().beyond_limits(next).empty() && rng.below(50) != 0) {
      states.insert(states.end(), next.begin(), next.end());
      state = next;
    } else {
      for (double& d : drift) {
        d = rng.uniform(-step, step);
      }
    }
  }
  return states;
}

void measure(const char* cell, const std::vector<Mesh>& meshes, double step) {
  Rng rng(2);
  const RobotModel model(six_links(), meshes);
  const std::vector<double> states = free_states(model, step, rng);
  std::vector<double> alone;
  std::vector<double> whole;
  std::size_t free = 0;
  for (int round = 0; round < 7; ++round) {
    const double begin = processor_seconds();
    static_cast<void>(robot_contacts(model, states));
    const double middle = processor_seconds();
    const RobotPath path = robot_path(model, states);
    whole.push_back(processor_seconds() - middle);
    alone.push_back(middle - begin);
    free = 0;
    for (const RobotSegment& segment : path.segments) {
      free += segment.verdict == ContactVerdict::free ? 1 : 0;
    }
  }
  std::printf("%s, %d states, steps up to %g: %zu of %d segments free\n", cell, kStates, step, free,
              kStates - 1);
  std::printf("states alone %.2f us each; path %.2f us each; ratio %.2f\n",
              1e6 * median(alone) / kStates, 1e6 * median(whole) / kStates,
              median(whole) / median(alone));
}

int run(double step) {
  Rng rng(1);
  const std::vector<Mesh> meshes = knots(rng);
  measure("cell of 100 bodies", meshes, step);
  Mesh one = meshes.front();
  for (std::size_t k = 1; k < meshes.size(); ++k) {
    append(one, meshes[k]);
  }
  one.parts.clear();
  measure("cell of one body", {one}, step);
  return 0;
}

}  // namespace
}  // namespace soms::bench

int main(int argc, char** argv) {
  return soms::bench::run(argc > 1 ? std::atof(argv[1]) : 0.02);
}

#include "bench/motion/motion_cases.h"

#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/query/distance.h"
#include "soms/query/overlap.h"

#include "bench/peers/scenarios/scene.h"
#include "bench/peers/scenarios/solids.h"

#include <cmath>
#include <utility>

namespace soms::bench {

namespace {

bool starts_in_contact(const Shape& mover, const Pose& start, const Body& fixed) {
  return overlap(Body(mover, start), fixed, {.mode = OverlapMode::any}).any;
}

/// `pose` after a turn about its own origin and a shift, both in world.
Pose turned_and_shifted(const Pose& pose, const Vec3& axis, double angle, const Vec3& by) {
  Pose rotation = pose;
  rotation.m[3] = rotation.m[7] = rotation.m[11] = 0;
  return Pose::from_axis_angle(axis, angle, pose.shift() + by) * rotation;
}

/// A start 0.8 to 1.6 away, that goes nearer.
RigidMotion approach(Rng& rng) {
  const Vec3 away = random_direction(rng);
  const Pose start = random_rotation(rng, away * rng.uniform(1.6, 2.4));
  const Vec3 by = (random_direction(rng) * 0.5 - away) * 0.8;
  return RigidMotion::between(start, turned_and_shifted(start, random_direction(rng), 0.5, by));
}

/// From a random start without a contact to the given gap, and along the other body from there.
RigidMotion slide(Rng& rng, const Shape& mover, const Body& fixed, double gap, double rise) {
  for (;;) {
    Pose start = random_rotation(rng, random_direction(rng) * 1.5);
    const Distance apart = distance(Body(mover, start), fixed);
    if (!(apart.distance.lower > 0)) {
      continue;
    }
    const Vec3 out = unit(apart.point_a - apart.point_b);
    const Vec3 in = out * (gap - apart.distance.upper);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      start.m[4 * axis + 3] += in[axis];
    }
    const Vec3 any = random_direction(rng);
    const Vec3 by = unit(any - out * dot(any, out)) * 0.3 + out * rise;
    return RigidMotion::between(start, turned_and_shifted(start, random_direction(rng), 0.17, by));
  }
}

/// How a mover of a city moves.
struct Course {
  const char* name;
  MoverKind mover;
  double above;   ///< the ground, at least
  double spread;  ///< up to this much more
  double ahead;   ///< meters
  double rise;    ///< likewise
  double angle;   ///< radians, to the left
  bool on_street;
};

constexpr Course kCourses[] = {
    {"car 1 m, 10 degrees", MoverKind::car, 0.05, 0, 1, 0, 0.1745, true},
    {"car 20 m, rises", MoverKind::car, 0.05, 0, 20, 0.3, 0.01, true},
    {"drone 5 m, 29 degrees", MoverKind::drone, 10, 20, 5, -1, 0.5, true},
    {"car 30 m, 57 degrees", MoverKind::car, 3, 0, 30, 0, 1, false},
};

RigidMotion drive(Rng& rng, const City& city, const Course& course) {
  double heading = rng.uniform(-3, 3);
  double x = rng.uniform(-1500, 1500);
  double y = rng.uniform(-1500, 1500);
  if (course.on_street) {
    const double line = city.street_lines[rng.below(city.street_lines.size())];
    const bool along_x = rng.below(2) == 0;
    heading = along_x ? 0 : kPi / 2;
    (along_x ? y : x) = along_x ? line - 2 : line + 2;
  }
  const Vec3 from{x, y, city.ground(x, y) + course.above + rng.uniform(0, course.spread)};
  const Vec3 by{course.ahead * std::cos(heading), course.ahead * std::sin(heading), course.rise};
  return RigidMotion::between(Pose::about_z(heading, from),
                              Pose::about_z(heading + course.angle, from + by));
}

/// Makes motions until there are enough that do not start in contact.
template <class Make>
void fill_motions(MotionSet& set, std::size_t count, const Make& make) {
  while (set.motions.size() < count) {
    RigidMotion motion = make();
    if (!starts_in_contact(set.mover, motion.start(), set.fixed)) {
      set.motions.push_back(std::move(motion));
    }
  }
}

}  // namespace

std::vector<MotionSet> knot_motions(std::uint64_t triangles, std::size_t count) {
  const FloatMesh mesh = float_mesh(generate_knot(triangles), {});
  const Shape knot(widened(mesh));
  const std::string name = "knot " + std::to_string(triangles) + ", ";
  Rng rng(7);
  const Body fixed(knot, random_rotation(rng, {}));
  std::vector<MotionSet> sets;
  const auto add = [&](const char* how, const auto& make) {
    sets.push_back({name + how, mesh, mesh, knot, fixed, {}});
    fill_motions(sets.back(), count, make);
  };
  add("approach", [&] { return approach(rng); });
  add("slide at 0.001", [&] { return slide(rng, knot, fixed, 0.001, 0.01); });
  add("slide at 0.02", [&] { return slide(rng, knot, fixed, 0.02, 0); });
  return sets;
}

std::vector<MotionSet> city_motions(std::uint64_t triangles, std::size_t count) {
  const City city = generate_city({.triangles = triangles});
  const FloatMesh mesh = float_mesh(city.mesh, {});
  const Body fixed{Shape(widened(mesh))};
  Rng rng(3);
  std::vector<MotionSet> sets;
  for (const Course& course : kCourses) {
    const FloatMesh mover = float_mesh(generate_mover(course.mover), {});
    sets.push_back({"city " + std::to_string(triangles) + ", " + course.name,
                    mover,
                    mesh,
                    Shape(widened(mover)),
                    fixed,
                    {}});
    fill_motions(sets.back(), count, [&] { return drive(rng, city, course); });
  }
  return sets;
}

}  // namespace soms::bench

#include "soms/motion/rigid_motion.h"

#include "soms/motion/print_motion.h"

#include "python/src/answer.h"
#include "python/src/poses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace soms::python {

namespace {

constexpr const char* kRigidMotionDoc =
    R"(RigidMotion()

A motion of a body from one pose to another: where it is at each part t of the way, from 0 to 1. A
value that does not change. first_contact and free take one, or a list of them.

RigidMotion() rests at the identity; along, between and turn make the others. Between the two poses
the pivot goes straight at constant speed, and the body turns about it the shorter way.)";

constexpr const char* kAlongDoc =
    R"(along(start, by) -> RigidMotion

A straight shift of the body at start by a vector (3,) in world. The rotation stays that of start,
bit by bit, and first contacts are exact. Raises Error as Pose does, and of kind not_finite.)";

constexpr const char* kBetweenDoc =
    R"(between(start, end, pivot=None) -> RigidMotion

pivot: (3,), a point of the body; else its origin. Which way a half turn goes is not promised. Raises
Error as Pose does, and of kind not_finite.)";

constexpr const char* kTurnDoc =
    R"(turn(start, center, axis, angle) -> RigidMotion

A turn of the body at start about an axis through center, both (3,) in world, by radians below a half
turn: counter-clockwise where the axis points at the viewer. Raises Error of kind usage for an axis of
length 0 and a larger angle, and as between.)";

constexpr const char* kPoseAtDoc =
    R"(pose_at(t)

The Pose at a part t of the way, from 0 to 1; for t of shape (n,) poses (n, 4, 4). At 0 and 1 they are
the two poses, bit by bit; elsewhere the same bits on every machine. Raises Error of kind usage for
others.)";

Vec3 vector_of(const py::object& given, const char* what) {
  return point_of(doubles_of(given, what), what);
}

/// \errors ErrorKind::usage for a time that is no part of a way.
Pose pose_of_part(const RigidMotion& motion, double t) {
  if (!(t >= 0 && t <= 1)) {
    throw usage("t: " + std::to_string(t) + " is no part of a way", "give numbers from 0 to 1");
  }
  return motion.pose_at(t);
}

py::object pose_at(const RigidMotion& motion, const py::object& given) {
  const Doubles times = doubles_of(given, "t");
  if (times.ndim() == 0) {
    return py::cast(pose_of_part(motion, *times.data()));
  }
  if (times.ndim() != 1) {
    refuse_shape(times, "t", "a number or shape (n,)");
  }
  py::array_t<double> poses({times.shape(0), py::ssize_t{4}, py::ssize_t{4}});
  double* to = poses.mutable_data();
  for (const double t : std::span(times.data(), static_cast<std::size_t>(times.size()))) {
    to = std::ranges::copy(pose_of_part(motion, t).m, to).out;
    to = std::ranges::copy(std::array<double, 4>{0, 0, 0, 1}, to).out;
  }
  return poses;
}

/// What makes an equal one: its poses, then the shift of a straight one or the pivot.
py::tuple parts_of_motion(const RigidMotion& motion) {
  return py::make_tuple(motion.straight(), motion.start(), motion.end(),
                        array_of(motion.straight() ? motion.by() : motion.pivot()));
}

RigidMotion motion_of_parts(const py::tuple& parts) {
  const Pose start = parts[1].cast<Pose>();
  const Vec3 vector = vector_of(parts[3], "vector");
  return parts[0].cast<bool>() ? RigidMotion::along(start, vector)
                               : RigidMotion::between(start, parts[2].cast<Pose>(), vector);
}

void bind_motion_makers(py::class_<RigidMotion>& motion) {
  motion.def_static(
      "along",
      [](const py::object& start, const py::object& by) {
        return RigidMotion::along(pose_of(start), vector_of(by, "by"));
      },
      py::arg("start"), py::arg("by"), kAlongDoc);
  motion.def_static(
      "between",
      [](const py::object& start, const py::object& end, const py::object& pivot) {
        return RigidMotion::between(pose_of(start), pose_of(end),
                                    pivot.is_none() ? Vec3{} : vector_of(pivot, "pivot"));
      },
      py::arg("start"), py::arg("end"), py::arg("pivot") = py::none(), kBetweenDoc);
  motion.def_static(
      "turn",
      [](const py::object& start, const py::object& center, const py::object& axis, double angle) {
        return RigidMotion::turn(pose_of(start), vector_of(center, "center"),
                                 vector_of(axis, "axis"), angle);
      },
      py::arg("start"), py::arg("center"), py::arg("axis"), py::arg("angle"), kTurnDoc);
}

}  // namespace

void bind_rigid_motions(py::module_& module) {
  py::class_<RigidMotion> motion(module, "RigidMotion", kRigidMotionDoc);
  motion.def(py::init<>());
  bind_motion_makers(motion);
  motion.def("pose_at", &pose_at, py::arg("t"), kPoseAtDoc);
  motion.def_property_readonly("start", &RigidMotion::start, "The Pose at t = 0.");
  motion.def_property_readonly("end", &RigidMotion::end, "The Pose at t = 1.");
  motion.def_property_readonly(
      "pivot", [](const RigidMotion& m) { return array_of(m.pivot()); },
      "The point of the body (3,) that goes straight, a copy.");
  motion.def_property_readonly("straight", &RigidMotion::straight, "Whether along made it.");
  motion.def(
      "__eq__", [](const RigidMotion& a, const RigidMotion& b) { return a == b; },
      py::is_operator());
  motion.attr("__hash__") = py::none();
  motion.def("__repr__", &printed<RigidMotion>);
  motion.def(py::pickle(&parts_of_motion, &motion_of_parts));
}

}  // namespace soms::python

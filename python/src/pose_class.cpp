#include "soms/base/pose.h"
#include "soms/base/print.h"

#include "python/src/answer.h"
#include "python/src/poses.h"

#include <algorithm>
#include <array>

namespace soms::python {

namespace {

constexpr const char* kPoseDoc = R"(Pose(given=None)

A rigid motion: a rotation, then a shift. A value that does not change.

given: None for the identity, a Pose, a matrix (3, 4) or (4, 4) that moves column vectors, seven
numbers x y z qw qx qy qz, or a shift x y z.

Raises Error of kind not_rigid, not_finite or usage. Floats of 4 bytes are often too coarse: see
from_matrix.)";

py::array matrix_of(const Pose& pose) {
  py::array_t<double> matrix({3, 4});
  std::copy(pose.m.begin(), pose.m.end(), matrix.mutable_data());
  return matrix;
}

Pose from_matrix(const py::object& given, const py::object& rotation) {
  const Doubles numbers = doubles_of(given, "matrix");
  const bool has_last_row = numbers.ndim() == 2 && numbers.shape(0) == 4;
  if (numbers.ndim() != 2 || numbers.shape(1) != 4 || (numbers.shape(0) != 3 && !has_last_row)) {
    refuse_shape(numbers, "matrix", "shape (3, 4) or (4, 4)");
  }
  std::array<double, 16> matrix{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  std::copy_n(numbers.data(), numbers.size(), matrix.begin());
  return Pose::from_row_major(matrix, enum_of<Rotation>(rotation, "rotation"));
}

/// One point or n of them, moved.
py::array apply(const Pose& pose, const py::object& given) {
  const Doubles numbers = doubles_of(given, "points");
  if (is_point(numbers)) {
    return array_of(pose.apply(point_of(numbers, "points")));
  }
  const Rows<Vec3> points = points_of(numbers, "points");
  py::array_t<double> moved({numbers.shape(0), py::ssize_t{3}});
  double* to = moved.mutable_data();
  for (const Vec3& point : points.get()) {
    const Vec3 there = pose.apply(point);
    to = std::copy_n(std::array{there.x, there.y, there.z}.begin(), 3, to);
  }
  return moved;
}

/// \errors As `check` of a pose.
Pose checked(const Pose& pose) {
  check(pose);
  return pose;
}

Vec3 shift_of(const py::object& given) {
  return given.is_none() ? Vec3{} : point_of(doubles_of(given, "shift"), "shift");
}

void bind_makers(py::class_<Pose>& pose) {
  pose.def_static("identity", &Pose::identity, "identity() -> Pose");
  pose.def_static(
      "translation",
      [](double x, double y, double z) { return checked(Pose::translation(x, y, z)); },
      py::arg("x"), py::arg("y"), py::arg("z"), "translation(x, y, z) -> Pose\n\nA shift alone.");
  pose.def_static(
      "from_quaternion",
      [](double w, double x, double y, double z, const py::object& shift) {
        return checked(Pose::from_quaternion(w, x, y, z, shift_of(shift)));
      },
      py::arg("w"), py::arg("x"), py::arg("y"), py::arg("z"), py::arg("shift") = py::none(),
      "from_quaternion(w, x, y, z, shift=None) -> Pose\n\nThe rotation by a unit quaternion, w "
      "first, then the shift. Raises Error of kind not_rigid\nif its length is off 1.");
  pose.def_static(
      "about_z",
      [](double angle, const py::object& shift) {
        return checked(Pose::about_z(angle, shift_of(shift)));
      },
      py::arg("angle"), py::arg("shift") = py::none(),
      "about_z(angle, shift=None) -> Pose\n\nThe rotation by radians counter-clockwise about +z, "
      "then the shift.");
  pose.def_static(
      "from_axis_angle",
      [](const py::object& axis, double angle, const py::object& shift) {
        return checked(Pose::from_axis_angle(point_of(doubles_of(axis, "axis"), "axis"), angle,
                                             shift_of(shift)));
      },
      py::arg("axis"), py::arg("angle"), py::arg("shift") = py::none(),
      "from_axis_angle(axis, angle, shift=None) -> Pose\n\nThe rotation by radians about an axis "
      "of "
      "any length but 0, then the shift.");
  pose.def_static(
      "from_matrix", &from_matrix, py::arg("matrix"), py::arg("rotation") = "as_given",
      "from_matrix(matrix, rotation='as_given') -> Pose\n\nmatrix: shape (3, 4) or (4, 4), moves "
      "column vectors.\nrotation: 'as_given' takes its entries as they are, off a rotation by at "
      "most 1e-6; 'nearest' the\nnearest rotation of entries that are off by at most 1e-3, as "
      "those "
      "of floats are.\nRaises Error of kind not_rigid, not_finite or usage.");
}

}  // namespace

void bind_poses(py::module_& module) {
  py::class_<Pose> pose(module, "Pose", kPoseDoc);
  pose.def(
      py::init([](const py::object& given) { return given.is_none() ? Pose() : pose_of(given); }),
      py::arg("given") = py::none());
  bind_makers(pose);
  pose.def_property_readonly("matrix", &matrix_of, "The matrix (3, 4), a copy.");
  pose.def_property_readonly(
      "shift", [](const Pose& p) { return array_of(p.shift()); }, "The shift (3,), a copy.");
  pose.def("inverse", &Pose::inverse, "inverse() -> Pose\n\nThe motion back.");
  pose.def(
      "normalized", &Pose::normalized,
      "normalized() -> Pose\n\nThe nearest rotation with the same shift, for a product of very "
      "many poses.");
  pose.def("apply", &apply, py::arg("points"),
           "apply(points) -> numpy.ndarray\n\npoints: shape (3,) or (n, 3); moved, in the same "
           "shape.");
  const auto product = [](const Pose& a, const Pose& b) { return a * b; };
  const char* const doc = "a @ b moves by b first, then by a.";
  pose.def("__matmul__", product, py::is_operator(), doc);
  pose.def("__mul__", product, py::is_operator(), doc);
  pose.def(
      "__eq__", [](const Pose& a, const Pose& b) { return a == b; }, py::is_operator());
  pose.attr("__hash__") = py::none();
  pose.def("__repr__", &printed<Pose>);
  pose.def(py::pickle([](const Pose& p) { return py::make_tuple(matrix_of(p)); },
                      [](const py::tuple& state) {
                        Pose p;
                        std::copy_n(doubles_of(state[0], "matrix").data(), p.m.size(), p.m.begin());
                        return p;
                      }));
}

}  // namespace soms::python

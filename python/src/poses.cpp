#include "python/src/poses.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace soms::python {

namespace {

using Numbers = const double*;

static_assert(sizeof(Pose) == 12 * sizeof(double));

Pose pose_of_12(Numbers from) {
  Pose pose;
  std::copy_n(from, 12, pose.m.begin());
  return pose;
}

Pose pose_of_16(Numbers from) {
  for (int column = 0; column < 4; ++column) {
    const double wanted = column == 3 ? 1 : 0;
    if (from[12 + column] != wanted) {
      throw Error(ErrorKind::not_rigid, "the last row of the matrix is not 0, 0, 0, 1",
                  "give matrices that move column vectors; transpose those that move rows");
    }
  }
  return pose_of_12(from);
}

Pose pose_of_7(Numbers from) {
  return Pose::from_quaternion(from[3], from[4], from[5], from[6], {from[0], from[1], from[2]});
}

Pose pose_of_3(Numbers from) {
  return Pose::translation(from[0], from[1], from[2]);
}

/// How a pose is made of its numbers.
struct Form {
  std::vector<py::ssize_t> shape;
  Pose (*pose)(Numbers from);
  py::ssize_t numbers;
};

const std::vector<Form>& forms() {
  static const std::vector<Form> all{{{3, 4}, &pose_of_12, 12},
                                     {{4, 4}, &pose_of_16, 16},
                                     {{12}, &pose_of_12, 12},
                                     {{7}, &pose_of_7, 7},
                                     {{3}, &pose_of_3, 3}};
  return all;
}

/// The form of an array whose axes from `first` on are one pose, or null.
const Form* form_of(const Doubles& numbers, py::ssize_t first) {
  for (const Form& form : forms()) {
    if (numbers.ndim() >= first &&
        std::equal(form.shape.begin(), form.shape.end(), numbers.shape() + first,
                   numbers.shape() + numbers.ndim())) {
      return &form;
    }
  }
  return nullptr;
}

bool is_pose(py::handle given) {
  return py::isinstance<Pose>(given);
}

/// Rows of numpy's memory, written one after the other.
class PoseWriter {
 public:
  explicit PoseWriter(py::ssize_t count) : numbers_({count, py::ssize_t{12}}) {
    to_ = numbers_.mutable_data();
  }

  void put(const Pose& pose) { to_ = std::copy(pose.m.begin(), pose.m.end(), to_); }

  [[nodiscard]] Rows<Pose> rows() && { return Rows<Pose>(std::move(numbers_)); }

 private:
  Doubles numbers_;
  double* to_;
};

Rows<Pose> listed_poses(const py::sequence& given) {
  const auto count = static_cast<py::ssize_t>(given.size());
  PoseWriter poses(count);
  for (py::ssize_t i = 0; i < count; ++i) {  // what is listed may change the list
    poses.put(pose_of(given[py::int_(i)]));
  }
  return std::move(poses).rows();
}

}  // namespace

Pose pose_of(py::handle given) {
  if (is_pose(given)) {
    return given.cast<const Pose&>();
  }
  const Doubles numbers = doubles_of(given, "pose");
  const Form* const form = form_of(numbers, 0);
  if (form == nullptr) {
    refuse_shape(numbers, "pose", "a Pose, or shape (3, 4), (4, 4), (7,) or (3,)");
  }
  const Pose pose = form->pose(numbers.data());
  check(pose);
  return pose;
}

Rows<Pose> poses_of(py::handle given) {
  if ((py::isinstance<py::list>(given) || py::isinstance<py::tuple>(given)) && py::len(given) > 0 &&
      is_pose(given[py::int_(0)])) {
    return listed_poses(py::reinterpret_borrow<py::sequence>(given));
  }
  Doubles numbers = doubles_of(given, "poses");
  const Form* const form = form_of(numbers, 1);
  if (form == nullptr) {
    refuse_shape(numbers, "poses",
                 "a list of Pose, or shape (n, 3, 4), (n, 4, 4), (n, 12), (n, 7) or (n, 3)");
  }
  if (form->pose == &pose_of_12) {  // as a Pose lies in memory
    return Rows<Pose>(std::move(numbers)).owned();
  }
  PoseWriter poses(numbers.shape(0));
  Numbers from = numbers.data();
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i, from += form->numbers) {
    try {
      poses.put(form->pose(from));
    } catch (const Error& error) {
      throw Error(error.kind(), "pose " + std::to_string(i) + ": " + error.place(), error.remedy());
    }
  }
  return std::move(poses).rows();
}

}  // namespace soms::python

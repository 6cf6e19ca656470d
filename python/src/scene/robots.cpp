// Robots: read_robot, and the poses of links.
#include "python/src/scene/robots.h"

#include "soms/base/parallel.h"
#include "soms/base/random.h"
#include "soms/io/robot.h"
#include "soms/kinematics/print.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/paths.h"
#include "python/src/poses.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace soms::python {

namespace {

using RobotClass = py::class_<HeldRobot, SharedRobot>;

/// States whose poses are computed between two looks at Ctrl-C.
constexpr std::size_t kStatesOfAPoseChunk = 256;

constexpr const char* kReadRobotDoc =
    R"(read_robot(urdf, srdf=None, *, name='', packages={}, package_path=(), tessellation_error=0.0005, strict=False, max_memory=0, progress=None)

Reads a robot of a URDF file with the meshes of its collision elements, in meters and radians.

urdf: a path, or bytes, which name stands for in messages. srdf: a path of the pairs of links that may
touch, and of named states. packages: a dict of package names and folders, for package:// addresses;
package_path: folders in which packages lie. tessellation_error: how far the meshes of cylinders and
spheres may exceed them, in meters. strict: what would be noted in Robot.notes is an error.
max_memory: most bytes for each file, 0 for the usual limit.

Returns Robot. Raises Error of kind cannot_open (a mesh or package that is missing), bad_file (names
file and line), not_finite, out_of_range, empty_mesh, unsupported, out_of_memory, usage.)";

SharedRobot read_any_robot(const py::object& urdf, const py::object& srdf, const std::string& name,
                           const std::map<std::string, py::object>& packages,
                           const std::vector<py::object>& package_path, double tessellation_error,
                           bool strict, std::uint64_t max_memory, const py::object& progress) {
  RobotReadOptions options{
      .tessellation_error = tessellation_error, .max_memory = max_memory, .strict = strict};
  if (!srdf.is_none()) {
    options.srdf = path_of(srdf);
  }
  for (const auto& [package, folder] : packages) {
    options.packages.emplace_back(package, path_of(folder));
  }
  for (const py::object& folder : package_path) {
    options.package_path.push_back(path_of(folder));
  }
  if (PyObject_CheckBuffer(urdf.ptr()) != 0) {
    const std::vector<std::byte> bytes = bytes_of(urdf);
    return run(Work::many, 1, progress, [&](const Limits& limits) {
      return std::make_shared<HeldRobot>(
          read_robot(bytes, name.empty() ? "bytes" : name, options, limits));
    });
  }
  const std::filesystem::path path = path_of(urdf);
  return run(Work::many, 1, progress, [&](const Limits& limits) {
    return std::make_shared<HeldRobot>(read_robot(path, options, limits));
  });
}

py::object mimic_of(const Joint& joint) {
  return joint.mimic
             ? py::make_tuple(joint.mimic->joint, joint.mimic->multiplier, joint.mimic->offset)
             : py::object(py::none());
}

void bind_links_and_joints(py::module_& module) {
  AnswerClass<Joint> joint(module, "Joint", "What connects a link of a Robot to its parent.");
  joint.field("name", &Joint::name, "The name.")
      .field("type", &Joint::type, "JointType.")
      .field("parent", &Joint::parent, "The number of the link that it hangs from.")
      .field("child", &Joint::child, "The number of the link that it moves.")
      .field("origin", &Joint::origin, "Pose of the joint at value 0, in the parent's frame.")
      .field("axis", &Joint::axis, "(3,), in the joint's frame.")
      .field("lower", &Joint::lower, "The least value, radians or meters; -inf where none is set.")
      .field("upper", &Joint::upper, "The greatest value.")
      .derived("mimic", &mimic_of,
               "(joint, multiplier, offset) of a joint that follows another, else None.");
  AnswerClass<Link> link(module, "Link", "A rigid body of a Robot.");
  link.field("name", &Link::name, "The name.")
      .derived(
          "collisions", [](const Link& l) { return l.collisions; },
          "A list of Mesh, in the frame of the link; empty: it touches nothing.");
  AnswerClass<NamedState> state(module, "NamedState", "Named joint values of an SRDF file.");
  state.field("name", &NamedState::name, "The name, such as 'ready'.")
      .field("group", &NamedState::group, "The group of joints, or an empty text.")
      .derived(
          "values", [](const NamedState& s) { return s.values; },
          "A list of (number of a joint, value).")
      .derived(
          "unknown", [](const NamedState& s) { return texts_of(s.unknown); },
          "A list of str: joints that it names and the robot does not have.");
}

/// The error of one state among many, by its number.
template <class Function>
void for_state(std::size_t row, bool is_one, const Function& function) {
  try {
    function();
  } catch (const Error& error) {
    if (is_one) {
      throw;
    }
    throw Error(error.kind(), "state " + std::to_string(row) + ": " + error.place(),
                error.remedy());
  }
}

/// What `each(state, to)` writes for every state: an array of a `tail` of numbers, with the number
/// of states before it unless one state was given.
template <class Each>
py::array each_state(const HeldRobot& held, const py::object& given, Extents tail, int threads,
                     const Each& each) {
  const States states = states_of(given, held.kinematics);
  std::size_t width = 1;
  for (const py::ssize_t extent : tail) {
    width *= static_cast<std::size_t>(extent);
  }
  if (!states.is_one) {
    tail.insert(tail.begin(), static_cast<py::ssize_t>(states.rows));
  }
  py::array_t<double> numbers(tail);
  double* const to = numbers.mutable_data();
  const std::size_t size = held.kinematics.size();
  run(Work::many, threads, py::none(), [&](const Limits& limits) {
    const auto chunk = [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row) {
        for_state(row, states.is_one,
                  [&] { each(states.numbers.get().subspan(row * size, size), to + row * width); });
      }
    };
    for_each_chunk(states.rows, kStatesOfAPoseChunk, limits, chunk);
    return true;
  });
  return numbers;
}

py::array poses_of_links(const HeldRobot& held, const py::object& given, const py::object& base,
                         int threads) {
  static_assert(sizeof(Pose) == 12 * sizeof(double));
  const Pose root = base.is_none() ? Pose() : pose_of(base);
  const auto links = static_cast<py::ssize_t>(held.robot.links.size());
  return each_state(held, given, {links, 3, 4}, threads,
                    [&](std::span<const double> state, double* to) {
                      const std::vector<Pose> poses = held.kinematics.link_poses(state, root);
                      std::memcpy(to, poses.data(), poses.size() * sizeof(Pose));
                    });
}

py::array values_of_joints(const HeldRobot& held, const py::object& given) {
  const auto joints = static_cast<py::ssize_t>(held.robot.joints.size());
  return each_state(held, given, {joints}, 1, [&](std::span<const double> state, double* to) {
    const std::vector<double> values = held.kinematics.joint_values(state);
    std::copy(values.begin(), values.end(), to);
  });
}

py::array random_states(const HeldRobot& held, std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  py::array_t<double> numbers(
      Extents{static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(held.kinematics.size())});
  double* to = numbers.mutable_data();
  for (std::size_t row = 0; row < count; ++row) {
    const std::vector<double> state = random_state(held.kinematics, rng);
    to = std::copy(state.begin(), state.end(), to);
  }
  return numbers;
}

void bind_robot_facts(RobotClass& robot) {
  robot.def_property_readonly(
      "name", [](const HeldRobot& h) { return Text{h.robot.name}; }, "The name.");
  robot.def_property_readonly(
      "links", [](const HeldRobot& h) { return h.robot.links; }, "A list of Link.");
  robot.def_property_readonly(
      "joints", [](const HeldRobot& h) { return h.robot.joints; }, "A list of Joint.");
  def_property(
      robot, "movable",
      [](const py::object& self) {
        return column_of(self.cast<const HeldRobot&>().kinematics.movable(), self);
      },
      "(k,) uint32: the joints whose values make a state: neither fixed nor mimic, in order.");
  robot.def_property_readonly(
      "root", [](const HeldRobot& h) { return h.kinematics.root(); }, "The link without a parent.");
  robot.def_property_readonly(
      "allowed",
      [](const HeldRobot& h) {
        return h.robot.allowed ? py::object(link_pairs_array(*h.robot.allowed)) : py::none();
      },
      "(m, 2) uint32: links that may touch, as the SRDF file says; None without one.");
  robot.def_property_readonly(
      "states", [](const HeldRobot& h) { return h.robot.states; }, "A list of NamedState.");
  robot.def_property_readonly(
      "tessellation_error", [](const HeldRobot& h) { return h.robot.tessellation_error; },
      "How far meshes of cylinders and spheres exceed them at most, in meters.");
  robot.def_property_readonly(
      "source", [](const HeldRobot& h) { return Text{h.robot.source}; }, "The path of the file.");
  robot.def_property_readonly(
      "notes", [](const HeldRobot& h) { return texts_of(h.robot.notes); },
      "What the file holds that was not read or applied.");
}

void bind_robot(py::module_& module) {
  RobotClass robot(module, "Robot", R"(Robot

A tree of links with collision meshes, connected by joints, as read_robot reads it. It does not change.

A state is one number for each movable joint, radians or meters; states are (k,) for one, (n, k) for
many.)");
  bind_robot_facts(robot);
  robot.def(
      "link_poses", &poses_of_links, py::arg("states"), py::kw_only(), py::arg("base") = py::none(),
      py::arg("threads") = 1,
      "link_poses(states, *, base=None, threads=1) -> numpy.ndarray\n\nThe poses of all L "
      "links: (L, 3, 4) for one state, (n, L, 3, 4) for n. base: of the root link.\nRaises "
      "Error of kind usage (shape), not_finite; names state and joint. About 0.2 us a joint.");
  robot.def("joint_values", &values_of_joints, py::arg("states"),
            "joint_values(states) -> numpy.ndarray\n\nThe value of each of the J joints, mimic "
            "ones too, of fixed ones 0: (J,), or (n, J).");
  robot.def("random_states", &random_states, py::arg("count"), py::kw_only(), py::arg("seed") = 1,
            "random_states(count, *, seed=1) -> numpy.ndarray\n\n(count, k): inside the limits, "
            "uniformly; within pi where there is none. The same on every machine, and\nthose of "
            "soms robot --random.");
  robot.def(
      "__eq__", [](const HeldRobot& a, const HeldRobot& b) { return a.robot == b.robot; },
      py::is_operator());
  robot.attr("__hash__") = py::none();
  robot.def("__repr__", [](const HeldRobot& h) { return printed(h.robot); });
  robot.def(py::pickle(
      [](const HeldRobot& h) { return packed(h.robot); },
      [](const py::tuple& state) { return std::make_shared<HeldRobot>(unpacked<Robot>(state)); }));
}

}  // namespace

States states_of(py::handle given, const Kinematics& kinematics) {
  Doubles numbers = doubles_of(given, "states");
  const auto width = static_cast<py::ssize_t>(kinematics.size());
  const py::ssize_t axes = numbers.ndim();
  if ((axes != 1 && axes != 2) || numbers.shape(axes - 1) != width) {
    const std::string k = std::to_string(width);
    const std::string wanted =
        "shape (" + k + ",) or (n, " + k + "): a number for each movable " + "joint";
    refuse_shape(numbers, "states", wanted.c_str());
  }
  const auto rows = axes == 1 ? std::size_t{1} : static_cast<std::size_t>(numbers.shape(0));
  return {Rows<double>(std::move(numbers)).owned(), rows, axes == 1};
}

std::uint32_t link_of(py::handle given, const Robot& robot, const char* what) {
  if (PyUnicode_Check(given.ptr()) == 0) {
    const auto number = given.cast<std::int64_t>();
    if (number < 0 || static_cast<std::uint64_t>(number) >= robot.links.size()) {
      throw Error(ErrorKind::out_of_range,
                  std::string(what) + ": link " + std::to_string(number) + " of " +
                      std::to_string(robot.links.size()),
                  "count links from 0, or give a name");
    }
    return static_cast<std::uint32_t>(number);
  }
  const std::string name = given.cast<Text>().bytes;
  for (std::size_t k = 0; k < robot.links.size(); ++k) {
    if (robot.links[k].name == name) {
      return static_cast<std::uint32_t>(k);
    }
  }
  throw usage(std::string(what) + ": " + name + " is no link of the robot",
              "name one of its links, such as " + robot.links.front().name);
}

py::array link_pairs_array(const std::vector<LinkPair>& pairs) {
  py::array_t<std::uint32_t> array({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
  std::uint32_t* to = array.mutable_data();
  for (const LinkPair& pair : pairs) {
    *to++ = pair.a;
    *to++ = pair.b;
  }
  return array;
}

void bind_robots(py::module_& module) {
  bind_links_and_joints(module);
  bind_robot(module);
  module.def("read_robot", &read_any_robot, py::arg("urdf"), py::arg("srdf") = py::none(),
             py::kw_only(), py::arg("name") = "",
             py::arg("packages") = std::map<std::string, py::object>(),
             py::arg("package_path") = std::vector<py::object>(),
             py::arg("tessellation_error") = RobotReadOptions{}.tessellation_error,
             py::arg("strict") = false, py::arg("max_memory") = 0, py::arg("progress") = py::none(),
             kReadRobotDoc);
}

}  // namespace soms::python

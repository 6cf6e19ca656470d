// Robots in their cells: RobotModel.
#include "soms/robot/robot_model.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/objects.h"
#include "python/src/part_set.h"
#include "python/src/poses.h"
#include "python/src/scene/robot_models.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kModelDoc =
    R"(RobotModel(robot, cell=(), *, base=None, ignored=(), off_cell=(), threads=1, progress=None)

A robot and the cell that it moves in, ready for robot_contacts. Build it once. It does not change.

Each pair of links with collision meshes is compared, but neighbors, or where the robot has an SRDF
file, but the pairs that it allows; and each link with each part of the cell. robot: Robot. cell: a
Body (at its pose), Shape or Mesh, or a list of them, in meters. base: pose of the root link. ignored:
further pairs of links, by numbers or names, that are not compared. off_cell: links that are not
compared with the cell.

Raises Error of kind usage, out_of_range (a link that is not there, more than 4,096 links with meshes),
not_rigid. Cost: the trees of all meshes, and whether they are closed.)";

/// The meshes of a cell where they stand: their vertices are those that queries would move.
std::vector<Mesh> placed(const std::vector<PosedMesh>& models) {
  std::vector<Mesh> meshes;
  for (const PosedMesh& model : models) {
    check(model.pose);
    Mesh& mesh = meshes.emplace_back(*model.mesh);
    if (!(model.pose == Pose())) {
      for (Vec3& vertex : mesh.vertices) {
        vertex = model.pose.apply(vertex);
      }
      check(mesh);
    }
  }
  return meshes;
}

/// \errors ErrorKind::usage, out_of_range; `what` is the argument.
std::vector<LinkPair> link_pairs_of(const Robot& robot, const py::iterable& given,
                                    const std::string& what) {
  std::vector<LinkPair> pairs;
  for (const py::handle pair : given) {
    const auto links = py::reinterpret_borrow<py::object>(pair).cast<py::sequence>();
    if (py::isinstance<py::str>(pair) || links.size() != 2) {
      throw usage(what + ": " + py::repr(pair).cast<std::string>(), "give pairs of links");
    }
    const std::uint32_t a = link_of(py::object(links[0]), robot, what.c_str());
    const std::uint32_t b = link_of(py::object(links[1]), robot, what.c_str());
    if (a == b) {
      throw usage(what + ": a pair of one link", "give two links");
    }
    pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  return pairs;
}

std::vector<std::uint32_t> links_of(const Robot& robot, const py::iterable& given,
                                    const char* what) {
  std::vector<std::uint32_t> links;
  for (const py::handle link : given) {
    links.push_back(link_of(link, robot, what));
  }
  return links;
}

RobotModelOptions model_options(const Robot& robot, const py::object& base,
                                const py::iterable& ignored, const py::iterable& off_cell) {
  RobotModelOptions options;
  if (!base.is_none()) {
    options.base = pose_of(base);
  }
  options.ignored = link_pairs_of(robot, ignored, "ignored");
  options.off_cell = links_of(robot, off_cell, "off_cell");
  return options;
}

/// What the bodies of the cell are called.
std::vector<std::string> cell_names_of(const RobotModel& model, const std::vector<Mesh>& meshes) {
  std::vector<std::string> names;
  for (const RobotBody& body : model.cell_bodies()) {
    std::string name = part_text(meshes[body.mesh], body.part.part);
    for (const RobotMeshPart& other : body.joined) {
      name += " + " + part_text(meshes[other.mesh], other.part);
    }
    names.push_back(std::move(name));
  }
  return names;
}

SharedModel model_of(const SharedRobot& robot, std::vector<PosedMesh> cell,
                     const RobotModelOptions& options, int threads, const py::object& progress) {
  return run(Work::many, threads, progress, [&](const Limits& limits) {
    const std::vector<Mesh> meshes = placed(cell);
    auto held = std::make_shared<HeldRobotModel>(HeldRobotModel{
        robot, RobotModel(robot->robot, meshes, options, limits), {}, std::move(cell), options});
    held->cell_names = cell_names_of(held->model, meshes);
    return held;
  });
}

SharedModel make_model(const SharedRobot& robot, const py::object& cell, const py::object& base,
                       const py::iterable& ignored, const py::iterable& off_cell, int threads,
                       const py::object& progress) {
  std::vector<PosedMesh> models = posed_meshes_of(cell, "cell");
  return model_of(robot, std::move(models), model_options(robot->robot, base, ignored, off_cell),
                  threads, progress);
}

SharedModel with_cell(const HeldRobotModel& held, const py::object& cell, int threads,
                      const py::object& progress) {
  std::vector<PosedMesh> models = posed_meshes_of(cell, "cell");
  return run(Work::many, threads, progress, [&](const Limits& limits) {
    const std::vector<Mesh> meshes = placed(models);
    RobotModel model = held.model.with_cell(meshes, limits);
    std::vector<std::string> names = cell_names_of(model, meshes);
    return std::make_shared<HeldRobotModel>(HeldRobotModel{
        held.robot, std::move(model), std::move(names), std::move(models), held.options});
  });
}

SharedModel with_ignored(const HeldRobotModel& held, const py::iterable& given) {
  const std::vector<LinkPair> pairs = link_pairs_of(held.robot->robot, given, "pairs");
  auto other = std::make_shared<HeldRobotModel>(held);
  other->model = held.model.with_ignored(pairs);
  other->options.ignored.insert(other->options.ignored.end(), pairs.begin(), pairs.end());
  return other;
}

/// The robot gets a link, too, so that its links are those of the model, in this process and where
/// the model is pickled to.
SharedModel with_attached(const HeldRobotModel& held, const Text& name, const py::object& link,
                          const py::object& mesh, const py::object& pose,
                          const py::iterable& touching, int threads, const py::object& progress) {
  Robot robot = held.robot->robot;
  const RobotAttachment object{.name = name.bytes,
                               .link = link_of(link, robot, "link"),
                               .meshes = placed(posed_meshes_of(mesh, "mesh")),
                               .pose = pose.is_none() ? Pose() : pose_of(pose),
                               .touching = links_of(robot, touching, "touching")};
  return run(Work::many, threads, progress, [&](const Limits& limits) {
    auto other = std::make_shared<HeldRobotModel>(held);
    other->model = held.model.with_attached(object, limits);
    robot.links.push_back({object.name, object.meshes});
    robot.joints.push_back(other->model.kinematics().joints().back());
    const auto number = static_cast<std::uint32_t>(robot.links.size() - 1);
    other->robot = std::make_shared<HeldRobot>(std::move(robot));
    for (const LinkPair& pair : other->model.skipped()) {
      if (pair.b == number) {
        other->options.ignored.push_back(pair);
      }
    }
    return other;
  });
}

py::tuple model_state(const HeldRobotModel& held) {
  py::list cell;
  for (const PosedMesh& model : held.cell) {
    cell.append(py::make_tuple(std::const_pointer_cast<Mesh>(model.mesh), model.pose));
  }
  return py::make_tuple(held.robot, cell, packed(held.options));
}

SharedModel model_from(const py::tuple& state) {
  std::vector<PosedMesh> cell;
  for (const py::handle model : state[1]) {
    const auto pair = py::reinterpret_borrow<py::object>(model).cast<py::tuple>();
    cell.push_back({pair[0].cast<std::shared_ptr<Mesh>>(), pair[1].cast<Pose>()});
  }
  return model_of(state[0].cast<SharedRobot>(), std::move(cell),
                  unpacked<RobotModelOptions>(py::tuple(state[2])), 1, py::none());
}

/// Bodies that are not closed, so that what may lie in them is undecided.
std::vector<Text> open_bodies(const HeldRobotModel& held) {
  std::vector<Text> names;
  for (std::size_t i = 0; i < held.model.bodies(); ++i) {
    const RobotBody& body = held.model.body(i);
    if (!body.part.closed) {
      const bool is_link = i < held.model.link_bodies().size();
      names.push_back(
          {is_link ? held.model.link_names()[body.owner] : held.cell_names[body.owner]});
    }
  }
  return names;
}

void bind_model(py::module_& module) {
  py::class_<HeldRobotModel, SharedModel> model(module, "RobotModel", kModelDoc);
  model.def(py::init(&make_model), py::arg("robot"), py::arg("cell") = py::tuple(), py::kw_only(),
            py::arg("base") = py::none(), py::arg("ignored") = py::tuple(),
            py::arg("off_cell") = py::tuple(), py::arg("threads") = 1,
            py::arg("progress") = py::none());
  model.def_readonly("robot", &HeldRobotModel::robot, "The Robot.");
  model.def_property_readonly(
      "base", [](const HeldRobotModel& h) { return h.model.base(); }, "Pose of the root link.");
  model.def_property_readonly(
      "link_names", [](const HeldRobotModel& h) { return texts_of(h.model.link_names()); },
      "A list of str: the names of all links.");
  model.def_property_readonly(
      "cell_names", [](const HeldRobotModel& h) { return texts_of(h.cell_names); },
      "A list of str: the names of the parts of the cell, each with those around it.");
  model.def_property_readonly(
      "compared", [](const HeldRobotModel& h) { return link_pairs_array(h.model.compared()); },
      "(m, 2) uint32: pairs of links that are compared.");
  model.def_property_readonly(
      "skipped", [](const HeldRobotModel& h) { return link_pairs_array(h.model.skipped()); },
      "(m, 2) uint32: pairs of links that are not, though both have meshes.");
  def_property(
      model, "on_cell",
      [](const py::object& self) {
        return column_of(self.cast<const HeldRobotModel&>().model.on_cell(), self);
      },
      "(m,) uint32: links that are compared with the cell.");
  model.def_property_readonly(
      "open", &open_bodies,
      "A list of str: links and bodies of the cell that are not closed; what may lie in one of "
      "them is undecided.");
  model.def("with_cell", &with_cell, py::arg("cell"), py::kw_only(), py::arg("threads") = 1,
            py::arg("progress") = py::none(),
            "with_cell(cell, *, threads=1, progress=None) -> RobotModel\n\nThis robot in another "
            "cell. Trees of links are shared.");
  model.def("with_attached", &with_attached, py::arg("name"), py::arg("link"), py::arg("mesh"),
            py::arg("pose") = py::none(), py::kw_only(), py::arg("touching") = py::tuple(),
            py::arg("threads") = 1, py::arg("progress") = py::none(),
            "with_attached(name, link, mesh, pose=None, *, touching=(), threads=1, progress=None) "
            "-> RobotModel\n\nThis robot with something that a link carries: the last of its "
            "links, which adds nothing to a state.\nmesh: as cell. pose: of it, in the frame of "
            "the link. touching: further links that it may touch.");
  model.def("with_ignored", &with_ignored, py::arg("pairs"),
            "with_ignored(pairs) -> RobotModel\n\nThis robot without comparing these pairs of "
            "links. No tree is built.");
  model.def(py::pickle(&model_state, &model_from));
  model.def("__repr__", [](const HeldRobotModel& h) {
    return "RobotModel{" + std::to_string(h.model.link_names().size()) + " links, " +
           std::to_string(h.model.compared().size()) + " pairs compared, " +
           std::to_string(h.cell_names.size()) + " parts of the cell}";
  });
}

}  // namespace

void bind_robot_model(py::module_& module) {
  bind_model(module);
}

}  // namespace soms::python

#include "python/src/scene/scene.h"

#include "python/src/call.h"
#include "python/src/notebook.h"
#include "python/src/poses.h"
#include "python/src/scene/bodies.h"

#include <pybind11/stl.h>

#include <span>
#include <string>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kSceneDoc = R"(Scene()

A static environment of bodies, and movers that share shapes. Poses are set through the scene, so
there is nothing to update. For one thread at a time; step takes the threads it is given.

Bodies are numbered when they are added; numbers are never used again. given_mover(number) and
given_environment(number) return the very objects that were added.)";

constexpr const char* kStepDoc =
    R"(step(*, mode='all', scope='every_pair', mover_mover=True, clearance=0.0, swept=False, threads=1,
     progress=None)

All overlaps at the present poses: who touches whom, and with which triangles.

mode: 'all' pairs of triangles; 'any' one for each pair of bodies; 'first' the least. scope:
'first_contact' compares each mover up to its first contact. mover_mover: compare movers with each
other. clearance: report the gaps of bodies that are at most so far apart and do not touch. swept:
report passages: who touches whom on the way from the last step to this one.

Returns StepReport: the same bytes for any number of threads. Raises Error of kind usage.)";

constexpr const char* kSetPosesDoc = R"(set_poses(poses, movers=None)

Moves many movers.

poses: n poses, as overlap takes them. movers: n numbers; None for all, in ascending order.
Raises Error of kind usage, not_rigid, not_finite, out_of_range; movers before the one at fault are
moved then.)";

void set_poses(HeldScene& held, const py::object& given, const py::object& movers) {
  const SceneUse use(held);
  const Rows<Pose> rows = poses_of(given);
  const std::span<const Pose> poses = rows.get();
  std::vector<MoverId> ids;
  if (movers.is_none()) {
    ids = use.scene().movers();
  } else {
    Extents shape;
    ids = ids_of(movers, "movers", shape);
  }
  if (ids.size() != poses.size()) {
    throw usage(
        std::to_string(poses.size()) + " poses for " + std::to_string(ids.size()) + " movers",
        "give one pose for each mover");
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    use.scene().set_pose(ids[i], poses[i]);
  }
}

StepReport step(HeldScene& held, const py::object& mode, const py::object& scope, bool mover_mover,
                double clearance, bool swept, int threads, const py::object& progress) {
  const SceneUse use(held);
  const StepOptions options{.mode = enum_of<OverlapMode>(mode, "mode"),
                            .scope = enum_of<StepScope>(scope, "scope"),
                            .mover_mover = mover_mover,
                            .clearance = clearance,
                            .swept = swept};
  return run(Work::many, threads, progress,
             [&](const Limits& limits) { return use.scene().step(options, limits); });
}

/// A method that calls a member of Scene.
template <class Result, class... Arguments>
auto through(Result (Scene::*member)(Arguments...)) {
  return [member](HeldScene& held, Arguments... arguments) {
    return (SceneUse(held).scene().*member)(arguments...);
  };
}

void bind_bodies(SceneClass& scene) {
  scene.def(
      "add_environment",
      [](HeldScene& held, const py::object& given) {
        const SceneUse use(held);
        const EnvironmentId id = use.scene().add_environment(BodyArgument(given, "body").get());
        held.environment[id] = given;
        return id;
      },
      py::arg("body"), "add_environment(body) -> int\n\nAdds a static body; returns its number.");
  scene.def(
      "add_mover",
      [](HeldScene& held, const py::object& given, std::uint32_t group) {
        const SceneUse use(held);
        const MoverId id = use.scene().add_mover(BodyArgument(given, "body").get(), group);
        held.movers[id] = given;
        return id;
      },
      py::arg("body"), py::arg("group") = 0,
      "add_mover(body, group=0) -> int\n\nAdds a mover; returns its number. Movers of one group "
      "above 0 are not compared with each other.");
  scene.def(
      "remove_environment",
      [](HeldScene& held, EnvironmentId id) {
        SceneUse(held).scene().remove_environment(id);
        held.environment.erase(id);
      },
      py::arg("number"), "remove_environment(number)");
  scene.def(
      "remove_mover",
      [](HeldScene& held, MoverId id) {
        SceneUse(held).scene().remove_mover(id);
        held.movers.erase(id);
      },
      py::arg("number"), "remove_mover(number)");
  scene.def(
      "mover", [](HeldScene& held, MoverId id) { return SceneUse(held).scene().mover(id); },
      py::arg("number"), "mover(number) -> Body\n\nThe mover at its present pose.");
  scene.def(
      "environment",
      [](HeldScene& held, EnvironmentId id) { return SceneUse(held).scene().environment(id); },
      py::arg("number"), "environment(number) -> Body");
}

/// The very objects that were added.
void bind_given(SceneClass& scene) {
  const auto given = [](const auto& objects, std::uint32_t id, const char* what) -> py::object {
    const auto found = objects.find(id);
    if (found == objects.end()) {
      throw usage(std::string(what) + " " + std::to_string(id) + " is not in the scene",
                  "give a number that was returned when it was added");
    }
    return found->second;
  };
  scene.def(
      "given_mover",
      [given](const HeldScene& held, MoverId id) { return given(held.movers, id, "mover"); },
      py::arg("number"), "given_mover(number)\n\nThe very object that was added as this mover.");
  scene.def(
      "given_environment",
      [given](const HeldScene& held, EnvironmentId id) {
        return given(held.environment, id, "part of the environment");
      },
      py::arg("number"),
      "given_environment(number)\n\nThe very object that was added as this part.");
  scene.def_property_readonly(
      "movers", [](HeldScene& held) { return SceneUse(held).scene().movers(); },
      "Numbers of the movers, ascending.");
  scene.def_property_readonly(
      "environments", [](HeldScene& held) { return SceneUse(held).scene().environments(); },
      "Numbers of the parts of the environment, ascending.");
  scene.def_property_readonly(
      "memory", [](HeldScene& held) { return SceneUse(held).scene().memory(); },
      "Bytes held, shapes not counted.");
}

void bind_changes(SceneClass& scene) {
  scene.def("set_group", through(&Scene::set_group), py::arg("number"), py::arg("group"),
            "set_group(number, group)");
  scene.def("ignore", through(&Scene::ignore), py::arg("a"), py::arg("b"),
            "ignore(a, b)\n\nThese two movers are not compared with each other.");
  scene.def("unignore", through(&Scene::unignore), py::arg("a"), py::arg("b"), "unignore(a, b)");
  scene.def("ignore_environment", through(&Scene::ignore_environment), py::arg("mover"),
            py::arg("part"), "ignore_environment(mover, part)");
  scene.def("unignore_environment", through(&Scene::unignore_environment), py::arg("mover"),
            py::arg("part"), "unignore_environment(mover, part)");
  scene.def(
      "set_pose",
      [](HeldScene& held, MoverId id, const py::object& pose) {
        SceneUse(held).scene().set_pose(id, pose_of(pose));
      },
      py::arg("number"), py::arg("pose"),
      "set_pose(number, pose)\n\nMoves a mover. Constant time.");
  scene.def("set_poses", &set_poses, py::arg("poses"), py::arg("movers") = py::none(),
            kSetPosesDoc);
  scene.def(
      "set_shape",
      [](HeldScene& held, MoverId id, const py::object& shape) {
        SceneUse(held).scene().set_shape(id, shape_of(shape, "shape"));
      },
      py::arg("number"), py::arg("shape"),
      "set_shape(number, shape)\n\nGives a mover another shape, such as one from Shape.refit.");
  scene.def(
      "set_environment_shape",
      [](HeldScene& held, EnvironmentId id, const py::object& shape) {
        SceneUse(held).scene().set_environment_shape(id, shape_of(shape, "shape"));
      },
      py::arg("number"), py::arg("shape"), "set_environment_shape(number, shape)");
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_step_report(module);
  SceneClass scene(module, "Scene", kSceneDoc);
  scene.def(py::init<>());
  bind_bodies(scene);
  bind_given(scene);
  bind_changes(scene);
  scene.def("step", &step, py::kw_only(), py::arg("mode") = "all", py::arg("scope") = "every_pair",
            py::arg("mover_mover") = true, py::arg("clearance") = 0.0, py::arg("swept") = false,
            py::arg("threads") = 1, py::arg("progress") = py::none(), kStepDoc);
  bind_scene_queries(module, scene);
  def_notebook_page(scene);
  scene.def("__repr__", [](HeldScene& held) {
    const SceneUse use(held);
    return "Scene{" + std::to_string(use.scene().environments().size()) + " environments, " +
           std::to_string(use.scene().movers().size()) + " movers}";
  });
}

}  // namespace soms::python

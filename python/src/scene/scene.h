/// \file
/// A scene and the objects of Python that it was made of.
#pragma once

#include "soms/scene/scene.h"

#include "python/src/answer.h"
#include "python/src/errors.h"
#include "python/src/one_caller.h"

#include <pybind11/pybind11.h>

#include <atomic>
#include <cstdint>
#include <map>

namespace soms::python {

/// A Scene for one caller at a time, which remembers the bodies as they were given.
struct HeldScene {
  Scene scene;
  std::map<MoverId, py::object> movers;
  std::map<EnvironmentId, py::object> environment;
  std::atomic<bool> is_busy = false;
};

/// A scene in use by one caller.
class SceneUse {
 public:
  /// \errors ErrorKind::usage where another call is running.
  explicit SceneUse(HeldScene& held) : held_(held), caller_(held.is_busy, "scene") {}

  [[nodiscard]] Scene& scene() const { return held_.scene; }

  [[nodiscard]] const Scene& queried() const { return held_.scene; }

 private:
  HeldScene& held_;
  OneCaller caller_;
};

[[nodiscard]] inline SceneUse use(HeldScene& held) {
  return SceneUse(held);
}

using SceneClass = py::class_<HeldScene>;

/// What a step finds, and what queries of points and rays say.
void bind_step_report(py::module_& module);
void bind_scene_queries(py::module_& module, SceneClass& scene);

}  // namespace soms::python

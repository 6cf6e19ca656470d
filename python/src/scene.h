/// \file
/// A scene and the objects of Python that it was made of.
#pragma once

#include "soms/scene/scene.h"

#include "python/src/answer.h"
#include "python/src/errors.h"

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

/// Keeps other threads, and calls from `progress`, off a scene for as long as it lives.
class SceneUse {
 public:
  /// \errors ErrorKind::usage where another call is running.
  explicit SceneUse(HeldScene& held) : held_(held) {
    if (held.is_busy.exchange(true)) {
      throw usage("scene: another call is running", "use a scene from one thread at a time");
    }
  }

  ~SceneUse() { held_.is_busy = false; }

  SceneUse(const SceneUse&) = delete;
  SceneUse& operator=(const SceneUse&) = delete;

  [[nodiscard]] Scene& scene() const { return held_.scene; }

 private:
  HeldScene& held_;
};

using SceneClass = py::class_<HeldScene>;

/// What a step finds, and what queries of points and rays say.
void bind_step_report(py::module_& module);
void bind_scene_queries(py::module_& module, SceneClass& scene);

}  // namespace soms::python

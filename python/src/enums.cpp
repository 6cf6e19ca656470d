#include "python/src/enums.h"

#include "soms/base/pose.h"
#include "soms/clash/clash.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/point_distance.h"
#include "soms/io/write_mesh.h"
#include "soms/kinematics/robot.h"
#include "soms/query/contains_parts.h"
#include "soms/query/overlap.h"
#include "soms/query/ray.h"
#include "soms/query/solid.h"
#include "soms/robot/robot_query.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"
#include "soms/tree/build_options.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/shape.h"

#include <string_view>
#include <utility>

namespace soms::python {

namespace {

template <class E>
void load(const py::module_& enums) {
  const std::string name(kWords<E>.type);
  auto* const found = new EnumMembers{name, {}, {}, {}};  // for as long as the process lives
  const py::object of_python = enums.attr(name.c_str());
  for (const std::string_view word : kWords<E>.names) {
    found->words.emplace_back(word);
    found->names.push_back(PyUnicode_InternFromString(found->words.back().c_str()));
    found->members.push_back(
        py::object(of_python.attr(found->words.back().c_str())).release().ptr());
  }
  enum_members<E> = found;
}

template <class... E>
void load_all(const py::module_& enums) {
  (load<E>(enums), ...);
}

}  // namespace

void load_enums() {
  load_all<ClashKind, ContactChange, Coverage, CrossingKind, JointType, Layout, TreeCheck,
           MeshFormat, OverlapMode, Partition, RecordedMesh::Origin, RecordingEnding, Relation,
           RobotVerdict, Rotation, Rule, SceneBodyKind, Side, StepScope, TriangleFeature, Undecided,
           UpAxis>(py::module_::import("soms._enums"));
}

std::size_t enum_value(py::handle given, const EnumMembers& members, const char* what) {
  for (std::size_t i = 0; i < members.members.size(); ++i) {
    if (given.ptr() == members.members[i] || given.ptr() == members.names[i]) {
      return i;
    }
  }
  if (PyUnicode_Check(given.ptr()) != 0) {
    const char* const word = PyUnicode_AsUTF8(given.ptr());
    if (word == nullptr) {
      throw py::error_already_set();
    }
    for (std::size_t i = 0; i < members.words.size(); ++i) {
      if (members.words[i] == word) {
        return i;
      }
    }
  }
  std::string names;
  for (const std::string& word : members.words) {
    names += (names.empty() ? "" : ", ") + word;
  }
  throw usage(
      std::string(what) + ": " + py::repr(given).cast<std::string>() + " is no " + members.name,
      "give one of " + names);
}

}  // namespace soms::python

#include "python/src/enums.h"

#include "soms/base/pose.h"
#include "soms/base/print.h"
#include "soms/clash/clash.h"
#include "soms/clash/print.h"
#include "soms/geometry/mesh.h"
#include "soms/geometry/point_distance.h"
#include "soms/geometry/print.h"
#include "soms/io/print.h"
#include "soms/io/write_mesh.h"
#include "soms/kinematics/print.h"
#include "soms/kinematics/robot.h"
#include "soms/query/contains_parts.h"
#include "soms/query/overlap.h"
#include "soms/query/print.h"
#include "soms/query/ray.h"
#include "soms/query/solid.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/print.h"
#include "soms/scene/recording.h"
#include "soms/scene/scene_query.h"
#include "soms/scene/step_report.h"
#include "soms/tree/build_options.h"
#include "soms/tree/file/shape_bytes.h"
#include "soms/tree/print.h"
#include "soms/tree/shape.h"

#include "python/src/answer.h"
#include "python/src/bind.h"

#include <pybind11/stl.h>

#include <ostream>
#include <utility>

namespace soms::python {

namespace {

/// What C++ calls the enumerators, by the name in Python.
std::vector<std::pair<std::string, std::vector<std::string>>> printed_words;

/// Those of E, as `<<` prints them: a value beyond the last one is printed as "E(7)".
template <class E>
std::vector<std::string> words_of() {
  std::vector<std::string> words;
  for (int value = 0;; ++value) {
    std::string word = printed(static_cast<E>(value));
    if (word.find('(') != std::string::npos) {
      return words;
    }
    words.push_back(std::move(word));
  }
}

template <class E>
void load(const py::module_& enums, const char* name) {
  auto* const found = new EnumMembers{name, {}, {}, {}};  // for as long as the process lives
  for (const py::handle& one : enums.attr(name)) {
    if (one.cast<std::size_t>() != found->members.size()) {
      throw py::value_error(std::string(name) + " does not count from 0");
    }
    found->words.push_back(one.attr("name").cast<std::string>());
    found->names.push_back(PyUnicode_InternFromString(found->words.back().c_str()));
    found->members.push_back(py::reinterpret_borrow<py::object>(one).release().ptr());
  }
  enum_members<E> = found;
  if constexpr (requires(std::ostream & out) { out << E{}; }) {
    printed_words.emplace_back(name, words_of<E>());
  }
}

}  // namespace

void load_enums() {
  const py::module_ enums = py::module_::import("soms._enums");
  load<ClashKind>(enums, "ClashKind");
  load<ContactChange>(enums, "ContactChange");
  load<Coverage>(enums, "Coverage");
  load<CrossingKind>(enums, "CrossingKind");
  load<JointType>(enums, "JointType");
  load<Layout>(enums, "Layout");
  load<TreeCheck>(enums, "TreeCheck");
  load<MeshFormat>(enums, "MeshFormat");
  load<OverlapMode>(enums, "OverlapMode");
  load<Partition>(enums, "Partition");
  load<RecordedMesh::Origin>(enums, "RecordedOrigin");
  load<RecordingEnding>(enums, "RecordingEnding");
  load<Relation>(enums, "Relation");
  load<RobotVerdict>(enums, "RobotVerdict");
  load<Rotation>(enums, "Rotation");
  load<Rule>(enums, "Rule");
  load<SceneBodyKind>(enums, "SceneBodyKind");
  load<Side>(enums, "Side");
  load<StepScope>(enums, "StepScope");
  load<TriangleFeature>(enums, "TriangleFeature");
  load<Undecided>(enums, "Undecided");
  load<UpAxis>(enums, "UpAxis");
}

void bind_enum_words(py::module_& module) {
  module.def(
      "_enum_words", [] { return printed_words; },
      "_enum_words() -> [(name, words)]\n\nThe enumerators of C++, with which a test compares "
      "soms._enums.");
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

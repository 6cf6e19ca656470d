// Ways of robots from state to state: robot_path.
#include "soms/robot/robot_path.h"

#include "soms/robot/print.h"

#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/scene/record_columns.h"
#include "python/src/scene/robot_models.h"

#include <pybind11/stl.h>

#include <array>
#include <limits>

namespace soms::python {

namespace {

constexpr const char* kPathDoc =
    R"(robot_path(model, states, *, first_blocked=False, timeout=None, threads=1, progress=None)

Does a robot touch anything on its way from state to state? Proved for all times in between, with every
joint going straight in its value; each state is decided once, as robot_contacts does.

model: RobotModel. states: (n, k), radians and meters. first_blocked: end at the first segment that is
not free. timeout, threads, progress: as for overlap.

Returns RobotPath, whose segment i is from state i to i + 1. verdict 'free': nothing touches at any time;
'contact': free until lower, in contact at the state at upper; 'started': in contact at the first state;
'grazing': neither is proved, treat it as a contact. What an open body encloses is looked at in states
only. Raises Error of kind usage, not_finite, out_of_range; names the state or segment.)";

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// link, other and cell of each segment; -1 where none is named. \shape (n, 3).
py::array segment_pairs_of(const RobotPath& path) {
  py::array_t<std::int64_t> array({static_cast<py::ssize_t>(path.size()), py::ssize_t{3}});
  std::int64_t* to = array.mutable_data();
  for (const RobotSegment& segment : path.segments) {
    *to++ = segment.pair ? std::int64_t{segment.pair->link} : -1;
    *to++ = segment.pair ? std::int64_t{segment.pair->other} : -1;
    *to++ = segment.pair ? std::int64_t{segment.pair->cell ? 1 : 0} : -1;
  }
  return array;
}

/// NaN where none is named. \shape (n, 3).
py::array points_of(const RobotPath& path) {
  py::array_t<double> array({static_cast<py::ssize_t>(path.size()), py::ssize_t{3}});
  double* to = array.mutable_data();
  for (const RobotSegment& segment : path.segments) {
    const Vec3 point = segment.point.value_or(Vec3{kNoNumber, kNoNumber, kNoNumber});
    for (const double x : {point.x, point.y, point.z}) {
      *to++ = x;
    }
  }
  return array;
}

void bind_segment(py::module_& module) {
  AnswerClass<RobotSegment> segment(module, "RobotSegment",
                                    "What robot_path proves between two states.");
  segment.field("verdict", &RobotSegment::verdict, "ContactVerdict.")
      .derived(
          "lower", [](const RobotSegment& s) { return s.t.lower; },
          "No surfaces meet before this part of the way; 1 where all is free.")
      .derived(
          "upper", [](const RobotSegment& s) { return s.t.upper; },
          "The state at this part of the way is in contact; inf where none is proved to be.")
      .derived(
          "pair", [](const RobotSegment& s) { return pair_of(s.pair); },
          "(link, other, cell) of the pair in contact at upper, or next to it at lower: other is a "
          "part of the cell or a link; or None.")
      .field("point", &RobotSegment::point, "(3,): where that is, in the cell; or None.")
      .field("undecided", &RobotSegment::undecided,
             "Pairs of bodies that are undecided in the two states.")
      .field("coverage", &RobotSegment::coverage, "Coverage.")
      .field("cost", &RobotSegment::cost, "Cost, without the states.");
}

void bind_path(py::module_& module) {
  AnswerClass<RobotPath> path(module, "RobotPath",
                              "Answer of robot_path for n states: n - 1 segments.");
  const auto column = [&](const char* name, auto place, const char* doc) {
    def_property(
        path, name,
        [place](const py::object& self) {
          return field_column(self.cast<const RobotPath&>().segments, place, self);
        },
        doc);
  };
  column("verdict", &RobotSegment::verdict, "(n - 1,) integers of ContactVerdict.");
  column("undecided", &RobotSegment::undecided,
         "(n - 1,) uint64: pairs that are undecided in the two states.");
  column("coverage", &RobotSegment::coverage, "(n - 1,) integers of Coverage.");
  path.derived(
          "free",
          [](const RobotPath& p) {
            return computed_column<bool>(p.segments, [](const RobotSegment& s) {
              return s.verdict == ContactVerdict::free;
            });
          },
          "(n - 1,) bool: nothing that is compared touches at any time.")
      .derived(
          "lower",
          [](const RobotPath& p) {
            return computed_column<double>(p.segments,
                                           [](const RobotSegment& s) { return s.t.lower; });
          },
          "(n - 1,): no surfaces meet before this part of the way.")
      .derived(
          "upper",
          [](const RobotPath& p) {
            return computed_column<double>(p.segments,
                                           [](const RobotSegment& s) { return s.t.upper; });
          },
          "(n - 1,): the state at this part of the way is in contact; inf where none is.")
      .derived("pairs", &segment_pairs_of,
               "(n - 1, 3) int64: link, other, and 1 where other is a part of the cell; -1 where "
               "no pair is named.")
      .derived("point", &points_of, "(n - 1, 3): where that is, in the cell; NaN where none is.")
      .derived(
          "blocked", [](const RobotPath& p) { return p.blocked; },
          "The first segment that is not free, or None.")
      .derived(
          "states", [](const RobotPath& p) { return RobotAnswerBatch(p.states); },
          "RobotAnswerBatch of the n states, as robot_contacts answers them.")
      .field("cost", &RobotPath::cost, "Cost of states and segments together.")
      .entries();
}

py::object query_robot_path(const SharedModel& held, const py::object& given, bool first_blocked,
                            std::optional<double> timeout, int threads,
                            const py::object& progress) {
  const States states = states_of(given, held->model.kinematics());
  return made(run(Work::many, {threads, timeout}, progress, [&](const Limits& limits) {
    return robot_path(held->model, states.numbers.get(), {.first_blocked = first_blocked}, limits);
  }));
}

}  // namespace

void bind_robot_path(py::module_& module) {
  bind_segment(module);
  bind_path(module);
  def_function(module, "robot_path", &query_robot_path, kPathDoc,
               with_limits({{"model"}, {"states"}, {"first_blocked", py::bool_(false), true}}));
}

}  // namespace soms::python

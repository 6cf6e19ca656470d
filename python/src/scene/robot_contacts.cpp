// States of robots in their cells: robot_contacts.
#include "soms/query/print.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/scene/record_columns.h"
#include "python/src/scene/robot_models.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace soms::python {

/// link, other, cell, surfaces_meet.
template <>
struct RowType<RobotContact> {
  static py::dtype get() {
    constexpr std::size_t kPair = offsetof(RobotContact, pair);
    return structured({{"link", "u4", kPair + offsetof(RobotPair, link)},
                       {"other", "u4", kPair + offsetof(RobotPair, other)},
                       {"cell", "?", kPair + offsetof(RobotPair, cell)},
                       {"surfaces_meet", "?", offsetof(RobotContact, surfaces_meet)}},
                      sizeof(RobotContact));
  }
};

std::ostream& operator<<(std::ostream& out, const RobotAnswerBatch& batch) {
  std::size_t free = 0;
  for (const RobotAnswer& answer : batch.answers) {
    free += answer.verdict == RobotVerdict::free ? 1U : 0U;
  }
  return out << "RobotAnswerBatch{" << batch.size() << " states, " << free << " free, "
             << batch.contacts.size() << " contacts}";
}

py::object pair_of(const std::optional<RobotPair>& pair) {
  return pair ? py::make_tuple(pair->link, pair->other, pair->cell) : py::object(py::none());
}

namespace {

constexpr const char* kContactsDoc =
    R"(robot_contacts(model, states, *, first_contact=False, distance=False, at_most=inf, timeout=None, threads=1, progress=None)

Which links touch each other or the cell in given states, and how near are they? Decided exactly for
the poses of Robot.link_poses: surfaces that share a point touch, and so does what is inside of a closed
body. robot_path proves what is between two states.

model: RobotModel. states: (k,) for one, (n, k) for n, radians and meters. first_contact: stop a state
at its first pair. distance: also measure the least distance; at_most: only up to it. timeout, threads,
progress: as for overlap.

Returns RobotAnswer, or RobotAnswerBatch for n states. Raises Error of kind usage, not_finite,
out_of_range; names the state.)";

void bind_robot_answer(py::module_& module) {
  AnswerClass<RobotGap> gap(module, "RobotGap", "The least distance of what is compared.");
  gap.derived(
         "lower", [](const RobotGap& g) { return g.distance.lower; },
         "A double that the distance is not below; 0 where something touches.")
      .derived(
          "upper", [](const RobotGap& g) { return g.distance.upper; },
          "A double that it does not exceed; inf where it is farther than at_most.")
      .derived(
          "pair", [](const RobotGap& g) { return pair_of(g.pair); },
          "(link, other, cell) of the nearest pair: other is a part of the cell or a link; or "
          "None.")
      .derived(
          "points",
          [](const RobotGap& g) -> py::object {
            return g.points ? py::object(array_of(Box{(*g.points)[0], (*g.points)[1]}))
                            : py::object(py::none());
          },
          "(2, 3): ends of a shortest segment, where the pair does not touch; else None.")
      .field("farther", &RobotGap::farther, "The distance exceeds at_most, which lower is.");
  AnswerClass<RobotAnswer> answer(module, "RobotAnswer", "Answer of robot_contacts for a state.");
  answer.field("verdict", &RobotAnswer::verdict, "RobotVerdict: free, contact or undecided.")
      .column("contacts", &RobotAnswer::contacts,
              "(m,) with fields link, other, cell (other is a part of the cell, not a link), "
              "surfaces_meet (else one is inside the other); sorted.")
      .derived(
          "free", [](const RobotAnswer& a) { return a.verdict == RobotVerdict::free; },
          "bool: nothing that is compared touches.")
      .field("undecided", &RobotAnswer::undecided, "Pairs of bodies that were not decided.")
      .column("beyond_limits", &RobotAnswer::beyond_limits,
              "(m,) uint32: joints outside of their limits; the state is answered nevertheless.")
      .derived(
          "gap",
          [](const RobotAnswer& a) {
            return a.gap ? py::object(py::cast(*a.gap)) : py::object(py::none());
          },
          "RobotGap where distance was requested, else None.")
      .field("coverage", &RobotAnswer::coverage, "Coverage.")
      .field("cost", &RobotAnswer::cost, "Cost.");
}

/// Lower and upper of each gap, NaN where it was not measured. \shape (n, 2).
py::array gaps_of(const RobotAnswerBatch& batch) {
  py::array_t<double> array({static_cast<py::ssize_t>(batch.size()), py::ssize_t{2}});
  double* to = array.mutable_data();
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const RobotAnswer& answer : batch.answers) {
    *to++ = answer.gap ? answer.gap->distance.lower : kNone;
    *to++ = answer.gap ? answer.gap->distance.upper : kNone;
  }
  return array;
}

/// The first state that is not known to be free.
std::optional<std::size_t> first_blocked(const RobotAnswerBatch& batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (batch.answers[i].verdict != RobotVerdict::free) {
      return i;
    }
  }
  return std::nullopt;
}

void bind_robot_answers(py::module_& module) {
  AnswerClass<RobotAnswerBatch> batch(module, "RobotAnswerBatch",
                                      "Answers of robot_contacts for n states.");
  const auto column = [&](const char* name, auto place, const char* doc) {
    def_property(
        batch, name,
        [place](const py::object& self) {
          return field_column(self.cast<const RobotAnswerBatch&>().answers, place, self);
        },
        doc);
  };
  column("verdict", &RobotAnswer::verdict, "(n,) integers of RobotVerdict.");
  column("undecided", &RobotAnswer::undecided, "(n,) uint64: pairs that were not decided.");
  column("coverage", &RobotAnswer::coverage, "(n,) integers of Coverage.");
  column("costs", &RobotAnswer::cost, "(n,) node_tests, triangle_tests, exact_tests.");
  batch
      .column("contacts", &RobotAnswerBatch::contacts,
              "(m,) with the fields of RobotAnswer.contacts, of all states; those of i are of(i).")
      .rows(&RobotAnswerBatch::offsets, &RobotAnswerBatch::contacts)
      .column("offsets", &RobotAnswerBatch::offsets,
              "(n + 1,) uint64: state i has contacts[offsets[i]:offsets[i + 1]].")
      .derived(
          "free",
          [](const RobotAnswerBatch& b) {
            return computed_column<bool>(
                b.answers, [](const RobotAnswer& a) { return a.verdict == RobotVerdict::free; });
          },
          "(n,) bool: nothing that is compared touches.")
      .derived(
          "within_limits",
          [](const RobotAnswerBatch& b) {
            return computed_column<bool>(
                b.answers, [](const RobotAnswer& a) { return a.beyond_limits.empty(); });
          },
          "(n,) bool: all joints are within their limits; at(i).beyond_limits names the others.")
      .derived("gap", &gaps_of,
               "(n, 2): doubles that enclose the least distance; NaN where it was not measured.")
      .derived("first_blocked", &first_blocked,
               "The first state that is not known to be free, or None: of a path, where it ends.")
      .field("cost", &RobotAnswerBatch::cost, "Cost of all states together.")
      .entries();
}

py::object query_robot(const SharedModel& held, const py::object& given, bool first_contact,
                       bool distance, double at_most, std::optional<double> timeout, int threads,
                       const py::object& progress) {
  const RobotOptions options{
      .first_contact = first_contact, .distance = distance, .at_most = at_most};
  const States states = states_of(given, held->model.kinematics());
  const auto answers = [&](const Limits& limits) {
    return robot_contacts(held->model, states.numbers.get(), options, limits);
  };
  if (states.is_one) {
    return made(run(Work::one, {threads, timeout}, progress,
                    [&](const Limits& limits) { return std::move(answers(limits).at(0)); }));
  }
  return made(run(Work::many, {threads, timeout}, progress, [&](const Limits& limits) {
    std::vector<RobotAnswer> all = answers(limits);
    if (all.size() != states.rows) {  // no joint moves: the library has one state then
      all = std::vector<RobotAnswer>(states.rows, all.front());
    }
    return RobotAnswerBatch(std::move(all));
  }));
}

}  // namespace

void bind_robot_contacts(py::module_& module) {
  bind_robot_answer(module);
  bind_robot_answers(module);
  def_function(
      module, "robot_contacts", &query_robot, kContactsDoc,
      with_limits({{"model"},
                   {"states"},
                   {"first_contact", py::bool_(false), true},
                   {"distance", py::bool_(false), true},
                   {"at_most", py::float_(std::numeric_limits<double>::infinity()), true}}));
}

}  // namespace soms::python

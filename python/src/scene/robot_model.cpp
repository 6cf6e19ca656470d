// Robots in their cells: RobotModel and robot_contacts.
#include "soms/robot/robot_model.h"

#include "soms/query/print.h"
#include "soms/robot/print.h"
#include "soms/robot/robot_query.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/function.h"
#include "python/src/objects.h"
#include "python/src/part_set.h"
#include "python/src/poses.h"
#include "python/src/scene/record_columns.h"
#include "python/src/scene/robot_models.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
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

}  // namespace

std::ostream& operator<<(std::ostream& out, const RobotAnswerBatch& batch) {
  std::size_t free = 0;
  for (const RobotAnswer& answer : batch.answers) {
    free += answer.verdict == RobotVerdict::free ? 1U : 0U;
  }
  return out << "RobotAnswerBatch{" << batch.size() << " states, " << free << " free, "
             << batch.contacts.size() << " contacts}";
}

namespace {

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

RobotModelOptions model_options(const Robot& robot, const py::object& base,
                                const py::iterable& ignored, const py::iterable& off_cell) {
  RobotModelOptions options;
  if (!base.is_none()) {
    options.base = pose_of(base);
  }
  for (const py::handle pair : ignored) {
    const auto links = py::reinterpret_borrow<py::object>(pair).cast<py::sequence>();
    if (py::isinstance<py::str>(pair) || links.size() != 2) {
      throw usage("ignored: " + py::repr(pair).cast<std::string>(), "give pairs of links");
    }
    const std::uint32_t a = link_of(py::object(links[0]), robot, "ignored");
    const std::uint32_t b = link_of(py::object(links[1]), robot, "ignored");
    if (a == b) {
      throw usage("ignored: a pair of one link", "give two links");
    }
    options.ignored.push_back({std::min(a, b), std::max(a, b)});
  }
  for (const py::handle link : off_cell) {
    options.off_cell.push_back(link_of(link, robot, "off_cell"));
  }
  return options;
}

SharedModel model_of(const SharedRobot& robot, std::vector<PosedMesh> cell,
                     const RobotModelOptions& options, int threads, const py::object& progress) {
  return run(Work::many, threads, progress, [&](const Limits& limits) {
    const std::vector<Mesh> meshes = placed(cell);
    auto held = std::make_shared<HeldRobotModel>(HeldRobotModel{
        robot, RobotModel(robot->robot, meshes, options, limits), {}, std::move(cell), options});
    for (const RobotBody& body : held->model.cell_bodies()) {
      std::string name = part_text(meshes[body.mesh], body.part.part);
      for (const RobotMeshPart& other : body.joined) {
        name += " + " + part_text(meshes[other.mesh], other.part);
      }
      held->cell_names.push_back(name);
    }
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
  model.def(py::pickle(&model_state, &model_from));
  model.def("__repr__", [](const HeldRobotModel& h) {
    return "RobotModel{" + std::to_string(h.model.link_names().size()) + " links, " +
           std::to_string(h.model.compared().size()) + " pairs compared, " +
           std::to_string(h.cell_names.size()) + " parts of the cell}";
  });
}

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

py::object pair_of(const std::optional<RobotPair>& pair) {
  return pair ? py::make_tuple(pair->link, pair->other, pair->cell) : py::object(py::none());
}

void bind_robot_model(py::module_& module) {
  bind_model(module);
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

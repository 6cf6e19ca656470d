// Contacts from step to step.
#include "soms/geometry/parts_of.h"
#include "soms/scene/contact_spans.h"
#include "soms/scene/contact_tracker.h"
#include "soms/scene/print.h"

#include "python/src/described.h"
#include "python/src/scene/scene.h"
#include "python/src/scene/scene_columns.h"

#include <pybind11/stl.h>

#include <map>
#include <optional>

namespace soms::python {

/// (kind, number, part), the part None where there is none.
template <>
struct OwnForm<ContactSide> {
  static py::object make(const ContactSide& side) {
    const auto part = side.part == Part::kNoParent ? std::optional<std::uint32_t>() : side.part;
    return py::make_tuple(member(side.body.kind), side.body.id, part);
  }
};

namespace {

void bind_tracker(py::module_& module) {
  AnswerClass<ContactEvents> events(module, "ContactEvents",
                                    "What changed from one step to the next: sorted arrays.");
  events
      .column("environment", &ContactEvents::environment,
              "(n,) with fields mover, part, change (integers of ContactChange).")
      .column("movers", &ContactEvents::movers, "(n,) with fields a, b (a < b), change.");
  py::class_<ContactTracker> tracker(module, "ContactTracker", R"(ContactTracker()

Compares the report of each step with that of the step before: which bodies begin to touch, still
touch, and touch no longer.)");
  tracker.def(py::init<>());
  tracker.def("follow", &ContactTracker::follow, py::arg("report"),
              "follow(report) -> ContactEvents\n\nThe changes since the report before; at the "
              "first, every contact begins. Raises Error of kind\nusage for a report that may lack "
              "pairs.");
  tracker.def("clear", &ContactTracker::clear, "clear()\n\nForgets the report before.");
}

/// The parts of the meshes of a scene, made as they are needed.
class PartsOfScene {
 public:
  explicit PartsOfScene(const Scene& scene) : scene_(scene) {}

  std::uint32_t operator()(const SceneBody& body, TriangleId triangle) {
    const Body& found =
        body.kind == SceneBodyKind::mover ? scene_.mover(body.id) : scene_.environment(body.id);
    const MeshView* const mesh = &found.shape.mesh();
    return parts_.try_emplace(mesh, *mesh).first->second(triangle);
  }

 private:
  const Scene& scene_;
  std::map<const MeshView*, PartsOf> parts_;
};

void bind_spans(py::module_& module) {
  bind_answer<ContactSpan>(module);
  py::class_<ContactSpans> spans(module, "ContactSpans", R"(ContactSpans()

Gathers the contacts of steps: one record for each pair of bodies and stretch of time.)");
  spans.def(py::init<>());
  spans.def(
      "follow",
      [](ContactSpans& all, std::uint64_t step, const StepReport& report, HeldScene& held,
         bool by_part) {
        const SceneUse use(held);
        ContactBodies bodies = contact_bodies(use.scene());
        if (by_part) {
          bodies.part = PartsOfScene(use.scene());
        }
        all.follow(step, report, bodies);
      },
      py::arg("step"), py::arg("report"), py::arg("scene"), py::kw_only(),
      py::arg("by_part") = false,
      "follow(step, report, scene, *, by_part=False)\n\nAdds the report of a step of the scene, "
      "before anything moves. by_part: parts of meshes count, not\nbodies. Raises Error of kind "
      "usage unless step grows.");
  spans.def_property_readonly(
      "spans", [](const ContactSpans& all) { return all.spans(); },
      "A list of ContactSpan, by begin.");
}

}  // namespace

void bind_contacts(py::module_& module) {
  bind_tracker(module);
  bind_spans(module);
}

}  // namespace soms::python

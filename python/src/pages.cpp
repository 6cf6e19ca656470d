// The page of a report about bodies and an answer: text, and a view of the scene.
#include "soms/scene/contact_spans.h"

#include "apps/report/page.h"
#include "python/src/page_scene.h"
#include "python/src/text.h"

#include <pybind11/stl.h>

#include <sstream>
#include <string>
#include <utility>

namespace soms::python {

namespace {

std::string counted(std::uint64_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// What is drawn at each step, and what an answer says of it.
void add_answer(PageScene& scene, const py::object& answer) {
  if (const auto* const report = inside<StepReport>(answer)) {
    scene.add_step(*report);
  } else if (const auto* const overlap = inside<Overlap>(answer)) {
    scene.add_overlap(0, overlap->pairs, overlap->coverage);
  } else if (const auto* const overlaps = inside<OverlapBatch>(answer)) {
    scene.check_steps(overlaps->size());
    for (std::size_t i = 0; i < overlaps->size(); ++i) {
      scene.add_overlap(i, overlaps->pairs_of(i), overlaps->coverage[i]);
    }
  } else if (const auto* const distance = inside<Distance>(answer)) {
    scene.add_distance(0, *distance);
  } else if (const auto* const distances = inside<DistanceBatch>(answer)) {
    scene.check_steps(distances->size());
    for (std::size_t i = 0; i < distances->size(); ++i) {
      scene.add_distance(i, distances->at(i));
    }
  } else {
    throw usage(
        std::string("answer: an object of type ") + Py_TYPE(answer.ptr())->tp_name,
        "give a StepReport, Overlap or Distance, or a batch of the last two with its poses");
  }
}

report::Table table_of_gaps(const report::Scene& scene) {
  report::Table table{.title = "Gaps",
                      .columns = {"of", "to", "distance"},
                      .rows = {},
                      .caption =
                          "The least distances, in units of the models, to six digits; the "
                          "answer itself has brackets of doubles.",
                      .of_gaps = true};
  if (scene.steps.count > 1) {
    table.columns.emplace_back("pose");
  }
  for (const report::SceneGap& gap : scene.gaps) {
    table.rows.push_back({scene.bodies[gap.a].name, scene.bodies[gap.b].name, gap.length});
    if (scene.steps.count > 1) {
      table.rows.back().push_back(std::to_string(gap.nearest));
    }
  }
  return table;
}

std::vector<report::Fact> facts_of(const report::Scene& scene, bool has_answer) {
  std::uint64_t triangles = 0;
  for (const report::SceneBody& body : scene.bodies) {
    triangles += scene.models[body.model].mesh.triangles.size();
  }
  std::vector<report::Fact> facts{{"bodies", counted(scene.bodies.size(), "body", "bodies") + ", " +
                                                 counted(triangles, "triangle", "triangles")}};
  if (scene.steps.count > 1) {
    facts.push_back({"poses", std::to_string(scene.steps.count)});
  }
  if (has_answer && scene.lists_contacts) {
    facts.push_back({"bodies that touch", (scene.complete ? "" : "at least ") +
                                              counted(scene.rows.size(), "pair", "pairs")});
  }
  if (!scene.gaps.empty()) {
    facts.push_back({"gaps", std::to_string(scene.gaps_in_all)});
  }
  return facts;
}

py::tuple page_of(const py::object& given, const py::object& answer, const py::object& poses,
                  const Text& title, std::uint64_t triangles) {
  PageScene bodies(given, poses);
  if (!answer.is_none()) {
    add_answer(bodies, answer);
  }
  report::Page page{.title = title.bytes.empty() ? bodies.title() : title.bytes,
                    .lead = {},
                    .facts = {},
                    .plots = {},
                    .notes = {"The picture may be simplified; the answers never are."},
                    .scene = bodies.scene()};
  page.facts = facts_of(page.scene, !answer.is_none());
  if (!page.scene.gaps.empty()) {
    page.tables.push_back(table_of_gaps(page.scene));
  }
  std::ostringstream out;
  const report::Shown shown = run(Work::many, 1, py::none(), [&](const Limits&) {
    return report::write_page(out, page, {.triangles = triangles});
  });
  return py::make_tuple(std::move(out).str(), shown.triangles, shown.triangles_in_all);
}

}  // namespace

void bind_pages(py::module_& module) {
  module.def("_page", &page_of, py::arg("given"), py::arg("answer"), py::arg("poses"),
             py::arg("title"), py::arg("triangles"),
             "_page(given, answer, poses, title, triangles) -> (html, triangles drawn, of how "
             "many)\n\nWhat Page is made of.");
}

}  // namespace soms::python

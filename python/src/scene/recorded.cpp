// What a recording says of bodies and frames.
#include "soms/scene/print.h"

#include "python/src/scene/recordings.h"

namespace soms::python {

namespace {

void bind_recorded_bodies(py::module_& module) {
  AnswerClass<RecordedMesh> mesh(
      module, "RecordedMesh", "How to come by a mesh again, and how to tell that it is the same.");
  mesh.field("name", &RecordedMesh::name, "As the body is called.")
      .field("origin", &RecordedMesh::origin, "RecordedOrigin: a file, or what was generated.")
      .field("source", &RecordedMesh::source, "The path as it was given, or what was generated.")
      .field("file_size", &RecordedMesh::file_size, "Bytes; 0 where there is no file.")
      .field("scale", &RecordedMesh::scale, "Coordinates were multiplied by this,")
      .field("up", &RecordedMesh::up, "UpAxis: and turned to z from this axis.")
      .field("city_triangles", &RecordedMesh::city_triangles, "Arguments of generate for a city,")
      .field("city_size", &RecordedMesh::city_size, "its size in meters,")
      .field("city_seed", &RecordedMesh::city_seed, "and its seed.")
      .field("triangles", &RecordedMesh::triangles, "How many triangles.")
      .field("hash", &RecordedMesh::hash, "Mesh.hash of the mesh, scaled and turned.");
  AnswerClass<RecordedBody> body(module, "RecordedBody", "A part of a recorded environment.");
  body.field("mesh", &RecordedBody::mesh, "RecordedMesh.")
      .field("pose", &RecordedBody::pose, "Pose.");
}

}  // namespace

void bind_recorded(py::module_& module) {
  bind_recorded_bodies(module);
  AnswerClass<RecordedFrame> frame(module, "RecordedFrame", "A frame of a recording.");
  frame.column("poses", &RecordedFrame::poses, "(n, 3, 4) float64: of each mover.")
      .column("environment", &RecordedFrame::environment, "As of StepReport.")
      .column("movers", &RecordedFrame::movers, "As of StepReport.")
      .column("environment_gaps", &RecordedFrame::environment_gaps,
              "As of StepReport; empty without a clearance.")
      .column("mover_gaps", &RecordedFrame::mover_gaps, "Likewise.")
      .column("environment_passages", &RecordedFrame::environment_passages,
              "As of StepReport; empty unless steps are swept.")
      .column("mover_passages", &RecordedFrame::mover_passages, "Likewise.");
  AnswerClass<RecordingEnd> end(module, "RecordingEnd", "What a recording holds in all.");
  end.field("ending", &RecordingEnd::ending, "RecordingEnding.")
      .field("frames", &RecordingEnd::frames, "How many frames.")
      .field("environment_contacts", &RecordingEnd::environment_contacts,
             "Pairs of triangles, summed over frames.")
      .field("mover_contacts", &RecordingEnd::mover_contacts, "Likewise.")
      .field("hash", &RecordingEnd::hash, "FNV-1a 64 over StepReport.hash of each frame.");
}

}  // namespace soms::python

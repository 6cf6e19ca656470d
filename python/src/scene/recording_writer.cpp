// Writing a recording from a scene.
#include "soms/generate/shapes.h"
#include "soms/io/read_mesh.h"
#include "soms/scene/print.h"
#include "soms/scene/recording.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/paths.h"
#include "python/src/scene/recordings.h"
#include "python/src/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace soms::python {

namespace {

constexpr const char* kWriterDoc =
    R"(RecordingWriter(path, scene, *, title='', frames_a_second=60.0, frames=0, clearance=0.0,
swept=False)

Records a scene step by step, to be played by `soms view`, drawn by `soms render` and read by Replay.
Frames are written as they come, so that memory does not grow with them.

    with soms.RecordingWriter("run.somsrec", scene) as recording:
        for poses in all_poses:
            scene.set_poses(poses)
            recording.add(scene.step())

scene: with all its bodies, numbered from 0 on; none may be added or removed until the end. frames: how
many are planned, 0 if unknown. clearance: that of every step. swept: every step is swept, and its passages are
recorded.

A recording refers to models and does not hold them. Each mesh must be what read_mesh reads from the file
Mesh.source, which is checked, or generate("car"), generate("person") or generate("drone"). Write another
mesh with write_mesh and read it again. Leaving the with block finishes the recording, as interrupted
after an exception. One that is not finished is a cut file, which plays up to its last whole chunk.

Raises Error of kind usage, cannot_write, and those of read_mesh.)";

/// A recording that is written, of a scene that stays.
struct HeldWriter {
  std::string path;
  py::object scene;
  std::size_t parts = 0;
  std::size_t movers = 0;
  std::ofstream file;
  std::optional<RecordingWriter> writer;  ///< refers to `file`
  bool is_finished = false;
  std::atomic<bool> is_busy = false;
};

/// True for 0, 1, 2 and so on.
bool counts_from_0(const std::vector<std::uint32_t>& ids) {
  return ids.empty() || ids.back() + std::size_t{1} == ids.size();  // they are ascending
}

/// What `generate` made without further arguments, if it did.
std::optional<RecordedMesh> recorded_mover(const MeshView& mesh, std::uint64_t hash) {
  for (const MoverKind kind : {MoverKind::car, MoverKind::person, MoverKind::drone}) {
    if (mesh.source == "generated " + std::string(name(kind)) &&
        corner_hash(generate_mover(kind)) == hash) {
      RecordedMesh recorded;
      recorded.origin = RecordedMesh::Origin::mover;
      recorded.source = name(kind);
      return recorded;
    }
  }
  return std::nullopt;
}

/// How to come by the mesh of a body again.
/// \errors ErrorKind::usage where it cannot be had again; those of `read_mesh`.
RecordedMesh recorded_mesh(const Body& body, const Limits& limits) {
  const MeshView& mesh = body.shape.mesh();
  const std::uint64_t hash = corner_hash(mesh);
  RecordedMesh recorded;
  if (const auto mover = recorded_mover(mesh, hash)) {
    recorded = *mover;
  } else {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(mesh.source, ignored)) {
      throw usage("recording: a mesh whose source \"" + mesh.source + "\" is not a file",
                  "write it with write_mesh, and add what read_mesh reads");
    }
    const Mesh again = read_mesh(mesh.source, {.allow_empty = true}, limits);
    if (corner_hash(again) != hash) {
      throw usage("recording: a mesh that is not the one in the file " + mesh.source,
                  "write it with write_mesh, and add what read_mesh reads");
    }
    recorded.source = mesh.source;
    recorded.file_size = std::filesystem::file_size(mesh.source, ignored);
  }
  recorded.name = !body.name.empty() ? body.name : recorded.source;
  recorded.triangles = mesh.triangles.size();
  recorded.hash = hash;
  return recorded;
}

/// Adds the bodies of a scene. Movers that share a mesh share a model.
void add_bodies(RecordingHead& head, const Scene& scene, const Limits& limits) {
  std::map<const MeshView*, RecordedMesh> known;
  const auto recorded = [&](const Body& body) {
    const MeshView* const mesh = &body.shape.mesh();
    const auto found = known.find(mesh);
    if (found == known.end()) {
      return known.emplace(mesh, recorded_mesh(body, limits)).first->second;
    }
    RecordedMesh another = found->second;
    another.name = !body.name.empty() ? body.name : another.source;
    return another;
  };
  for (const EnvironmentId id : scene.environments()) {
    const Body& body = scene.environment(id);
    head.environment.push_back({recorded(body), body.pose});
  }
  std::map<const MeshView*, std::uint32_t> models;
  for (const MoverId id : scene.movers()) {
    const Body& body = scene.mover(id);
    const auto [model, is_new] =
        models.try_emplace(&body.shape.mesh(), static_cast<std::uint32_t>(head.models.size()));
    if (is_new) {
      head.models.push_back(recorded(body));
    }
    head.movers.push_back(model->second);
  }
}

void check_numbers(const Scene& scene) {
  if (!counts_from_0(scene.environments()) || !counts_from_0(scene.movers())) {
    throw usage("recording: a scene from which bodies were removed",
                "make a scene of the bodies that are there");
  }
}

std::unique_ptr<HeldWriter> begin_recording(const py::object& path, const py::object& scene,
                                            Text title, double frames_a_second,
                                            std::uint64_t frames, double clearance, bool swept) {
  auto& held = scene.cast<HeldScene&>();
  const SceneUse in_use(held);
  check_numbers(in_use.queried());
  auto writer = std::make_unique<HeldWriter>();
  const std::filesystem::path where = path_of(path);
  writer->path = where.string();
  writer->scene = scene;
  RecordingHead head;
  head.title = std::move(title.bytes);
  head.frames_a_second = frames_a_second;
  head.frames_requested = frames;
  head.clearance = clearance;
  head.swept = swept;
  run(Work::many, 1, py::none(), [&](const Limits& limits) {
    add_bodies(head, in_use.queried(), limits);
    writer->parts = head.environment.size();
    writer->movers = head.movers.size();
    writer->file.open(where, std::ios::binary | std::ios::trunc);
    if (!writer->file) {
      throw Error(ErrorKind::cannot_write, writer->path + ": cannot be written",
                  "give the path of a file in a folder that exists and can be written");
    }
    writer->writer.emplace(writer->file, std::move(head));
    return true;
  });
  return writer;
}

/// The file knows better than the writer which one cannot be written.
template <class Write>
void write(HeldWriter& held, const Write& write_to) {
  if (held.is_finished) {
    throw usage("recording: " + held.path + " is finished", "begin another");
  }
  run(Work::one, 1, py::none(), [&](const Limits&) {
    try {
      write_to(*held.writer);
    } catch (const Error& error) {
      throw error.kind() == ErrorKind::cannot_write
          ? Error(error.kind(), held.path + ": cannot write", error.remedy())
          : error;
    }
    return true;
  });
}

/// \errors ErrorKind::usage for a report of other bodies than those that the recording began with.
void check_bodies(const HeldWriter& held, const Scene& scene, const StepReport& report) {
  bool is_same = scene.environments().size() == held.parts && scene.movers().size() == held.movers;
  const auto of_part = [&](const auto& row) {
    is_same = is_same && row.mover < held.movers && row.part < held.parts;
  };
  const auto of_movers = [&](const auto& row) {
    is_same = is_same && row.a < held.movers && row.b < held.movers;
  };
  std::for_each(report.environment.begin(), report.environment.end(), of_part);
  std::for_each(report.environment_gaps.begin(), report.environment_gaps.end(), of_part);
  std::for_each(report.environment_passages.begin(), report.environment_passages.end(), of_part);
  std::for_each(report.movers.begin(), report.movers.end(), of_movers);
  std::for_each(report.mover_gaps.begin(), report.mover_gaps.end(), of_movers);
  std::for_each(report.mover_passages.begin(), report.mover_passages.end(), of_movers);
  if (!is_same) {
    throw usage("recording: the report is of other bodies",
                "add all bodies before the recording begins, and give reports of its scene");
  }
}

void add_frame(HeldWriter& held, const StepReport& report) {
  const OneCaller caller(held.is_busy, "recording");
  const SceneUse in_use(held.scene.cast<HeldScene&>());
  const Scene& scene = in_use.queried();
  check_bodies(held, scene, report);
  std::vector<Pose> poses;
  for (const MoverId id : scene.movers()) {
    poses.push_back(scene.mover(id).pose);
  }
  write(held, [&](RecordingWriter& writer) { writer.add(poses, report); });
}

void finish(HeldWriter& held, RecordingEnding ending) {
  const OneCaller caller(held.is_busy, "recording");
  write(held, [&](RecordingWriter& writer) {
    writer.finish(ending);
    held.file.close();
    if (!held.file) {
      throw Error(ErrorKind::cannot_write, "", "free some space, or choose another location");
    }
  });
  held.is_finished = true;
}

}  // namespace

void bind_recording_writer(py::module_& module) {
  py::class_<HeldWriter> writer(module, "RecordingWriter", kWriterDoc);
  writer.def(py::init(&begin_recording), py::arg("path"), py::arg("scene"), py::kw_only(),
             py::arg("title") = "", py::arg("frames_a_second") = RecordingHead{}.frames_a_second,
             py::arg("frames") = 0, py::arg("clearance") = 0.0, py::arg("swept") = false);
  writer.def(
      "add", &add_frame, py::arg("report"),
      "add(report)\n\nAdds a frame: the report of a step of the scene, before anything moves. "
      "Raises Error of kind\nusage for a report of other bodies, of another clearance, or of "
      "a step with scope 'first_contact',\nand after a shape was set; cannot_write.");
  writer.def(
      "finish",
      [](HeldWriter& held, const py::object& ending) {
        finish(held, enum_of<RecordingEnding>(ending, "ending"));
      },
      py::arg("ending") = "complete",
      "finish(ending='complete')\n\nWrites the end. ending: 'complete', 'timed_out' or "
      "'interrupted'. Raises Error of kind\ncannot_write.");
  writer.def_property_readonly(
      "so_far",
      [](HeldWriter& held) {
        const OneCaller caller(held.is_busy, "recording");
        return held.writer->so_far();
      },
      "RecordingEnd: what it holds so far.");
  writer.def("__enter__", [](const py::object& self) { return self; });
  writer.def("__exit__", [](HeldWriter& held, const py::object& type, const py::object&,
                            const py::object&) {
    if (!held.is_finished) {
      finish(held, type.is_none() ? RecordingEnding::complete : RecordingEnding::interrupted);
    }
  });
  writer.def("__repr__", [](const HeldWriter& held) {
    return Text{"RecordingWriter{" + held.path + ", " + std::to_string(held.movers) + " movers" +
                (held.is_finished ? ", finished}" : "}")};
  });
}

}  // namespace soms::python

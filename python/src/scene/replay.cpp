// Reading a recording.
#include "soms/scene/replay.h"

#include "python/src/answer.h"
#include "python/src/call.h"
#include "python/src/one_caller.h"
#include "python/src/paths.h"
#include "python/src/scene/recordings.h"

#include <pybind11/stl.h>

#include <memory>
#include <sstream>
#include <string>

namespace soms::python {

namespace {

constexpr const char* kReplayDoc = R"(Replay(file, *, name='', progress=None)

A recording that is open for playing: replay[i] is frame i, len(replay) the number of whole frames.

file: a path, or bytes, for which name stands in errors. The file is read once and checked whole, in
bounded memory. Where it is cut off or altered, frames before that place play, and fault says why.

For one thread at a time. Raises Error of kind cannot_open, bad_file (not even its head is whole, or no
recording), unsupported.
Cost: the next frame is read alone; another, up to 64 frames.)";

struct HeldReplay {
  explicit HeldReplay(Replay opened) : replay(std::move(opened)) {}

  Replay replay;
  std::atomic<bool> is_busy = false;
};

std::unique_ptr<HeldReplay> open_replay(const py::object& file, const std::string& name,
                                        const py::object& progress) {
  if (PyObject_CheckBuffer(file.ptr()) != 0) {
    const std::vector<std::byte> bytes = bytes_of(file);
    auto stream = std::make_unique<std::istringstream>(
        std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    return run(Work::many, 1, progress, [&](const Limits& limits) {
      return std::make_unique<HeldReplay>(
          Replay(std::move(stream), name.empty() ? "bytes" : name, limits));
    });
  }
  const std::filesystem::path path = path_of(file);
  return run(Work::many, 1, progress, [&](const Limits& limits) {
    return std::make_unique<HeldReplay>(Replay(path, limits));
  });
}

RecordedFrame frame_of(HeldReplay& held, py::ssize_t number) {
  const OneCaller caller(held.is_busy, "replay");
  const auto count = static_cast<py::ssize_t>(held.replay.frames());
  const py::ssize_t from_0 = number < 0 ? number + count : number;
  if (from_0 < 0 || from_0 >= count) {
    throw py::index_error("frame " + std::to_string(number) + " of " + std::to_string(count));
  }
  return run(Work::one, 1, py::none(),
             [&](const Limits&) { return held.replay.frame(static_cast<std::uint64_t>(from_0)); });
}

void bind_head(py::class_<HeldReplay>& replay) {
  const auto head = [&replay](const char* name, auto place, const char* doc) {
    replay.def_property_readonly(
        name, [place](const HeldReplay& held) { return held.replay.head().*place; }, doc);
  };
  replay.def_property_readonly(
      "title", [](const HeldReplay& held) { return Text{held.replay.head().title}; }, "Its title.");
  head("frames_a_second", &RecordingHead::frames_a_second, "Frames in a second of its time.");
  head("frames_requested", &RecordingHead::frames_requested, "As many were planned.");
  head("clearance", &RecordingHead::clearance, "That of every step; 0: frames have no gaps.");
  head("swept", &RecordingHead::swept, "Frames hold the passages of swept steps.");
  head("environment", &RecordingHead::environment, "A list of RecordedBody, by number.");
  head("models", &RecordingHead::models, "A list of RecordedMesh, of movers.");
  replay.def_property_readonly(
      "movers",
      [](const py::object& self) {
        return column_of(self.cast<const HeldReplay&>().replay.head().movers, self);
      },
      "(n,) uint32: the model of each mover.");
}

}  // namespace

void bind_recordings(py::module_& module) {
  bind_recorded(module);
  bind_recording_writer(module);
  bind_replay(module);
}

void bind_replay(py::module_& module) {
  py::class_<HeldReplay> replay(module, "Replay", kReplayDoc);
  replay.def(py::init(&open_replay), py::arg("file"), py::kw_only(), py::arg("name") = "",
             py::arg("progress") = py::none());
  bind_head(replay);
  replay.def("__len__", [](const HeldReplay& held) { return held.replay.frames(); });
  replay.def("__getitem__", &frame_of, py::arg("number"),
             "RecordedFrame: of that number; from the end if it is negative.");
  replay.def_property_readonly(
      "end", [](const HeldReplay& held) { return held.replay.end(); },
      "RecordingEnd, as the recording states; None where there is a fault.");
  replay.def_property_readonly(
      "fault",
      [](const HeldReplay& held) {
        return held.replay.fault() ? error_object(*held.replay.fault()) : py::none();
      },
      "Error: why the recording does not go on after its frames; None where it is whole.");
  replay.def("__repr__", [](const HeldReplay& held) {
    return "Replay{" + std::to_string(held.replay.frames()) + " frames of " +
           std::to_string(held.replay.head().movers.size()) + " movers}";
  });
}

}  // namespace soms::python

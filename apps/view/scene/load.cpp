#include "apps/view/scene/load.h"

#include "soms/base/error.h"
#include "soms/io/read_mesh.h"

#include "apps/model/models.h"
#include "apps/model/part_filter.h"
#include "apps/model/stated_options.h"
#include "apps/world/recorded_world.h"
#include "apps/world/route_notes.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace soms::view {

SceneContent content_of(command::World world) {
  SceneContent content;
  content.frames = command::frames_of_routes(world, content.frames);
  content.title = std::move(world.title);
  content.city = std::move(world.city);
  content.numbers = {std::move(world.numbers), std::move(world.vertices)};
  content.notes = std::move(world.notes);
  content.warnings = std::move(world.warnings);
  content.georeference = std::move(world.georeference);
  for (command::MoverRoute& mover_route : world.routes) {
    const command::Model& model = world.models[mover_route.model];
    const auto shared = std::make_shared<const command::MoverRoute>(std::move(mover_route));
    content.movers.push_back({Body(model.shape, shared->at(0), model.name),
                              [shared](std::uint64_t frame) { return shared->at(frame); }});
  }
  if (content.movers.size() < world.requested) {
    content.notes.push_back(std::to_string(world.requested - content.movers.size()) +
                            " movers found no free place and were left out");
  }
  return content;
}

SceneContent content_of(command::World world, Replay recording) {
  const RecordingHead& head = recording.head();
  if (head.movers.size() != world.routes.size() || head.environment.size() != world.city.size()) {
    throw Error(ErrorKind::usage, "the recording is of other bodies",
                "load the world that the recording's head describes");
  }
  SceneContent content = content_of(std::move(world));
  for (MovingBody& mover : content.movers) {
    mover.motion = {};
  }
  if (recording.frames() == 0) {
    content.movers.clear();  // nobody knows where they were
  }
  if (recording.fault()) {
    content.notes.push_back("only " + std::to_string(recording.frames()) +
                            " frames can be read: " + recording.fault()->what());
  }
  content.recording = std::make_shared<Replay>(std::move(recording));
  return content;
}

SceneContent load_recording(const std::filesystem::path& path, const command::WorldOptions& options,
                            command::Console& console) {
  if (!options.movers.empty() || !options.routes.empty() || options.count) {
    throw Error(ErrorKind::usage, path.string() + ": a recording has its own movers",
                "leave out --mover, --route and --count");
  }
  if (options.city_model.parts && options.city_model.parts->is_given()) {
    throw Error(ErrorKind::usage,
                fmt::format("{} has no effect: {} is a recording, which names whole models",
                            options.city_model.parts->options(), path.string()),
                "leave it out");
  }
  for (const command::ModelOptions& model : {options.city_model, options.mover_model}) {
    if (model.scale_is_given || model.up != UpAxis::unknown) {
      throw Error(ErrorKind::usage, path.string() + ": a recording has its own scale and axes",
                  "leave out --scale, --up, --mover-scale and --mover-up");
    }
  }
  Replay recording = console.run("reading " + path.string(),
                                 [&](const Limits& limits) { return Replay(path, limits); });
  command::World world = command::load_recorded_world(recording.head(), path, options, console);
  return content_of(std::move(world), std::move(recording));
}

SceneContent two_bodies(Body still, Body moving) {
  SceneContent content;
  content.title = still.name;
  content.city.push_back(std::move(still));
  content.movers.push_back({std::move(moving), {}});
  return content;
}

DroppedBody read_body(const std::filesystem::path& path, const Limits& limits) {
  Mesh mesh = read_mesh(path, {}, limits);
  const MeshView one = mesh;
  std::vector<std::string> notes = command::notes_of({&one, 1});
  const UpAxis up = mesh.up;
  if (up == UpAxis::x || up == UpAxis::y) {
    notes.push_back(fmt::format("{}: the up axis is {}; rotated to z", path.string(),
                                command::axis_letter(up)));
    mesh = transformed(std::move(mesh), 1, up);
  }
  if (mesh.unit > 0 && !same_unit(mesh.unit, 1)) {
    notes.push_back(
        fmt::format("{}: the unit is {:.9g} m; assuming meters", path.string(), mesh.unit));
  }
  return {Body(Shape(std::move(mesh), {}, limits), {}, command::short_name(path.string())),
          std::move(notes)};
}

}  // namespace soms::view

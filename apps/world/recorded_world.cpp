#include "apps/world/recorded_world.h"

#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "apps/cli/text.h"
#include "apps/model/models.h"

#include <fmt/format.h>

#include <array>
#include <system_error>
#include <utility>

namespace soms::command {

namespace {

RecordedMesh with_mesh(RecordedMesh origin, const MeshView& mesh) {
  origin.triangles = mesh.triangles.size();
  origin.hash = corner_hash(mesh);
  return origin;
}

/// The first place where the file is.
/// \errors ErrorKind::cannot_open where it is at none; bad_file for what no recording can name: a
/// pipe, which could block for ever.
std::filesystem::path find_file(const std::string& source, const std::filesystem::path& recording) {
  std::filesystem::path given(source);
  const std::filesystem::path folder = recording.parent_path();
  for (const auto& path : {given, folder / given, folder / given.filename()}) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
      return path == "-" ? "./-" : path;  // "-" alone is standard input
    }
  }
  std::error_code ignored;
  if (source.empty() || source == "-" || std::filesystem::exists(given, ignored)) {
    throw Error(ErrorKind::bad_file,
                fmt::format("it refers to the model \"{}\", which is not a file", source),
                "record it again with models from files");
  }
  throw Error(ErrorKind::cannot_open,
              fmt::format("the recorded model {} is neither at that path nor at {}", source,
                          (folder / given.filename()).string()),
              "put the file beside the recording");
}

Kind kind_named(const RecordedMesh& recorded) {
  if (recorded.origin != RecordedMesh::Origin::mover) {
    return Kind::model;
  }
  return recorded.source == "person"  ? Kind::person
         : recorded.source == "drone" ? Kind::drone
                                      : Kind::car;
}

MoverKind mover_named(const RecordedMesh& recorded) {
  constexpr std::array kKinds{std::pair("car", MoverKind::car),
                              std::pair("person", MoverKind::person),
                              std::pair("drone", MoverKind::drone)};
  for (const auto& [name, kind] : kKinds) {
    if (recorded.source == name) {
      return kind;
    }
  }
  throw Error(ErrorKind::bad_file, fmt::format("an unknown mover: {}", recorded.source),
              "movers are car, person and drone");
}

/// The city of a recording, once it is plain that it can be the one that was recorded.
Mesh make_city(const RecordedMesh& recorded, const Limits& limits) {
  const auto refuse = [](const std::string& fault) {
    throw Error(ErrorKind::bad_file, "an invalid city: " + fault, "record again");
  };
  if (recorded.city_triangles != recorded.triangles) {
    refuse(fmt::format("{}, made of {}", counted(recorded.triangles, "triangle"),
                       with_commas(recorded.city_triangles)));
  }
  City city;
  try {
    city = generate_city({.triangles = recorded.city_triangles,
                          .size = recorded.city_size,
                          .seed = recorded.city_seed},
                         limits);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::usage) {
      throw;
    }
    refuse(error.place());
  }
  return transformed(std::move(city.mesh), recorded.scale, recorded.up);
}

Mesh find_mesh(const RecordedMesh& recorded, const std::filesystem::path& recording, bool strict,
               Console& console) {
  switch (recorded.origin) {
    case RecordedMesh::Origin::city:
      return console.run("making " + recorded.name,
                         [&](const Limits& limits) { return make_city(recorded, limits); });
    case RecordedMesh::Origin::mover:
      return transformed(generate_mover(mover_named(recorded)), recorded.scale, recorded.up);
    case RecordedMesh::Origin::file:
      break;
  }
  return read_model(
      find_file(recorded.source, recording).string(),
      {.scale = recorded.scale, .up = recorded.up, .strict = strict, .allow_empty = true}, console);
}

/// The mesh that was recorded, to the last bit of its corners.
Shape find_same_shape(const RecordedMesh& recorded, const std::filesystem::path& recording,
                      const WorldOptions& how, Console& console) {
  Mesh mesh = find_mesh(recorded, recording, how.city_model.strict, console);
  const RecordedMesh found = with_mesh(recorded, mesh);
  if (found != recorded) {
    throw Error(ErrorKind::bad_file,
                fmt::format("{}: not the model that was recorded: it has {} and hash {:016x}, the "
                            "recording has {} and hash {:016x}",
                            recorded.source, counted(found.triangles, "triangle"), found.hash,
                            counted(recorded.triangles, "triangle"), recorded.hash),
                "put the original file beside the recording, or record it again");
  }
  return build_shape(std::move(mesh), {.build = how.build, .keep_tree = how.keep_trees}, console);
}

/// The same; its errors name the recording, and the mesh in it, as "model 1", first.
Shape find_shape(const RecordedMesh& recorded, const std::string& place,
                 const std::filesystem::path& recording, const WorldOptions& how,
                 Console& console) {
  try {
    return find_same_shape(recorded, recording, how, console);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) {
      throw;
    }
    throw Error(error.kind(), fmt::format("{}, {}: {}", recording.string(), place, error.place()),
                error.remedy());
  }
}

}  // namespace

RecordingHead recording_head(const World& world, std::uint64_t frames, double clearance,
                             bool swept) {
  RecordingHead head;
  head.title = world.title;
  head.frames_a_second = kFramesASecond;
  head.frames_requested = frames;
  head.clearance = clearance;
  head.swept = swept;
  for (std::size_t k = 0; k < world.city.size(); ++k) {
    const Body& body = world.city[k];
    head.environment.push_back({with_mesh(world.origins[k], body.shape.mesh()), body.pose});
  }
  for (const Model& model : world.models) {
    head.models.push_back(with_mesh(model.origin, model.shape.mesh()));
  }
  for (const MoverRoute& mover_route : world.routes) {
    head.movers.push_back(static_cast<std::uint32_t>(mover_route.model));
  }
  return head;
}

World load_recorded_world(const RecordingHead& head, const std::filesystem::path& recording,
                          const WorldOptions& how, Console& console) {
  World world;
  world.title = head.title;
  for (const RecordedBody& body : head.environment) {
    const std::string place = fmt::format("environment {}", world.city.size());
    add_to_city(
        world,
        Body(find_shape(body.mesh, place, recording, how, console), body.pose, body.mesh.name),
        body.mesh);
  }
  for (const RecordedMesh& mesh : head.models) {
    const std::string place = fmt::format("model {}", world.models.size());
    world.models.push_back(
        make_model(find_shape(mesh, place, recording, how, console), mesh.name, kind_named(mesh)));
    world.models.back().origin = mesh;
  }
  for (const std::uint32_t model : head.movers) {
    world.routes.emplace_back().model = model;
  }
  world.requested = world.routes.size();
  return world;
}

}  // namespace soms::command

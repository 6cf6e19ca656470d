#include "apps/support/world.h"

#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "apps/support/models.h"
#include "apps/support/ways.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <utility>

namespace soms::command {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Reads a model and turns the up axis that its file states to z, unless `option` named one.
Mesh read_upright(const std::string& path, const ModelOptions& options, const std::string& option,
                  Console& console) {
  Mesh mesh = read_model(path, options, console);
  if (options.up != UpAxis::unknown || (mesh.up != UpAxis::x && mesh.up != UpAxis::y)) {
    return mesh;
  }
  console.note(fmt::format("{}: its up axis is {}; turned to z ({} z leaves it)", path,
                           mesh.up == UpAxis::x ? "x" : "y", option));
  const UpAxis up = mesh.up;
  return transformed(std::move(mesh), 1, up);
}

/// A car is as fast as a town allows; what comes from files is taken for one.
double speed_of(Kind kind) {
  constexpr double kTown = 50 / 3.6;
  return kind == Kind::person ? 1.4 : kind == Kind::drone ? 10 : kTown;
}

Model make_model(Mesh mesh, std::string name, Kind kind, Console& console) {
  Model model;
  model.shape = console.run("building " + name, [&](const Parallel& parallel) {
    return Shape(std::move(mesh), {}, parallel);
  });
  model.name = std::move(name);
  model.kind = kind;
  const Box& box = model.shape.bounds();
  const Vec3 extent = box.extent();
  const Vec3 center = box.center();
  model.foot = {center.x, center.y, box.lower.z};
  model.reach = 0.5 * std::hypot(extent.x, extent.y);
  model.height = extent.z;
  model.speed = speed_of(kind);
  return model;
}

std::vector<Model> load_models(const WorldOptions& options, Console& console) {
  std::vector<Model> models;
  if (options.movers.empty()) {
    for (const auto& [kind, shape, name] : {std::tuple(Kind::car, MoverKind::car, "car"),
                                            std::tuple(Kind::person, MoverKind::person, "person"),
                                            std::tuple(Kind::drone, MoverKind::drone, "drone")}) {
      models.push_back(make_model(
          transformed(generate_mover(shape), options.mover_model.scale, options.mover_model.up),
          name, kind, console));
    }
  }
  for (const std::string& path : options.movers) {
    models.push_back(make_model(read_upright(path, options.mover_model, "--mover-up", console),
                                short_name(path), Kind::model, console));
    const Model& model = models.back();
    const double size = std::max(2 * model.reach, model.height);
    if (size > 30 || size < 0.05) {
      console.note(
          fmt::format("{}: {:.4g} across, taken as meters; --mover-scale changes it", path, size));
    }
  }
  return models;
}

void add_to_city(World& world, Mesh mesh, const std::string& name, Console& console) {
  const auto begin = Clock::now();
  Shape shape = console.run("building " + name, [&](const Parallel& parallel) {
    return Shape(std::move(mesh), {}, parallel);
  });
  world.build_ms += milliseconds_since(begin);
  world.triangles += shape.mesh().triangles.size();
  world.bounds.grow(shape.bounds());
  world.city.emplace_back(std::move(shape), Pose{}, name);
}

std::optional<City> load_city(World& world, const WorldOptions& options, Console& console) {
  const auto begin = Clock::now();
  if (options.cities.empty()) {
    City city = generate_city();
    Mesh mesh = std::exchange(city.mesh, {});
    world.read_ms = milliseconds_since(begin);
    world.title = "embedded city";
    if (options.city_model.scale != 1 || options.city_model.up != UpAxis::unknown) {
      throw Error(ErrorKind::usage, "--scale and --up are for a city from files",
                  "name a city, or leave them out");
    }
    add_to_city(world, std::move(mesh), world.title, console);
    return city;
  }
  for (const std::string& path : options.cities) {
    const auto start = Clock::now();
    Mesh mesh = read_upright(path, options.city_model, "--up", console);
    world.read_ms += milliseconds_since(start);
    world.title += (world.title.empty() ? "" : " + ") + short_name(path);
    add_to_city(world, std::move(mesh), short_name(path), console);
  }
  return std::nullopt;
}

}  // namespace

std::string short_name(const std::string& path) {
  const std::string stem = std::filesystem::path(path).stem().string();
  return stem.empty() ? path : stem;
}

Scene make_scene(const World& world) {
  Scene scene;
  for (const Body& body : world.city) {
    scene.add_environment(body);
  }
  for (const Way& way : world.ways) {
    const Model& model = world.models[way.model];
    scene.add_mover(Body(model.shape, way.at(0), model.name));
  }
  return scene;
}

std::string part_name(const World& world, EnvironmentId part, TriangleId triangle) {
  const Body& body = world.city[part];
  const std::string name = part_name(body.shape.mesh(), triangle);
  return name.empty() ? body.name : name;
}

World load_world(const WorldOptions& options, Console& console) {
  World world;
  world.models = load_models(options, console);
  const std::optional<City> city = load_city(world, options, console);
  plan_ways(world, options, city ? &*city : nullptr, console);
  return world;
}

}  // namespace soms::command

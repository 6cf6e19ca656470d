#include "apps/world/world.h"

#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"

#include "apps/cli/standard_input.h"
#include "apps/model/georeference.h"
#include "apps/model/models.h"
#include "apps/model/part_filter.h"
#include "apps/model/stated_options.h"
#include "apps/model/up_guess.h"
#include "apps/world/mover_routes.h"
#include "apps/world/route_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <utility>

namespace soms::command {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kEndless = std::numeric_limits<double>::infinity();

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// A mesh and how to come by it again.
struct Upright {
  Mesh mesh;
  RecordedMesh origin;
  NamedFrame frame = {};
};

/// What soms makes itself: in meters, z up.
NamedFrame built_in_frame(const std::string& name, const MeshView& mesh) {
  return {.file = name,
          .frame = frame_of(mesh),
          .scale_option = "--mover-scale",
          .up_option = "--mover-up",
          .built_in = true,
          .in_meters = true};
}

/// What files are to a world, and the options that say more of them than they do.
struct Role {
  const ModelOptions& options;
  std::string scale_option;
  std::string up_option;
  bool is_shared;         ///< the options go to several files
  bool is_mover = false;  ///< on a route, not where its file places it
  bool guess_up = false;  ///< turn a model whose file names no axis as it looks
};

/// Adds to what reading noted, and says it.
void note(Mesh& mesh, const std::string& text, const Console& console) {
  mesh.notes.push_back(text);
  console.note(mesh.source + ": " + text);
}

/// Lengths are taken for meters: says so of a unit that differs and that no option deals with.
void note_unit(Mesh& mesh, const Role& role, const Console& console) {
  if (role.options.scale_is_given || !(mesh.unit > 0) || same_unit(mesh.unit, 1)) {
    return;
  }
  const std::string remedy =
      role.is_shared ? fmt::format("soms convert {} OUT.glb", mesh.source) : "";
  note(mesh,
       fmt::format("the unit is {0:.9g} m; assuming meters ({1}{2} {0:.9g} converts it)", mesh.unit,
                   role.is_shared ? remedy + " " : "",
                   role.is_shared ? "--scale" : role.scale_option),
       console);
}

/// Of a mover of unknown unit: says how large it is where that is no usual size in meters.
void note_size(Mesh& mesh, const Role& role, const Console& console) {
  const Vec3 extent = bounds(mesh).extent();
  const double size = std::max(std::hypot(extent.x, extent.y), extent.z);
  if (mesh.unit > 0 || role.options.scale_is_given || (size <= 30 && size >= 0.05)) {
    return;
  }
  note(mesh, fmt::format("{:.4g} across, assuming meters; {} rescales it", size, role.scale_option),
       console);
}

/// True if a model whose axis nobody named looks y up.
bool may_lie(const Mesh& mesh, const ModelOptions& options) {
  return options.up == UpAxis::unknown && mesh.up == UpAxis::unknown && looks_y_up(mesh);
}

/// Turns the up axis that a model's file states to z, unless an option named one.
Upright made_upright(Mesh mesh, const std::string& path, const Role& role, Console& console) {
  const ModelOptions& options = role.options;
  Upright model{
      .mesh = std::move(mesh),
      .origin = {
          .name = short_name(path), .source = path, .scale = options.scale, .up = options.up}};
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  model.origin.file_size = unknown ? 0 : size;
  const UpAxis up = model.mesh.up;
  if (options.up == UpAxis::unknown && (up == UpAxis::x || up == UpAxis::y)) {
    model.mesh = transformed(std::move(model.mesh), 1, up);
    model.origin.up = up;
    note(model.mesh,
         fmt::format("the up axis is {}; rotated to z (give {} z to keep it)", axis_letter(up),
                     role.up_option),
         console);
  }
  if (up == UpAxis::unknown && may_lie(model.mesh, options)) {
    if (role.guess_up) {
      model.mesh = transformed(std::move(model.mesh), 1, UpAxis::y);
      model.origin.up = UpAxis::y;
    }
    note(model.mesh,
         role.guess_up
             ? fmt::format("looks y up, and is drawn so: the file names no axis ({} z keeps it)",
                           role.up_option)
             : fmt::format("looks y up; assuming z up, as the file names no axis ({} y rotates it)",
                           role.up_option),
         console);
  }
  note_unit(model.mesh, role, console);
  model.frame = named_frame(model.mesh, options, role.scale_option, role.up_option);
  model.frame.is_shared = role.is_shared;
  model.frame.is_posed = role.is_mover;
  model.frame.in_meters = true;
  return model;
}

Upright read_upright(const std::string& path, const Role& role, Console& console) {
  return made_upright(read_model(path, role.options, console), path, role, console);
}

/// What was read of a city of two, to see whether both models look y up: a pair is turned as one.
struct PairLooked {
  std::vector<Mesh> meshes;  ///< the first ones, as many as that took
  bool both_lie = false;
};

PairLooked look_at_pair(const WorldOptions& options, Console& console) {
  PairLooked looked;
  if (!options.guess_up || options.cities.size() != 2) {
    return looked;
  }
  for (const std::string& path : options.cities) {
    looked.meshes.push_back(read_model(path, options.city_model, console));
    if (!may_lie(looked.meshes.back(), options.city_model)) {
      return looked;
    }
  }
  looked.both_lie = true;
  return looked;
}

Shape build_named(Mesh mesh, const std::string& name, const WorldOptions& options,
                  Console& console) {
  const ShapeOptions shape{.build = options.build, .keep_tree = options.keep_trees};
  return console.run("building " + name,
                     [&](const Limits& limits) { return Shape(std::move(mesh), shape, limits); });
}

/// A car is as fast as a town allows; what comes from files is taken for one.
double speed_of(Kind kind) {
  constexpr double kTown = 50 / 3.6;
  return kind == Kind::person ? 1.4 : kind == Kind::drone ? 10 : kTown;
}

/// Reads or makes the models that move; adds a frame for each to `frames`.
std::vector<Model> load_models(const WorldOptions& options, std::vector<NamedFrame>& frames,
                               Console& console) {
  std::vector<Model> models;
  if (options.movers.empty()) {
    for (const auto& [kind, shape, name] : {std::tuple(Kind::car, MoverKind::car, "car"),
                                            std::tuple(Kind::person, MoverKind::person, "person"),
                                            std::tuple(Kind::drone, MoverKind::drone, "drone")}) {
      const ModelOptions& changes = options.mover_model;
      Mesh mesh = transformed(generate_mover(shape), changes.scale, changes.up);
      if (frames.empty()) {  // one for the three, which are alike
        frames.push_back(built_in_frame("the built-in movers", mesh));
        frames.back().frame.unit_is_stated = changes.scale_is_given;
      }
      models.push_back(
          make_model(build_named(std::move(mesh), name, options, console), name, kind));
      models.back().origin = {.name = name,
                              .origin = RecordedMesh::Origin::mover,
                              .source = name,
                              .scale = changes.scale,
                              .up = changes.up};
    }
  }
  const Role role{
      options.mover_model,   "--mover-scale", "--mover-up", options.movers.size() > 1, true,
      options.guess_mover_up};
  for (const std::string& path : options.movers) {
    Upright read = read_upright(path, role, console);
    note_size(read.mesh, role, console);
    frames.push_back(read.frame);
    const std::string name = short_name(path);
    models.push_back(
        make_model(build_named(std::move(read.mesh), name, options, console), name, Kind::model));
    models.back().origin = std::move(read.origin);
  }
  return models;
}

/// Says which movers of files are larger than the whole city, which is rarely meant. Whoever gave
/// their scale knows.
void note_large_movers(World& world, const Console& console) {
  const auto longest = [](const Box& box) {
    const Vec3 extent = box.extent();
    return std::max({extent.x, extent.y, extent.z});
  };
  const double city = world.bounds.empty() ? kEndless : longest(world.bounds);
  for (const Model& model : world.models) {
    const double mover = longest(model.shape.bounds());
    if (model.kind == Kind::model && mover > city) {
      world.notes.push_back(
          fmt::format("{}: {:.4g} long, larger than the city ({:.4g}); --mover-scale rescales it",
                      model.origin.source, mover, city));
      console.note(world.notes.back());
    }
  }
}

void build_into_city(World& world, Upright model, const WorldOptions& options, Console& console) {
  FileNumbers numbers;
  FileNumbers vertices;
  if (PartFilter* const parts = options.city_model.parts.get()) {
    if (std::optional<PartsLeft> rest = parts->left_of(model.mesh)) {
      model.mesh = std::move(rest->mesh);
      numbers = FileNumbers(std::move(rest->numbers));
      vertices = FileNumbers(std::move(rest->vertices));
    }
  }
  const auto begin = Clock::now();
  Shape shape = build_named(std::move(model.mesh), model.origin.name, options, console);
  world.build_ms += milliseconds_since(begin);
  Body body(std::move(shape), Pose{}, model.origin.name);
  add_to_city(world, std::move(body), std::move(model.origin), std::move(numbers),
              std::move(vertices));
}

/// Reads or makes the city; adds the frame of each of its models to `frames`.
std::optional<City> load_city(World& world, const WorldOptions& options,
                              std::vector<NamedFrame>& frames, Console& console) {
  const auto begin = Clock::now();
  if (options.cities.empty()) {
    City city = generate_city();
    Mesh mesh = std::exchange(city.mesh, {});
    world.read_ms = milliseconds_since(begin);
    world.title = "embedded city";
    frames.push_back(built_in_frame("the embedded city", mesh));
    if (options.city_model.scale_is_given || options.city_model.up != UpAxis::unknown ||
        !options.city_model.crs.empty()) {
      throw Error(ErrorKind::usage, "--scale, --up and --crs need a city from files",
                  "give the file of a city, or leave them out");
    }
    build_into_city(world,
                    {std::move(mesh),
                     {.name = world.title,
                      .origin = RecordedMesh::Origin::city,
                      .source = "city",
                      .city_triangles = city.options.triangles,
                      .city_size = city.options.size,
                      .city_seed = city.options.seed}},
                    options, console);
    return city;
  }
  const bool shared = options.cities.size() > 1;
  PairLooked looked = look_at_pair(options, console);
  world.read_ms = milliseconds_since(begin);
  const Role role{options.city_model,
                  "--scale",
                  "--up",
                  shared,
                  false,
                  options.guess_up && (!shared || looked.both_lie)};
  for (std::size_t k = 0; k < options.cities.size(); ++k) {
    const std::string& path = options.cities[k];
    const auto start = Clock::now();
    Mesh mesh = k < looked.meshes.size() ? std::move(looked.meshes[k])
                                         : read_model(path, role.options, console);
    Upright model = made_upright(std::move(mesh), path, role, console);
    frames.push_back(model.frame);
    world.read_ms += milliseconds_since(start);
    world.title += (world.title.empty() ? "" : " + ") + short_name(path);
    build_into_city(world, std::move(model), options, console);
  }
  return std::nullopt;
}

}  // namespace

void check_count(const WorldOptions& options) {
  for (const auto& [option, named] :
       {std::pair("--route", options.routes.size()), std::pair("--mover", options.movers.size())}) {
    if (options.count && *options.count < named) {
      throw Error(ErrorKind::usage,
                  fmt::format("--count {} leaves {} of {} {} without a mover", *options.count,
                              named - *options.count, named, option),
                  fmt::format("give --count {} or more, or fewer {}", named, option));
    }
  }
}

void add_to_city(World& world, Body body, RecordedMesh origin, FileNumbers numbers,
                 FileNumbers vertices) {
  world.triangles += body.shape.mesh().triangles.size();
  world.bounds.grow(body.shape.bounds());
  world.city.push_back(std::move(body));
  world.origins.push_back(std::move(origin));
  world.numbers.push_back(std::move(numbers));
  world.vertices.push_back(std::move(vertices));
}

Model make_model(Shape shape, std::string name, Kind kind) {
  Model model;
  model.shape = std::move(shape);
  model.name = std::move(name);
  model.kind = kind;
  const Box& box = model.shape.bounds();
  const Vec3 extent = box.extent();
  const Vec3 center = box.center();
  model.foot = {center.x, center.y, box.lower.z};
  model.ground_radius = 0.5 * std::hypot(extent.x, extent.y);
  model.height = extent.z;
  model.speed = speed_of(kind);
  return model;
}

const std::string& model_name(const World& world, MoverId mover) {
  return world.models[world.routes[mover].model].name;
}

std::string mover_name(const World& world, MoverId mover) {
  return model_name(world, mover) + " " + std::to_string(mover);
}

std::string short_name(const std::string& path) {
  if (path == "-") {
    return std::string(kStandardInputName);
  }
  const std::string stem = std::filesystem::path(path).stem().string();
  return stem.empty() ? path : stem;
}

Scene make_scene(const World& world, const Limits& limits) {
  Scene scene;
  for (const Body& body : world.city) {
    scene.add_environment(body);
  }
  for (const MoverRoute& mover_route : world.routes) {
    const Model& model = world.models[mover_route.model];
    check_stop(limits);
    scene.add_mover(Body(model.shape, mover_route.at(0), model.name));
  }
  for (const auto& [a, b] : world.filter.ignored) {
    scene.ignore(a, b);
  }
  return scene;
}

std::string part_name(const World& world, EnvironmentId part, TriangleId triangle) {
  const Body& body = world.city[part];
  const std::string name = part_name(body.shape.mesh(), triangle);
  return name.empty() ? body.name : name;
}

CityParts::CityParts(const World& world) : world_(world) {
  for (const Body& body : world.city) {
    parts_.emplace_back(body.shape.mesh());
  }
}

std::string CityParts::name(EnvironmentId part, TriangleId triangle) const {
  return part_name(part, number(part, triangle));
}

std::uint32_t CityParts::number(EnvironmentId body, TriangleId triangle) const {
  return parts_[body](triangle);
}

std::string CityParts::part_name(EnvironmentId body, std::uint32_t number) const {
  std::string name = part_named(world_.city[body].shape.mesh(), number);
  return name.empty() ? world_.city[body].name : name;
}

World load_world(const WorldOptions& options, Console& console) {
  std::ptrdiff_t inputs = 0;
  for (const auto* const names : {&options.cities, &options.movers, &options.routes}) {
    inputs += std::count(names->begin(), names->end(), "-");
  }
  if (inputs > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  World world;
  std::vector<NamedFrame> city_frames;
  std::vector<NamedFrame> mover_frames;
  world.models = load_models(options, mover_frames, console);
  const std::optional<City> city = load_city(world, options, city_frames, console);
  if (options.city_model.parts) {
    options.city_model.parts->finish(console);
  }
  std::vector<MeshView> meshes;
  for (const Body& body : world.city) {
    meshes.push_back(body.shape.mesh());
  }
  world.georeference = georeference_of(meshes);
  for (const Model& model : world.models) {
    meshes.push_back(model.shape.mesh());
  }
  world.notes = notes_of(meshes);
  if (options.count.value_or(1) != 0 && !options.mover_model.scale_is_given) {
    note_large_movers(world, console);
  }
  world.warnings = world_warnings(city_frames, mover_frames);
  tell_warnings(world.warnings, options.city_model.strict, console);
  plan_routes(world, options, city ? &*city : nullptr, console);
  note_uneven_routes(world, options.city_model.strict, console);
  return world;
}

}  // namespace soms::command

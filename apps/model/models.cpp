#include "apps/model/models.h"

#include "soms/base/error.h"
#include "soms/io/crs.h"
#include "soms/io/read_mesh.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/tile_set.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/console.h"
#include "apps/cli/kebab.h"
#include "apps/cli/parse.h"
#include "apps/cli/standard_input.h"
#include "apps/model/part_filter.h"
#include "apps/model/stated_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace soms::command {

namespace {

Choices<Rule> rule_choices() {
  Choices<Rule> choices;
  for (const auto& row : rules()) {
    choices.emplace_back(row.kebab, row.rule);
  }
  return choices;
}

/// Shows an option of a second model on the line of that of the first: "--scale,--scale-b X".
void show_with_first(Parser& parser, const std::string& name, const std::string& whose) {
  constexpr std::string_view kSecond = "-b";
  const std::string first_name = name.substr(0, name.size() - kSecond.size());
  if (!name.ends_with(kSecond) || !parser.has_option(first_name)) {
    return;
  }
  Option* const first = parser.option(first_name);
  std::string meaning = first->description();
  if (const std::size_t at = meaning.find(" of A"); at != std::string::npos) {
    meaning.insert(at + 5, " or " + whose);
    parser.option(name)->shown_with(first, std::move(meaning));
  }
}

/// The command's option for a field of the library's options.
std::string option_of(std::string_view field) {
  return field == "level" ? "--levels" : field == "per_leaf" ? "--leaf" : "--" + kebab(field);
}

/// `text` with an option of the command in place of the library's argument.
std::string with_option(std::string text, std::string_view argument, std::string_view option) {
  if (const std::size_t at = text.find(argument); at != std::string::npos) {
    text.replace(at, argument.size(), option);
  }
  return text;
}

/// An error of reading with the options of the command in place of the library's.
Error in_words_of_options(const Error& error, const std::string& path, const ModelOptions& options,
                          const Shared& shared) {
  if (error.kind() == ErrorKind::empty_mesh) {
    return {error.kind(), error.place(),
            options.offers_empty
                ? "give a model with faces, or allow an empty one with --allow-empty"
                : "give a model with faces"};
  }
  if (error.kind() == ErrorKind::usage && (options.lod || options.surfaces)) {
    return {error.kind(), error.place(),
            error.remedy() == "leave lod and surfaces out for it"
                ? "leave --lod and --surfaces out, or convert the model first"
                : error.remedy()};
  }
  if (error.kind() != ErrorKind::out_of_memory) {
    return {error.kind(), error.place(), with_option(error.remedy(), "`strict`", "--strict")};
  }
  // Refused by the reader's own count, or by the system where ours is the least limit.
  return error.remedy().find("max_memory") == std::string::npos
             ? out_of_memory(shared, path)
             : Error(error.kind(), error.place(), "raise --max-memory, or use a smaller model");
}

}  // namespace

void add_model_options(Parser& parser, ModelOptions& options, const std::string& scale_name,
                       const std::string& up_name, const std::string& whose) {
  const char* const group = "Models";
  parser
      .add_option_function(
          scale_name,
          [&options, scale_name](const std::string& text) {
            options.scale = parse_positive(scale_name, text);
            options.scale_is_given = true;
          },
          "multiply the coordinates of " + whose + "; 1 confirms that the unit is right")
      ->option_text("X")
      ->group(group);
  add_choice<UpAxis>(parser, up_name, options.up,
                     {{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}},
                     "up axis of " + whose + ", rotated to z")
      ->group(group);
  if (const std::string crs_name = crs_option(up_name); !crs_name.empty()) {
    parser
        .add_option(
            crs_name, options.crs,
            "coordinate reference system of " + whose + ", such as EPSG:25833; recorded only")
        ->option_text("NAME")
        ->check([](const std::string& text) {
          const bool number = text.find_first_not_of("0123456789 ") == std::string::npos;
          return number ? "give the name of a system, such as EPSG:25833" : std::string();
        })
        ->group(group);
    show_with_first(parser, crs_name, whose);
  }
  show_with_first(parser, scale_name, whose);
  show_with_first(parser, up_name, whose);
}

void add_city_options(Parser& parser, ModelOptions& options, const std::string& suffix,
                      const std::string& whose) {
  add_level(parser, "--lod" + suffix, options.lod,
            "level of detail of " + whose + " (CityJSON): 1.2; default: the most detailed")
      ->group("Models");
  parser
      .add_flag("--surfaces" + suffix, options.surfaces,
                "make each semantic surface of " + whose + " (CityJSON) a part: roof, wall")
      ->group("Models");
}

void add_strict(Parser& parser, bool& strict) {
  parser.add_flag("--strict", strict, kStrictMeaning)->group("Models");
}

void add_allow_empty(Parser& parser, ModelOptions& options) {
  options.offers_empty = true;
  parser.add_flag("--allow-empty", options.allow_empty, "accept a model without triangles")
      ->group("Models");
}

void add_build_options(Parser& parser, BuildOptions& options) {
  const auto grouped = [](Option* option) { option->group(kTreeGroup); };
  grouped(add_choice<Rule>(parser, "--rule", options.rule, rule_choices(),
                           fmt::format("splitting rule ({})", entry(options.rule).kebab)));
  grouped(add_count(parser, "--levels", options.level, 0, 64,
                    fmt::format("maximum number of levels; 0: no limit ({})", options.level)));
  grouped(add_count(parser, "--leaf", options.per_leaf, 1, 1'000'000'000,
                    fmt::format("maximum number of triangles in a leaf ({})", options.per_leaf)));
  grouped(add_choice<Midpoint>(
      parser, "--midpoint", options.midpoint,
      {{"thesis", Midpoint::thesis}, {"centroid", Midpoint::centroid}, {"aabb", Midpoint::aabb}},
      "point that represents a triangle (aabb)"));
  grouped(add_choice<AxisFrom>(parser, "--axis-from", options.axis_from,
                               {{"outer", AxisFrom::outer}, {"inner", AxisFrom::inner}},
                               "box whose longest axis is split (default: set by the rule)"));
  grouped(add_choice<EmptySide>(parser, "--empty-side", options.empty_side,
                                {{"stop", EmptySide::stop},
                                 {"next-axis", EmptySide::next_axis},
                                 {"object-median", EmptySide::object_median},
                                 {"chain", EmptySide::chain}},
                                "action when one side is empty (object-median)"));
  grouped(
      add_count(parser, "--root-level", options.root_level, 0, 1, "level number of the root (1)"));
  grouped(add_count(parser, "--c-vertex", options.c_vertex, 0, 2,
                    "vertex that is C for --midpoint thesis (2)"));
}

void add_tree_list(Parser& parser, BuildOptions& build) {
  add_build_options(parser, build);
  Option* const list = parser.add_list(
      "--tree", fmt::format("options of trees, such as rule={}; --tree help lists them",
                            entry(build.rule).kebab));
  for (const Option* const option : parser.options()) {
    if (option->group() == kTreeGroup) {
      parser.option(option->name())->key_of(list);
    }
  }
  list->group(kTreeGroup);
}

std::vector<std::string> given_of(const Parser& parser, const std::vector<IdleOption>& idle) {
  std::vector<std::string> given;
  for (const IdleOption& option : idle) {
    if (parser.count(option_of(option.name)) > 0) {
      given.push_back(option_of(option.name));
    }
  }
  return given;
}

void refuse_given(const Parser& parser, const std::vector<IdleOption>& idle) {
  for (const IdleOption& option : idle) {
    if (given_of(parser, {option}).empty()) {
      continue;
    }
    const std::string name = option_of(option.name);
    const std::string needs = option_of(option.needs);
    throw Error(ErrorKind::usage, fmt::format("{} has no effect: {}", name, option.reason),
                option.value.empty()
                    ? fmt::format("leave it out, or give another {}", needs)
                    : fmt::format("leave it out, or also give {} {}", needs, kebab(option.value)));
  }
}

void check_build(const Parser& parser, const BuildOptions& options) {
  if (options.empty_side == EmptySide::chain && options.level == 0) {
    throw Error(ErrorKind::usage, "--empty-side chain without --levels never ends",
                "also give --levels N");
  }
  refuse_given(parser, idle_options(options));
  check(options);
}

std::string given_of_trees(const Parser& parser) {
  for (const Option* const option : parser.options()) {
    if (option->group() == kTreeGroup && option->count() > 0) {
      return option->name();
    }
  }
  return {};
}

namespace {

Mesh read_standard_input(const ReadOptions& options, const Limits& limits) {
  check_standard_input("a model");
  try {
    Mesh mesh = read_mesh(kStandardInput, options, limits);
    mesh.source = kStandardInputName;
    return mesh;
  } catch (const Error& error) {
    throw of_standard_input(error);
  }
}

/// What the file says and the command line contradicts: a note, or an error where notes are.
void note_axis(Mesh& mesh, const ModelOptions& options, const std::string& path) {
  if (options.up != UpAxis::unknown && mesh.up != UpAxis::unknown && mesh.up != options.up) {
    const std::string note = fmt::format(
        "the file declares that {} is up, but the command line says that {} is, and is "
        "followed",
        axis_letter(mesh.up), axis_letter(options.up));
    if (options.strict) {
      throw Error(ErrorKind::bad_file, path + ": " + note,
                  fmt::format("name {} if that axis points up; if the file is wrong, correct it "
                              "first: soms convert {} OUT.glb --up {}",
                              axis_letter(mesh.up), path, axis_letter(options.up)));
    }
    mesh.notes.push_back(note);
  }
}

/// The same of georeferences.
void note_georeference(Mesh& mesh, const ModelOptions& options, const std::string& path) {
  const Georeference stated{.crs = crs_name(options.crs)};
  if (crs_axes(stated.crs).angles && !crs_axes(mesh.georeference.crs).angles) {
    mesh.notes.push_back(angles_note(stated.crs));
  }
  if (options.crs.empty() || mesh.georeference.empty() || mesh.georeference == stated) {
    return;
  }
  const std::string note =
      fmt::format("the file declares {}, but the command line says {}, and is followed",
                  printable(describe(mesh.georeference)), printable(stated.crs));
  if (options.strict) {
    throw Error(ErrorKind::bad_file, path + ": " + note,
                fmt::format("leave --crs out if the file is right; if it is wrong, correct it "
                            "first: soms convert {} OUT.glb --crs {}",
                            path, printable(stated.crs)));
  }
  mesh.notes.push_back(note);
}

/// Follows the command line; a system of one unit gives it to a mesh that has none.
void state_georeference(Mesh& mesh, const ModelOptions& options) {
  if (options.crs.empty()) {
    return;
  }
  mesh.georeference = {.crs = crs_name(options.crs)};
  if (!(mesh.unit > 0)) {
    mesh.unit = crs_axes(mesh.georeference.crs).unit;
  }
}

}  // namespace

void check_statements(const MeshView& mesh, const ModelOptions& options, const std::string& path,
                      const Console& console) {
  if (options.lod || options.surfaces) {
    throw Error(ErrorKind::usage, printable(path) + ": a tree file has no levels of detail",
                "leave --lod and --surfaces out; soms build takes them");
  }
  if (mesh.triangles.empty() && !options.allow_empty) {
    throw Error(ErrorKind::empty_mesh, printable(path) + ": no triangles",
                options.offers_empty ? "give --allow-empty to accept that" : "give another model");
  }
  if (options.strict && !mesh.notes.empty()) {
    throw Error(ErrorKind::bad_file, printable(path) + ": " + printable(mesh.notes.front()),
                "correct the model, and build the file again: soms build --strict");
  }
  if (!options.lists_notes) {
    for (const std::string& note : notes_of({&mesh, 1})) {
      console.note(note);
    }
  }
}

void refuse_tiles(const std::string& path) {
  std::error_code unknown;
  if (is_tile_folder(path)) {
    throw Error(ErrorKind::usage,
                printable(path) + ": a folder of tiles, where whole surfaces are needed",
                "overlap, distance and within take tiles as B, closest and ray as MODEL; a part of "
                "them has to be a model here");
  }
  if (std::filesystem::is_regular_file(std::filesystem::path(path) / "source-000000.json",
                                       unknown) ||
      std::filesystem::is_regular_file(std::filesystem::path(path) / "tile-000000.somst",
                                       unknown)) {
    throw Error(ErrorKind::usage, printable(path) + ": a folder of tiles that is not complete",
                "the command soms tile that was ended goes on if it is given again");
  }
}

Mesh read_model(const std::string& path, const ModelOptions& options, const Console& console) {
  if (path.empty()) {
    throw Error(ErrorKind::usage, "the name of a model is empty", "give the name of a file");
  }
  const ReadOptions read{.allow_empty = options.allow_empty,
                         .max_memory = console.shared().max_memory,
                         .strict = options.strict,
                         .lod = options.lod,
                         .surfaces = options.surfaces};
  refuse_tiles(path);
  const bool is_tree = is_tree_file(path);
  Mesh mesh = console.run("reading " + printable(path), [&](const Limits& limits) {
    try {
      if (is_tree) {
        return Mesh(open_shape(path, {}, limits).mesh());
      }
      return path == "-" ? read_standard_input(read, limits) : read_mesh(path, read, limits);
    } catch (const Error& error) {
      throw in_words_of_options(error, path, options, console.shared());
    }
  });
  if (is_tree) {
    check_statements(mesh, options, path, console);
  }
  note_axis(mesh, options, path);
  note_georeference(mesh, options, path);
  if (!options.lists_notes && !is_tree) {
    const MeshView one = mesh;
    for (const std::string& note : notes_of({&one, 1})) {
      console.note(note);
    }
  }
  if (options.scale != 1 || options.up != UpAxis::unknown) {
    mesh = transformed(std::move(mesh), options.scale, options.up);
  }
  state_georeference(mesh, options);
  return mesh;
}

Mesh read_only_model(const std::string& path, const ModelOptions& options, const Console& console) {
  Mesh mesh = read_model(path, options, console);
  if (options.parts) {
    mesh = options.parts->left(std::move(mesh));
    options.parts->finish(console);
  }
  return mesh;
}

std::vector<std::string> notes_of(std::span<const MeshView> meshes) {
  std::vector<std::string> notes;
  for (const MeshView& mesh : meshes) {
    for (const std::string& note : mesh.notes) {
      const std::string line = mesh.source + ": " + note;
      if (std::find(notes.begin(), notes.end(), line) == notes.end()) {
        notes.push_back(line);
      }
    }
  }
  return notes;
}

Shape build_shape(Mesh mesh, const ShapeOptions& options, const Console& console) {
  const std::string doing = "building the tree of " + printable(mesh.source);
  return console.run(doing,
                     [&](const Limits& limits) { return Shape(std::move(mesh), options, limits); });
}

std::string part_name(const MeshView& mesh, TriangleId i) {
  return part_named(mesh, part_of(mesh, i));
}

std::string part_named(const MeshView& mesh, std::uint32_t part) {
  return part == Part::kNoParent ? std::string() : mesh.parts[part].name;
}

}  // namespace soms::command

#include "apps/soms/models/info.h"

#include "soms/base/error.h"
#include "soms/geometry/closedness.h"
#include "soms/geometry/defects.h"
#include "soms/store/tree_file.h"
#include "soms/tiles/tile_set.h"
#include "soms/tree/rule/rules.h"
#include "soms/tree/shape.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/model/part_filter.h"
#include "apps/model/shapes.h"
#include "apps/output/json.h"
#include "apps/soms/models/info_closedness.h"
#include "apps/soms/models/info_defects.h"
#include "apps/soms/models/info_trees.h"
#include "apps/store/build_verb.h"
#include "apps/store/info_tiles.h"
#include "apps/store/tiles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>

namespace soms::command {

namespace {

/// All that is reported about a model.
struct ModelReport {
  std::string file;
  ExaminedMesh mesh;
  Defects defects;
  Closedness closedness;
  /// Of a shape by the default options, its mesh included; unless trees are left out.
  std::optional<std::size_t> bytes_ready = std::nullopt;
  std::vector<RuleReport> trees;
  std::optional<Shape> tree_file = std::nullopt;  ///< what was opened
};

/// Bytes of the model ready to query.
std::size_t measure_shape(const Mesh& mesh, const Console& console) {
  const std::shared_ptr<const Mesh> not_owned(std::shared_ptr<const Mesh>(), &mesh);
  return console
      .run(fmt::format("preparing {}", mesh.source),
           [&](const Limits& limits) { return Shape(not_owned, {}, limits); })
      .memory();
}

ModelReport examine(const std::string& file, const InfoOptions& options, const Console& console) {
  ModelReport report;
  report.file = file;
  ModelOptions model = options.model;
  model.lists_notes = true;
  static_cast<Mesh&>(report.mesh) = read_model(file, model, console);
  check(report.mesh);
  if (std::optional<PartsLeft> left = options.model.parts->left_of(report.mesh)) {
    drop_empty_parts(left->mesh);
    report.mesh = {std::move(left->mesh), FileNumbers(std::move(left->numbers)),
                   FileNumbers(std::move(left->vertices))};
  }
  if (file == options.files.back()) {
    options.model.parts->finish(console);
  }
  if (is_tree_file(file)) {
    report.tree_file =
        open_tree_file(file, options.verify ? TreeCheck::full : TreeCheck::sound, console);
  }
  report.defects =
      console.run("looking for defects of " + printable(file), [&](const Limits& limits) {
        return find_defects(report.mesh, {.places = options.places}, limits);
      });
  report.closedness =
      console.run("looking for edges of an odd number of triangles", [&](const Limits& limits) {
        return closedness(report.mesh, {.places = options.places, .connected = true, .parts = true},
                          limits);
      });
  if (!options.trees) {
    return report;
  }
  report.bytes_ready = measure_shape(report.mesh, console);
  for (const auto& row : rules()) {
    if (options.every_rule || row.rule == options.build.rule) {
      BuildOptions build = options.build;
      build.rule = row.rule;
      report.trees.push_back(measure_tree(report.mesh, without_idle(build), console));
    }
  }
  return report;
}

const char* axis_name(UpAxis up) {
  switch (up) {
    case UpAxis::x:
      return "x";
    case UpAxis::y:
      return "y";
    case UpAxis::z:
      return "z";
    case UpAxis::unknown:
      break;
  }
  return nullptr;
}

Json attributes_of(const Part& part) {
  Json attributes = Json::array();
  for (const Attribute& attribute : part.attributes) {
    attributes.push_back({{"name", attribute.name}, {"value", attribute.value}});
  }
  return attributes;
}

Json to_json(const ModelReport& report) {
  const ExaminedMesh& mesh = report.mesh;
  Json parts = Json::array();
  for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
    const Part& part = mesh.parts[i];
    const Json parent = part.parent == Part::kNoParent ? Json() : Json(part.parent);
    const std::string closed = describe_part(mesh, report.defects, i);
    const TriangleId first = part.count > 0 ? report.mesh.triangle_numbers(part.first) : part.first;
    parts.push_back(
        {{"name", part.name},
         {"parent", parent},
         {"id", part.id.empty() ? Json() : Json(part.id)},
         {"type", part.type.empty() ? Json() : Json(part.type)},
         {"attributes", attributes_of(part)},
         {"continues", part.continues == Part::kNoParent ? Json() : Json(part.continues)},
         {"first_triangle", first},
         {"triangles", part.count},
         {"closed", closed.empty() ? Json() : Json(closed == "closed")},
         {"first", first},
         {"count", part.count}});
  }
  Json trees = Json::array();
  for (const RuleReport& tree : report.trees) {
    trees.push_back(to_json(tree));
  }
  const char* const up = axis_name(mesh.up);
  const Json unit = mesh.unit == 0 ? Json() : Json(mesh.unit);
  const Json axis = up == nullptr ? Json() : Json(up);
  const Json memory = report.bytes_ready ? Json(*report.bytes_ready) : Json();
  Json json{{"schema", "soms.info/1"},
            {"file", report.file},
            {"triangles", mesh.triangles.size()},
            {"vertices", mesh.vertices.size()},
            {"bounds", json_box(bounds(mesh))},
            {"meters_per_unit", unit},
            {"up_axis", axis},
            {"georeference", georeference_json(mesh.georeference)},
            {"memory_bytes", memory},
            {"parts", parts},
            {"notes", mesh.notes},
            {"defects", defect_counts(report.defects)},
            {"places", defect_places(mesh, report.defects)},
            {"closedness", closedness_json(mesh, report.closedness)},
            {"trees", trees},
            // Names of version 0.1, for scripts that know them.
            {"unit", unit},
            {"up", axis},
            {"bytes_ready", memory}};
  if (report.tree_file) {
    json["tree_file"] = tree_file_json(report.file, *report.tree_file);
  }
  return json;
}

std::string describe(const Box& box, int digits) {
  if (box.empty()) {
    return "empty";
  }
  return fmt::format("{} to {}", point_in_text(box.lower, digits),
                     point_in_text(box.upper, digits));
}

std::string describe_parts(const ExaminedMesh& mesh, const Defects& defects) {
  constexpr std::size_t kShown = 8;
  if (mesh.parts.empty()) {
    return "none";
  }
  std::string text = with_commas(mesh.parts.size()) + ":";
  for (std::size_t i = 0; i < std::min(kShown, mesh.parts.size()); ++i) {
    const std::string closed = describe_part(mesh, defects, i);
    text += fmt::format("{} {} ({}{}{})", i == 0 ? "" : ",", name_or_number(mesh, i),
                        with_commas(mesh.parts[i].count), closed.empty() ? "" : ", ", closed);
  }
  return mesh.parts.size() > kShown ? text + ", ... (--json lists all)" : text;
}

/// What is reported about the model itself.
std::string describe_model(const ModelReport& report, const Terminal& terminal) {
  const ExaminedMesh& mesh = report.mesh;
  std::string text = terminal.paint(printable(report.mesh.source), Ink::heading) + "\n";
  const auto add_line = [&terminal](std::string& lines, const char* name,
                                    const std::string& value) {
    constexpr std::size_t kValues = 13;
    lines += wrap_words(fmt::format("  {:<11}{}", name, value), terminal.width, kValues) + "\n";
  };
  if (report.tree_file) {
    add_line(text, "tree file", describe_tree_file(report.file, *report.tree_file));
  }
  add_line(text, "triangles", with_commas(mesh.triangles.size()));
  add_line(text, "vertices", with_commas(mesh.vertices.size()));
  add_line(text, "bounds", describe(bounds(mesh), terminal.digits()));
  if (mesh.unit != 0) {
    add_line(text, "unit", readable(mesh.unit) + " m");
  }
  if (mesh.up != UpAxis::unknown) {
    add_line(text, "up axis", axis_name(mesh.up));
  }
  if (!mesh.georeference.empty()) {
    add_line(text, "georeference ", printable(describe(mesh.georeference)));
  }
  add_line(text, "parts", describe_parts(mesh, report.defects));
  add_line(text, "defects", describe_defects(report.defects));
  add_line(text, "inside", describe_closedness(report.closedness));
  if (report.defects.repeated_vertices != 0) {
    add_line(text, "joined", describe_joining(mesh, report.defects));
  }
  for (const std::string& note : mesh.notes) {
    add_line(text, "note", printable(note));
  }
  if (report.bytes_ready && !mesh.triangles.empty()) {
    add_line(text, "memory",
             fmt::format("{:.1f} bytes per triangle, ready to query",
                         static_cast<double>(*report.bytes_ready) /
                             static_cast<double>(mesh.triangles.size())));
  }
  return text;
}

void print(const ModelReport& report, const InfoOptions& options, Console& console) {
  if (console.shared().json) {
    console.print(json_line(to_json(report)));
  } else {
    // Lists of places are long: what sums the model up stands before them.
    console.print(describe_model(report, console.terminal()));
    console.print(describe_trees(report.trees, options.build.per_leaf));
    print_places(report.mesh, report.defects, console);
    print_odd_edges(report.mesh, report.closedness, report.defects.open_edges, console);
  }
  console.flush();
}

/// True if other files may still be reported after this error.
bool concerns_one_file(ErrorKind kind) {
  return kind != ErrorKind::cancelled && kind != ErrorKind::timed_out &&
         kind != ErrorKind::cannot_write && kind != ErrorKind::usage;
}

/// Tells about one file; returns the exit status of its error, or 0.
int tell(const std::string& file, const InfoOptions& options, Console& console) {
  const bool json = console.shared().json;
  try {
    if (is_tile_folder(file)) {
      refuse_of_tiles(file, {refused_parts(options.model)});
      print_tiles(file, options.model, options.verify, console);
      return 0;
    }
    const ModelReport report = examine(file, options, console);
    print(report, options, console);
    return 0;
  } catch (const Error& error) {
    if (!concerns_one_file(error.kind())) {
      throw;
    }
    if (json) {
      console.print(
          json_line({{"schema", "soms.info/1"},
                     {"file", file},
                     {"error", {{"kind", name(error.kind())}, {"message", error.what()}}}}));
    }
    console.flush();
    print_error("soms info", error.what());
    return exit_code(error.kind());
  }
}

std::size_t parse_places(const std::string& text) {
  if (text == "all") {
    return std::numeric_limits<std::size_t>::max();
  }
  if (text.empty() ||
      !std::all_of(text.begin(), text.end(), [](char c) { return '0' <= c && c <= '9'; })) {
    throw Error(ErrorKind::usage, "--list " + text, "give a whole number or all");
  }
  return parse_count("--list", text, 0, kMaxPrimitives);
}

/// Options of trees that change nothing are refused. Where trees are built by every rule, those
/// that some rules do not use are noted.
void check_trees(const Parser& parser, const InfoOptions& options, const Console& console) {
  const std::string given = given_of_trees(parser);
  if (!options.trees && !given.empty()) {
    throw Error(ErrorKind::usage, given + " has no effect: --no-trees builds no trees",
                "leave one of the two out");
  }
  if (!options.every_rule) {
    check_build(parser, options.build);
    return;
  }
  BuildOptions build = options.build;
  build.rule = Rule::soms;  // which uses them all
  check_build(parser, build);
  for (const RuleEntry& row : rules()) {
    build.rule = row.rule;
    if (const auto without = given_of(parser, idle_options(build)); !without.empty()) {
      console.note(parser.with_keys(
          fmt::format("rule {} does not use {}", row.kebab, fmt::join(without, ", "))));
    }
  }
}

}  // namespace

Action add_info(Parser& parser, Shared&) {
  const auto options = std::make_shared<InfoOptions>();
  parser.add_option("FILE", options->files, "models; - is standard input")->required();
  parser.add_flag_callback(
      "--no-trees", [options] { options->trees = false; },
      "do not build trees, which take the most time");
  parser
      .add_option_function(
          "--list", [options](const std::string& text) { options->places = parse_places(text); },
          fmt::format("list the first N locations of each kind of defect, or all ({})",
                      options->places))
      ->option_text("N");
  parser.add_flag(
      "--verify", options->verify,
      "of tree files and tiles: check every box, so that answers are exact whoever wrote them");
  add_model_options(parser, options->model, "--scale", "--up", "the models");
  add_city_options(parser, options->model, "", "the models");
  add_allow_empty(parser, options->model);
  add_part_filter(parser, options->model.parts, "the models");
  add_strict(parser, options->model.strict);
  add_tree_list(parser, options->build);
  parser.option("--rule")->purpose("splitting rule (every one)");
  parser.footer(
      "Builds a tree with every splitting rule, or only with that of --tree "
      "rule=NAME.\n\nExample:\n"
      "  soms generate knot --triangles 2000 -o knot.ply\n"
      "  soms info knot.ply");
  return [options, &parser](Console& console) {
    options->every_rule = parser.count("--rule") == 0;
    check_trees(parser, *options, console);
    return run_info(*options, console);
  };
}

int run_info(const InfoOptions& options, Console& console) {
  if (std::count(options.files.begin(), options.files.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  int status = 0;
  for (const std::string& file : options.files) {
    status = std::max(status, tell(file, options, console));
  }
  return status;
}

}  // namespace soms::command

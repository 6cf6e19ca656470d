#include "apps/soms/models/convert.h"

#include "apps/cli/console.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/model/part_filter.h"
#include "apps/output/json.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace soms::command {

Action add_convert(Parser& parser, Shared&) {
  const auto options = std::make_shared<ConvertOptions>();
  parser.add_option("IN", options->input, "model to read; - is standard input")->required();
  parser.add_option("OUT", options->output.path, "model to write; - is standard output")
      ->required();
  add_format(parser, options->output);
  add_model_options(parser, options->model, "--scale", "--up", "the model");
  add_city_options(parser, options->model, "", "the model");
  add_allow_empty(parser, options->model);
  add_part_filter(parser, options->model.parts, "the model");
  add_strict(parser, options->model.strict);
  parser.footer(
      "Triangles and vertices keep their order and coordinates. Binary STL, 3DS and GLB round\n"
      "to floats. 3DS holds objects of at most 65,535 triangles, split in order, with names of at "
      "most\n"
      "10 characters.\n\n"
      "Example:\n"
      "  soms generate sphere --triangles 800 -o ball.ply\n"
      "  soms convert ball.ply ball.obj --scale 2");
  return [options](Console& console) { return run_convert(*options, console); };
}

int run_convert(const ConvertOptions& options, Console& console) {
  check(options.output, console);
  const MeshFormat format = format_of(options.output);
  Mesh mesh = read_only_model(options.input, options.model, console);
  if (options.model.parts->is_given()) {
    drop_empty_parts(mesh);
  }
  write_model(mesh, options.output, console);
  note_losses(mesh, options.output, console);
  if (console.shared().json) {
    Json answer{{"schema", "soms.convert/1"},         {"from", options.input},
                {"file", options.output.path},        {"format", format_name(format)},
                {"triangles", mesh.triangles.size()}, {"vertices", mesh.vertices.size()}};
    add_georeference(answer, mesh.georeference);
    const MeshView one = mesh;
    if (const std::vector<std::string> notes = notes_of({&one, 1}); !notes.empty()) {
      answer["notes"] = notes;
    }
    console.print(json_line(answer));
  } else {
    console.note(
        fmt::format("{}: {}", options.output.path, counted(mesh.triangles.size(), "triangle")));
  }
  return 0;
}

}  // namespace soms::command

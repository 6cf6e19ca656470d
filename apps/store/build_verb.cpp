#include "apps/store/build_verb.h"

#include "soms/base/error.h"
#include "soms/base/text.h"
#include "soms/store/tree_file.h"
#include "soms/tree/rule/rules.h"

#include "apps/cli/console.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/model/georeference.h"
#include "apps/output/json.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace soms::command {

namespace {

constexpr std::string_view kExtension = ".somst";

bool is_compact(const Shape& shape) {
  return shape.layout_kind() == Layout::compact;
}

std::uint64_t size_of(const std::string& path) {
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return unknown ? 0 : static_cast<std::uint64_t>(bytes);
}

void check_output(const BuildVerbOptions& options) {
  const std::filesystem::path path(options.output);
  if (options.output.empty() || options.output == "-" || path.extension() != kExtension) {
    throw Error(ErrorKind::usage,
                fmt::format("-o {}: tree files end in {}", printable(options.output), kExtension),
                "name a file such as city.somst; soms convert writes models");
  }
  std::error_code ignored;
  if (std::filesystem::equivalent(options.input, path, ignored)) {
    throw Error(ErrorKind::usage, printable(options.output) + ": IN and -o are the same file",
                "give another name");
  }
}

}  // namespace

std::string describe_tree_file(const std::string& path, const Shape& shape) {
  const BuildOptions& build = shape.build_options();
  return fmt::format("{}: {}, {}; {}, rule {}, at most {} a leaf", printable(path),
                     counted(shape.mesh().triangles.size(), "triangle"),
                     readable_bytes(size_of(path)), is_compact(shape) ? "compact" : "wide",
                     entry(build.rule).kebab,
                     counted(static_cast<std::uint64_t>(build.per_leaf), "triangle"));
}

Json tree_file_json(const std::string& path, const Shape& shape) {
  const BuildOptions& build = shape.build_options();
  return {{"bytes", size_of(path)},
          {"hash", fmt::format("{:016x}", tree_file_hash(path))},
          {"layout", is_compact(shape) ? "compact" : "wide"},
          {"rule", entry(build.rule).kebab},
          {"levels", build.level},
          {"leaf", build.per_leaf}};
}

Action add_build(Parser& parser, Shared&) {
  const auto options = std::make_shared<BuildVerbOptions>();
  parser.add_option("IN", options->input, "model to read; - is standard input")->required();
  parser.add_option("-o", options->output, "tree file to write, such as city.somst")->required();
  parser.add_flag("--compact", options->compact, "a third of the size; queries take longer");
  add_model_options(parser, options->model, "--scale", "--up", "the model");
  add_city_options(parser, options->model, "", "the model");
  add_allow_empty(parser, options->model);
  add_strict(parser, options->model.strict);
  add_tree_list(parser, options->shape.build);
  parser.footer(
      "Every verb takes the tree file in place of the model. Processes that open it share its "
      "memory.\n\n"
      "Example:\n"
      "  soms generate city --triangles 20000 -o city.ply\n"
      "  soms generate car -o car.ply\n"
      "  soms build city.ply -o city.somst\n"
      "  soms overlap car.ply city.somst --any");
  return [options, &parser](Console& console) {
    check_build(parser, options->shape.build);
    options->shape.layout = options->compact ? Layout::compact : Layout::wide;
    return run_build(*options, console);
  };
}

int run_build(const BuildVerbOptions& options, Console& console) {
  check_output(options);
  const Shape shape =
      build_shape(read_model(options.input, options.model, console), options.shape, console);
  save(options.output, shape);
  if (console.shared().json) {
    Json answer{{"schema", "soms.build/1"},
                {"from", options.input},
                {"file", options.output},
                {"triangles", shape.mesh().triangles.size()},
                {"vertices", shape.mesh().vertices.size()},
                {"tree_file", tree_file_json(options.output, shape)}};
    add_georeference(answer, shape.mesh().georeference);
    if (const std::vector<std::string> notes = notes_of({&shape.mesh(), 1}); !notes.empty()) {
      answer["notes"] = notes;
    }
    console.print(json_line(answer));
  } else {
    console.note(describe_tree_file(options.output, shape));
  }
  return 0;
}

}  // namespace soms::command

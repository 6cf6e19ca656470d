#include "apps/store/tile_verb.h"

#include "soms/base/error.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/parser.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"
#include "apps/store/tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

namespace soms::command {

namespace {

void print_json(const TileVerbOptions& options, const TileSet& tiles, std::uint64_t cut,
                Console& console) {
  console.print(json_line({{"schema", "soms.tile/1"},
                           {"folder", options.output},
                           {"triangles", tiles.triangles()},
                           {"tiles", tiles.tiles().size()},
                           {"bytes", tiles.bytes()},
                           {"cut", cut},
                           {"sources", sources_json(tiles)}}));
}

/// Hours may be between the first model and the last one.
void check_inputs(const std::vector<std::string>& inputs) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    throw Error(ErrorKind::usage, "standard input is given twice", "give one of them as a file");
  }
  for (const std::string& input : inputs) {
    std::error_code unknown;
    if (input != "-" && !std::filesystem::exists(input, unknown)) {
      throw Error(ErrorKind::cannot_open, printable(input) + ": it is not there",
                  "check the name of the file");
    }
  }
}

}  // namespace

Action add_tile(Parser& parser, Shared&) {
  const auto options = std::make_shared<TileVerbOptions>();
  parser.add_option("MODELS", options->inputs, "models to cut, each read by itself")->required();
  parser.add_option("-o", options->output, "folder of the tiles")->option_text("DIR")->required();
  add_count(parser, "--most", options->cut.most, 1, kMaxPrimitives,
            "most triangles of a tile (1000000)");
  parser.add_flag("--compact", options->compact, "a third of the size; queries take longer");
  add_model_options(parser, options->model, "--scale", "--up", "the models");
  add_city_options(parser, options->model, "", "the models");
  add_strict(parser, options->model.strict);
  add_tree_list(parser, options->cut.shape.build);
  parser.footer(
      "overlap, distance, within, closest and ray take the folder in place of the model. Triangles "
      "are\nnumbered through all models in their order. The same command goes on where it "
      "ended.\n\n"
      "Example:\n"
      "  soms generate city --triangles 20000 -o city.ply\n"
      "  soms generate car -o car.ply\n"
      "  soms tile city.ply --most 5000 -o tiles\n"
      "  soms overlap car.ply tiles --any");
  return [options, &parser](Console& console) {
    check_build(parser, options->cut.shape.build);
    options->cut.shape.layout = options->compact ? Layout::compact : Layout::wide;
    return run_tile(*options, console);
  };
}

int run_tile(const TileVerbOptions& options, Console& console) {
  if (options.output.empty()) {
    throw Error(ErrorKind::usage, "-o: the name of the folder is empty",
                "give the name of a folder");
  }
  check_inputs(options.inputs);
  TileCutter cutter(options.output, options.cut);
  ModelOptions reading = options.model;
  reading.allow_empty = true;  // of many models some may be
  std::uint64_t cut = 0;
  for (const std::string& input : options.inputs) {
    const Mesh mesh = read_model(input, reading, console);
    const bool is_new = console.run("cutting " + printable(input),
                                    [&](const Limits& limits) { return cutter.add(mesh, limits); });
    cut += is_new ? 1 : 0;
    if (!is_new) {
      console.note(printable(input) + ": its tiles are there and whole");
    }
  }
  cutter.finish();
  const TileSet tiles = TileSet::open(options.output);
  if (console.shared().json) {
    print_json(options, tiles, cut, console);
  } else {
    console.note(describe_tiles(options.output, tiles));
  }
  return 0;
}

}  // namespace soms::command

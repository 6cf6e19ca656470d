#include "apps/world/world_options.h"

#include "apps/cli/parse.h"
#include "apps/model/part_filter.h"

namespace soms::command {

namespace {

constexpr std::uint64_t kMostMovers = 1'000'000;

}  // namespace

void add_world_options(Parser& parser, WorldOptions& options) {
  parser
      .add_option("CITY", options.cities,
                  "static models, in one coordinate frame; - is standard input")
      ->option_text("FILE...");
  add_repeatable(parser, "--mover", options.movers, "moving model; may be repeated", "FILE");
  add_repeatable(parser, "--route", options.routes,
                 "route, a CSV file of points or poses; may be repeated; - is standard input",
                 "FILE");
  add_model_options(parser, options.city_model, "--scale", "--up", "the city");
  add_model_options(parser, options.mover_model, "--mover-scale", "--mover-up", "the movers");
  parser
      .add_flag_callback(
          "--strict", [&options] { options.city_model.strict = options.mover_model.strict = true; },
          kStrictMeaning)
      ->group("Models");
  add_part_filter(parser, options.city_model.parts, "the city");
  parser
      .add_option_function(
          "--count",
          [&options](const std::string& value) {
            options.count = parse_count("--count", value, 0, kMostMovers);
          },
          "number of movers (1000; one per route with --route)")
      ->option_text("N");
}

}  // namespace soms::command

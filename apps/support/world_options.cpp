#include "apps/support/world_options.h"

#include "apps/support/parse.h"

namespace soms::command {

namespace {

constexpr std::uint64_t kMostMovers = 1'000'000;

}  // namespace

void add_world_options(CLI::App& app, WorldOptions& options) {
  app.add_option("CITY", options.cities,
                 "static models, in one coordinate frame; - is standard input")
      ->option_text("FILE...");
  add_repeatable(app, "--mover", options.movers, "moving model; may be repeated", "FILE");
  add_repeatable(app, "--route", options.routes,
                 "route, a CSV file of points or poses; may be repeated; - is standard input",
                 "FILE");
  add_model_options(app, options.city_model, "--scale", "--up", "the city");
  add_model_options(app, options.mover_model, "--mover-scale", "--mover-up", "the movers");
  app.add_flag_callback(
         "--strict", [&options] { options.city_model.strict = options.mover_model.strict = true; },
         kStrictMeaning)
      ->group("Models");
  app.add_option_function<std::string>(
         "--count",
         [&options](const std::string& value) {
           options.count = parse_count("--count", value, 0, kMostMovers);
         },
         "number of movers (1000; one per route with --route)")
      ->option_text("N");
}

void add_world_tree_options(CLI::App& app, WorldOptions& options) {
  add_build_options(app, options.build);
  add_traversal_options(app, options.traversal);
}

}  // namespace soms::command

#include "apps/soms/models/generate.h"

#include "soms/base/error.h"
#include "soms/generate/city.h"
#include "soms/generate/shapes.h"
#include "soms/generate/statue.h"
#include "soms/generate/teapot.h"
#include "soms/generate/urban.h"
#include "soms/io/formats.h"

#include "apps/cli/console.h"
#include "apps/cli/parse.h"
#include "apps/cli/text.h"
#include "apps/output/json.h"

#include <fmt/format.h>

#include <array>
#include <memory>

namespace soms::command {

namespace {

constexpr std::uint64_t kShapeTriangles = 10'000;
constexpr std::uint64_t kStatueTriangles = 948;  // as many as the bunny of the thesis
constexpr std::uint32_t kTeapotSubdivisions = 10;

std::uint64_t or_default(std::uint64_t triangles, std::uint64_t standard) {
  return triangles == 0 ? standard : triangles;
}

Mesh make_knot(const GenerateWish& wish, const Limits&) {
  return generate_knot(or_default(wish.triangles, kShapeTriangles));
}

Mesh make_sphere(const GenerateWish& wish, const Limits&) {
  return generate_sphere(or_default(wish.triangles, kShapeTriangles));
}

Mesh make_statue(const GenerateWish& wish, const Limits&) {
  return generate_statue(or_default(wish.triangles, kStatueTriangles));
}

Mesh make_teapot(const GenerateWish& wish, const Limits&) {
  const std::uint64_t triangles = wish.triangles;
  if (triangles == 0) {
    return generate_teapot(kTeapotSubdivisions);
  }
  std::uint32_t n = kLeastTeapotSubdivisions;
  while (n < kMostTeapotSubdivisions && teapot_triangles(n) < triangles) {
    ++n;
  }
  const std::uint64_t found = teapot_triangles(n);
  if (found == triangles) {
    return generate_teapot(n);
  }
  const bool between = n > kLeastTeapotSubdivisions && triangles < found;
  throw Error(ErrorKind::usage,
              fmt::format("a teapot has 64 n^2 - 8 n triangles, n from {} to {}",
                          kLeastTeapotSubdivisions, kMostTeapotSubdivisions),
              between ? fmt::format("use {} or {}", teapot_triangles(n - 1), found)
                      : fmt::format("use {}", found));
}

Mesh make_city(const GenerateWish& wish, const Limits& limits) {
  CityOptions options;
  options.triangles = or_default(wish.triangles, options.triangles);
  options.seed = wish.seed;
  options.size = wish.extent == 0 ? city_size(options.triangles) : wish.extent;
  options.streets = wish.streets.value_or(CityStreets::paved);
  return generate_city(options, limits).mesh;
}

template <MoverKind kind>
Mesh make_mover(const GenerateWish& wish, const Limits&) {
  return generate_mover(kind, wish.triangles);
}

template <UrbanScene scene>
Mesh make_urban(const GenerateWish& wish, const Limits&) {
  Mesh mesh = generate_urban(scene);
  if (wish.triangles != 0 && wish.triangles != mesh.triangles.size()) {
    throw Error(ErrorKind::usage,
                fmt::format("--triangles {}: this scene has {} triangles", wish.triangles,
                            mesh.triangles.size()),
                "leave it out");
  }
  return mesh;
}

constexpr std::array kKinds{
    GenerateKind{"knot", "a torus knot, closed", make_knot},
    GenerateKind{"sphere", "a sphere of radius 1, closed", make_sphere},
    GenerateKind{"statue", "a bust on a plinth, closed, with triangles of very different sizes",
                 make_statue},
    GenerateKind{"teapot", "Newell's teapot; 64 n^2 - 8 n triangles, not closed", make_teapot},
    GenerateKind{"city", "hills, streets and buildings; the more triangles, the larger", make_city},
    GenerateKind{"car", "a plain car, closed", make_mover<MoverKind::car>},
    GenerateKind{"sedan", "a car with arches over round wheels, closed",
                 make_mover<MoverKind::sedan>},
    GenerateKind{"van", "a van, closed", make_mover<MoverKind::van>},
    GenerateKind{"person", "a person, closed", make_mover<MoverKind::person>},
    GenerateKind{"drone", "a drone, closed", make_mover<MoverKind::drone>},
    GenerateKind{"urban-mixed", "5,672 triangles: terrain, long roads, buildings, signs",
                 make_urban<UrbanScene::mixed>},
    GenerateKind{"urban-boxes", "5,672 triangles: four blocks of boxes",
                 make_urban<UrbanScene::boxes>},
    GenerateKind{"urban-plain", "5,672 triangles: boxes, none of them large",
                 make_urban<UrbanScene::plain>},
};

std::string help_of_kinds() {
  std::string text = "Kinds:\n";
  for (const GenerateKind& kind : kKinds) {
    text += fmt::format("  {:<28}{}\n", kind.name, kind.text);
  }
  return text;
}

void add_city_options(Parser& parser, GenerateWish& wish) {
  add_positive(
      parser, "--extent", wish.extent,
      "side of a city's square in meters (default: 3 square meters a triangle, at least 200)");
  Choices<CityStreets> choices;
  for (const auto& [word, streets] :
       {std::pair("paved", CityStreets::paved), std::pair("bare", CityStreets::bare)}) {
    choices.emplace_back(word, streets);
  }
  add_choice(parser, "--streets", wish.streets, choices,
             "of a city, with sidewalks and lane marks or without");
}

/// Throws for an option that this kind does not have.
void check_kind(const GenerateOptions& options) {
  if ((options.wish.extent > 0 || options.wish.streets) && options.kind->make != make_city) {
    throw Error(ErrorKind::usage,
                fmt::format("--extent and --streets are of a city, not of {}", options.kind->name),
                "leave them out");
  }
}

}  // namespace

std::span<const GenerateKind> generate_kinds() {
  return kKinds;
}

Action add_generate(Parser& parser, Shared&) {
  const auto options = std::make_shared<GenerateOptions>();
  parser
      .add_option_function(
          "KIND",
          [options](const std::string& word) {
            Choices<const GenerateKind*> choices;
            for (const GenerateKind& kind : kKinds) {
              choices.emplace_back(kind.name, &kind);
            }
            options->kind = parse_choice("KIND", word, choices);
          },
          "kind of model; see below")
      ->required();
  add_count(parser, "--triangles", options->wish.triangles, 1, kMaxPrimitives,
            "exact number of triangles");
  add_city_options(parser, options->wish);
  parser
      .add_option("-o,--output", options->output.path,
                  fmt::format("file to write: {}; - is standard output", writable_extensions()))
      ->required()
      ->option_text("FILE");
  add_format(parser, options->output);
  parser.footer(help_of_kinds() +
                "\nThe same options and --seed give the same bytes on every machine.\n"
                "The embedded city is that of --extent 4000 --streets bare.\n\nExample:\n"
                "  soms generate city --triangles 20000 --seed 7 -o city.ply");
  return [options](Console& console) { return run_generate(*options, console); };
}

int run_generate(const GenerateOptions& options, Console& console) {
  check(options.output, console);
  check_kind(options);
  const MeshFormat format = format_of(options.output);
  GenerateWish wish = options.wish;
  wish.seed = console.shared().seed;
  Mesh mesh;
  try {
    mesh = console.run("making " + std::string(options.kind->name),
                       [&](const Limits& limits) { return options.kind->make(wish, limits); });
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled || error.kind() == ErrorKind::timed_out) {
      throw;
    }
    const std::string place = error.kind() == ErrorKind::usage && wish.triangles != 0
                                  ? fmt::format("--triangles {}", wish.triangles)
                                  : std::string(options.kind->name);
    throw Error(error.kind(), fmt::format("{}: {}", place, error.place()), error.remedy());
  }
  write_model(mesh, options.output, console);
  if (console.shared().json) {
    console.print(json_line({{"schema", "soms.generate/1"},
                             {"kind", options.kind->name},
                             {"file", options.output.path},
                             {"format", format_name(format)},
                             {"triangles", mesh.triangles.size()},
                             {"vertices", mesh.vertices.size()},
                             {"seed", wish.seed}}));
  } else {
    console.note(
        fmt::format("{}: {}", options.output.path, counted(mesh.triangles.size(), "triangle")));
  }
  return 0;
}

}  // namespace soms::command
